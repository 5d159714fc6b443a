// grafwire netlist: the netlist of a GRAFCET in one of the formats, with a bench if one is asked
// for.

#include <filesystem>

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/option_uses.h"
#include "workflow/heads.h"

namespace grafwire {

namespace {

namespace help = messages::help;

/// What may be written after `grafwire netlist`.
struct NetlistArguments {
    std::string path;
    NetlistRequest netlist;
    std::string format;
    std::string stimuli;
    bool bench = false;
    std::string scan = "10ms";
    std::string output;
};

/// What is known of the request before anything is read.
unsigned facts_of(const NetlistArguments& request, const NetlistFormat& format) {
    unsigned facts =
        request.netlist.options().style == Style::clocked ? fact::clocked : fact::asynchronous;
    if (!request.stimuli.empty()) facts |= fact::stimuli;
    // A deck is a bench itself: it needs no asking, and no file beside it.
    const bool has_own_bench = format.write_bench != nullptr;
    if (request.bench || !has_own_bench) facts |= fact::bench;
    if (!has_own_bench || (!request.output.empty() && request.output != "-")) {
        facts |= fact::output;
    }
    return facts;
}

/// `OUT_bench.v` for `OUT.v`.
std::string bench_path(const std::string& output) {
    const std::filesystem::path path(output);
    return (path.parent_path() / (path.stem().string() + "_bench" + path.extension().string()))
        .string();
}

/// The netlist and, of formats that have one, its bench.
ExitStatus write(const NetlistArguments& request, const NetlistFormat& format, Time period) {
    // Read the GRAFCET and make the netlist.
    const auto chart = load_chart(request.path);
    if (!chart) return ExitStatus::bad_request;
    const auto netlist = make_netlist(*chart, request.netlist);
    if (!netlist) return ExitStatus::bad_request;
    std::optional<Stimuli> stimuli;
    if (!request.stimuli.empty()) {
        stimuli = load_stimuli(request.stimuli, chart->grafcet);
        if (!stimuli) return ExitStatus::bad_request;
    }
    // Write it.
    WrittenNetlist written = write_netlist(
        *chart, *netlist, format, stimuli ? &*stimuli : nullptr, period, request.netlist.delays(),
        netlist_heads(*chart, request.netlist.options(), format,
                      {period, request.stimuli, request.output}, request.bench));
    OutputFiles files({request.path, request.stimuli});
    files.add(request.output, std::move(written.text));
    if (!written.bench.empty()) files.add(bench_path(request.output), std::move(written.bench));
    return finish(files, ExitStatus::done);
}

}  // namespace

Task declare_netlist(const CommandLine& line) {
    const auto request = std::make_shared<NetlistArguments>();
    line.add_argument(help::file_name, request->path, help::file());
    request->netlist.declare(line, true);
    line.add("--to", request->format, with_rows(help::netlist_to(), netlist_formats())).required();
    line.add("--stim", request->stimuli, help::netlist_stim());
    line.add_flag("--bench", request->bench, help::bench());
    line.add("--scan", request->scan, help::netlist_scan()).shows_default();
    line.add("-o", request->output, help::output());
    return [request, line] {
        const NetlistFormat* format = format_named(netlist_formats(), request->format);
        if (format == nullptr) return ExitStatus::bad_request;
        const ChosenFormat chosen = chosen_format(netlist_formats(), *format);
        if (refuse_idle_options(line, "netlist", facts_of(*request, *format), &chosen)) {
            return ExitStatus::bad_request;
        }
        const Period period = parse_period(request->scan);
        if (!period.value || share_standard_input(request->path, request->stimuli)) {
            return ExitStatus::bad_request;
        }
        return write(*request, *format, *period.value);
    };
}

}  // namespace grafwire
