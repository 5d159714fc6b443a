// grafwire netlist: the netlist of a GRAFCET in one of the formats, with a bench if one is asked
// for; or its schematic, with the values of a moment if they are.

#include <filesystem>

#include "command/chart_results.h"
#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "command/option_uses.h"
#include "workflow/heads.h"
#include "workflow/schematics.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

/// What may be written after `grafwire netlist`.
struct NetlistArguments {
    std::vector<std::string> files;
    NetlistRequest netlist;
    std::string format;
    std::string stimuli;
    bool bench = false;
    std::string scan = "10ms";
    std::string at;
    std::string symbols = "iec";
    std::string paper = "a4";
    bool standalone = false;
    std::string output;
};

/// What is known of the request before anything is read.
unsigned facts_of(const NetlistArguments& request, const NetlistTarget& target) {
    unsigned facts =
        request.netlist.options().style == Style::clocked ? fact::clocked : fact::asynchronous;
    if (request.netlist.is_handshake()) facts |= fact::handshake;
    if (!request.stimuli.empty()) facts |= fact::stimuli;
    if (!request.at.empty()) facts |= fact::moment;
    if (target.format == nullptr) return facts | fact::drawing;
    facts |= fact::text;
    const NetlistFormat& format = *target.format;
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

/// The chart, with interlocks if they are asked for, and its netlist.
struct WiredChart {
    Chart chart;
    Netlist netlist;
    std::vector<std::string> interlocks;  ///< as of ChartToWire
};
std::optional<WiredChart> load_wired(const NetlistArguments& request, const ChartFile& file,
                                     const CommandLine& line) {
    auto read = load_chart(file, line);
    if (!read) return std::nullopt;
    ChartToWire to_be_wired = to_wire(std::move(*read), request.netlist);
    auto netlist = make_netlist(to_be_wired.chart, request.netlist);
    if (!netlist) return std::nullopt;
    warn_of_order(to_be_wired.chart, request.netlist);
    return WiredChart{std::move(to_be_wired.chart), std::move(*netlist),
                      std::move(to_be_wired.interlocks)};
}

/// The netlist and, of formats that have one, its bench.
ExitStatus add_text(const NetlistArguments& request, const NetlistFormat& format, Time period,
                    const CommandLine& line, const ChartFiles& charts, std::size_t number,
                    ChartResults& results) {
    // Read the GRAFCET and make the netlist.
    const auto wired = load_wired(request, charts.files[number], line);
    if (!wired) return ExitStatus::bad_request;
    const auto& [chart, netlist, interlocks] = *wired;
    std::optional<Stimuli> stimuli;
    if (!request.stimuli.empty()) {
        stimuli = load_stimuli(request.stimuli, chart.grafcet);
        if (!stimuli) return ExitStatus::bad_request;
    }
    // Write it.
    const std::string place = results.place_of(number);
    WrittenNetlist written = write_netlist(
        chart, netlist, format, stimuli ? &*stimuli : nullptr, period, request.netlist.delays(),
        netlist_heads(chart, request.netlist.options(), format,
                      {period, request.stimuli, place, interlocks}, request.bench));
    results.add(number, std::move(written.text));
    if (!written.bench.empty()) results.add_beside(bench_path(place), std::move(written.bench));
    return ExitStatus::done;
}

// ---- Schematics

/// The values that `--at` asks for; empty where none are asked for, none, and shown, where there
/// are none.
std::optional<std::vector<Logic>> values_of(const NetlistArguments& request, const Chart& chart,
                                            const Netlist& netlist) {
    if (request.at.empty()) return std::vector<Logic>{};
    const std::optional<Time> at = parse_moment(request.at);
    if (!at) return std::nullopt;
    const auto stimuli = load_stimuli(request.stimuli, chart.grafcet);
    if (!stimuli) return std::nullopt;
    auto values = net_values_at(chart, netlist, *stimuli, *at, request.netlist.delays());
    if (!values) complain(say::no_values_at(request.at));
    return values;
}

ExitStatus add_drawing(const NetlistArguments& request, const DrawingFormat& format,
                       const CommandLine& line, const ChartFiles& charts, std::size_t number,
                       ChartResults& results) {
    const auto wired = load_wired(request, charts.files[number], line);
    if (!wired) return ExitStatus::bad_request;
    const auto& [chart, netlist, interlocks] = *wired;
    auto values = values_of(request, chart, netlist);
    if (!values) return ExitStatus::bad_request;
    SchematicDrawing how;
    how.shapes = row_named(gate_shapes_table, request.symbols)->shapes;
    how.paper = *row_named(papers, request.paper);
    how.language = line.language();
    how.values = std::move(*values);
    how.title = schematic_title(chart, request.netlist.options().style,
                                request.at.empty() ? std::nullopt : parse_moment(request.at),
                                line.language());
    results.add(number, schematic_drawing(netlist, how, format, request.standalone));
    return ExitStatus::done;
}

/// All that is asked for, of every chart.
ExitStatus write(const NetlistArguments& request, const NetlistTarget& target, Time period,
                 const CommandLine& line) {
    const ChartFiles charts = find_chart_files(request.files);
    const auto extension =
        target.format != nullptr ? target.format->extension : target.drawing->extension;
    auto results = ChartResults::planned(charts, request.output, {extension}, {request.stimuli});
    if (!results) return ExitStatus::bad_request;
    const ExitStatus status = for_each_chart(charts, [&](std::size_t i) {
        return target.drawing != nullptr
                   ? add_drawing(request, *target.drawing, line, charts, i, *results)
                   : add_text(request, *target.format, period, line, charts, i, *results);
    });
    return results->finish(status);
}

}  // namespace

Task declare_netlist(const CommandLine& line) {
    const auto request = std::make_shared<NetlistArguments>();
    line.add_arguments(help::file_name, request->files, help::files()).names_file({".grafcet"});
    request->netlist.declare(line, true);
    line.add("--to", request->format, with_rows(help::netlist_to(), netlist_targets()))
        .names_row(netlist_targets())
        .required();
    line.add("--stim", request->stimuli, help::netlist_stim()).names_file({".stim"});
    line.add_flag("--bench", request->bench, help::bench());
    line.add("--scan", request->scan, help::netlist_scan()).shows_default();
    line.add("--at", request->at, help::netlist_at());
    line.add("--symbols", request->symbols, help::symbols())
        .one_of_names(gate_shapes_table)
        .shows_default();
    line.add("--paper", request->paper, help::netlist_paper()).one_of_names(papers).shows_default();
    line.add_flag("--standalone", request->standalone, help::standalone());
    line.add("-o", request->output, help::outputs()).names_file({});
    line.add_strict();
    return [request, line] {
        const NetlistTarget* target = format_named(netlist_targets(), request->format);
        if (target == nullptr) return ExitStatus::bad_request;
        const ChosenFormat chosen = chosen_format(netlist_targets(), *target);
        if (refuse_idle_options(line, "netlist", facts_of(*request, *target), &chosen)) {
            return ExitStatus::bad_request;
        }
        const Period period = parse_period(request->scan);
        if (!period.value || share_standard_input(request->files, request->stimuli)) {
            return ExitStatus::bad_request;
        }
        return write(*request, *target, *period.value, line);
    };
}

}  // namespace grafwire
