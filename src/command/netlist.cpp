#include <fmt/format.h>

#include "command/command.h"
#include "command/exit_status.h"
#include "command/netlist_request.h"
#include "evolution/run.h"
#include "formats/exporters.h"

namespace grafwire {

namespace {

struct Request {
    std::string path;
    NetlistRequest netlist;
    std::string format;
    std::string stimuli;
    std::string scan = "10ms";
    std::string output;
};

const Exporter* find_exporter(const std::string& name) {
    if (const Exporter* exporter = exporter_named(name)) return exporter;
    std::string message = fmt::format("there is no format '{}'", name);
    const auto nearest = nearest_name(name, exporter_names());
    if (!nearest.empty()) message += fmt::format("; did you mean '{}'?", nearest);
    complain(message);
    return nullptr;
}

/// The bench that applies the stimuli; it looks at the outputs at the instants of the reference, or
/// at its scans where there is a clock.
Bench bench_for(const Grafcet& grafcet, const Netlist& netlist, const Stimuli& stimuli,
                Time period) {
    const RunResult run = netlist.is_clocked() ? run_scans(grafcet, stimuli, period)
                                               : run_until_stable(grafcet, stimuli);
    return bench_from(netlist, stimuli, run.trace.times);
}

}  // namespace

std::function<int()> declare_netlist(const CommandLine& line, const Language&) {
    const auto request = std::make_shared<Request>();
    line.add("FILE", request->path, "the GRAFCET, - for standard input").required();
    request->netlist.declare(line, true);
    line.add("--to", request->format,
             fmt::format("output format: {}", fmt::join(exporter_names(), ", ")))
        .required();
    line.add("--stim", request->stimuli,
             "stimuli to hold in the file as well (formats with a test bench)");
    line.add("--scan", request->scan, "scan period that clocked timers count with").shows_default();
    line.add("-o", request->output, "output file (default: standard output)");
    return [request] {
        // Read the request.
        const Exporter* exporter = find_exporter(request->format);
        const auto period = parse_period(request->scan);
        if (exporter == nullptr || !period ||
            share_standard_input(request->path, request->stimuli)) {
            return static_cast<int>(bad_request);
        }
        // Read the GRAFCET and make the netlist.
        const auto loaded = load_grafcet(request->path);
        if (!loaded) return static_cast<int>(bad_request);
        const auto netlist = make_netlist(*loaded, request->netlist);
        if (!netlist) return static_cast<int>(bad_request);
        ExportOptions options{*period, nullptr};
        Bench bench;
        if (!request->stimuli.empty()) {
            const auto stimuli = load_stimuli(request->stimuli, loaded->grafcet);
            if (!stimuli) return static_cast<int>(bad_request);
            bench = bench_for(loaded->grafcet, *netlist, *stimuli, *period);
            options.bench = &bench;
        }
        // Write it.
        Diagnostics diagnostics;
        std::string text = exporter->write(*netlist, options, diagnostics);
        if (diagnostics.has_errors()) {
            for (const Diagnostic& item : diagnostics.items()) complain(item.message);
            return static_cast<int>(bad_request);
        }
        OutputFiles files({request->path, request->stimuli});
        files.add(request->output, std::move(text));
        return finish(files, done);
    };
}

}  // namespace grafwire
