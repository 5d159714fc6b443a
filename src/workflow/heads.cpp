// The heads of files that others will read. A request is spelled with every option that the result
// depends on, so that it holds when a default changes.

#include "workflow/heads.h"

#include <fmt/format.h>

#include <algorithm>

#include "text/utf8.h"
#include "text/version.h"
#include "text/words.h"
#include "workflow/messages.h"
#include "workflow/programs.h"

namespace grafwire {

namespace {

namespace say = messages::workflow;

constexpr std::string_view standard_input = "<stdin>";

/// `chart.grafcet` of `/home/me/chart.grafcet`.
std::string file_name_of(std::string_view path) {
    return visible(path.substr(path.find_last_of('/') + 1));
}

/// A name of a file as a word of a shell.
std::string shell_word(std::string_view path) {
    if (path == standard_input) return "-";
    std::string name = file_name_of(path);
    const bool is_plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return is_ascii_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80 ||
               std::string_view("._+-").find(c) != std::string_view::npos;
    });
    if (is_plain && name.front() != '-') return name;
    for (std::size_t at = 0; (at = name.find('\'', at)) != std::string::npos; at += 4) {
        name.replace(at, 1, "'\\''");
    }
    return "'" + name + "'";
}

std::string_view name_of(Style style) {
    return style_table[static_cast<std::size_t>(style)].name;
}

std::string_view on_or_off(bool value) {
    return value ? "on" : "off";
}

/// `lift "A lift" (lift.grafcet)`, as far as there is that.
std::string title_of(const Chart& chart) {
    std::string title = visible(chart.grafcet.name);
    if (!chart.grafcet.title.empty()) {
        title += fmt::format(" \"{}\"", visible(chart.grafcet.title));
    }
    if (!chart.source.name.empty() && chart.source.name != standard_input) {
        title += fmt::format(" ({})", file_name_of(chart.source.name));
    }
    return title;
}

std::string netlist_request(const Chart& chart, const NetlistOptions& options,
                            const NetlistFormat& format, const NetlistFileRequest& request) {
    std::string line = fmt::format(
        "grafwire netlist {} --style {} --cdx {} --modes {} --to {}", shell_word(chart.source.name),
        name_of(options.style), name_of(cdx_form(options)), on_or_off(options.modes), format.name);
    const bool is_scanned = options.style == Style::clocked && has_word(format.options, "--scan");
    if (is_scanned) line += " --scan " + format_duration(request.scan_period);
    if (!request.interlocks.empty()) line += " --interlock";
    if (!request.stimuli.empty()) line += " --stim " + shell_word(request.stimuli);
    if (!request.bench_beside.empty()) {
        line += " --bench -o " + shell_word(request.bench_beside);
    }
    return line;
}

std::vector<std::string> netlist_head(const Chart& chart, const NetlistOptions& options,
                                      const NetlistFormat& format,
                                      const NetlistFileRequest& request) {
    std::vector<std::string> head{
        title_of(chart),
        fmt::format("Style {}, CDX by {}, {}.", name_of(options.style),
                    cdx_form(options) == CdxForm::successor ? "successor steps" : "transitions",
                    options.modes ? "with Init, AUdur and AUdoux" : "without modes"),
        fmt::format("Written by grafwire {}:", version()),
        "  " + netlist_request(chart, options, format, request)};
    if (request.interlocks.empty()) return head;
    head.push_back("The chart has got these interlocks:");
    for (const std::string& interlock : request.interlocks) head.push_back("  " + interlock);
    return head;
}

}  // namespace

NetlistHeads netlist_heads(const Chart& chart, const NetlistOptions& options,
                           const NetlistFormat& format, const NetlistFileRequest& request,
                           bool with_bench) {
    const Time period = request.scan_period;
    if (!with_bench || format.write_bench == nullptr) {
        return {
            netlist_head(chart, options, format, {period, request.stimuli, {}, request.interlocks}),
            {}};
    }
    return {netlist_head(chart, options, format, {period, {}, {}, request.interlocks}),
            netlist_head(chart, options, format, request)};
}

std::string program_head(const Chart& chart, const PlcFormat& format, const PlcOptions& options,
                         bool modes, std::string_view io) {
    std::string line = fmt::format("grafwire plc {} --to {} --modes {}",
                                   shell_word(chart.source.name), format.name, on_or_off(modes));
    const auto heeds = [&](std::string_view option) { return has_word(format.options, option); };
    if (heeds("--io") && !io.empty()) line += " --io " + shell_word(io);
    if (heeds("--mnemonics")) {
        const bool is_simatic = options.mnemonics == s7::Mnemonics::simatic;
        line += fmt::format(" --mnemonics {}", is_simatic ? "simatic" : "iec");
    }
    if (heeds("--offsets")) line += fmt::format(" --offsets {}", on_or_off(options.offsets));
    if (heeds("--tables")) {
        line += fmt::format(" --tables {}", options.wide_tables ? "wide" : "standard");
    }
    if (heeds("--cpu") && options.cpu) line += fmt::format(" --cpu {}", number_of(*options.cpu));
    if (heeds("--pull-up") && options.pull_up) line += " --pull-up";
    line += options.language == Language::french ? " --lang fr" : " --lang en";
    return say::written_by.in(options.language, version(), line);
}

}  // namespace grafwire
