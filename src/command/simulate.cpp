#include "simulate/simulate.h"

#include <fmt/format.h>

#include "check/compare_ports.h"
#include "command/command.h"
#include "command/exit_status.h"
#include "command/netlist_request.h"
#include "command/trace_output.h"
#include "evolution/run.h"

namespace grafwire {

namespace {

struct Request {
    std::string path;
    std::string stimuli;
    NetlistRequest netlist;
    std::string against;
    std::string power_up;  ///< empty: unknown
    std::string delay = "unit";
    std::string scan;
    TraceOutput output;
};

std::string oscillation_text(const Netlist& netlist, const std::vector<NetId>& nets) {
    constexpr std::size_t most = 12;
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    std::vector<std::string> names;
    for (const NetId net : nets) {
        if (drivers[net] != no_cell) names.push_back(cell_description(netlist, drivers[net]));
    }
    const bool cut = names.size() > most;
    if (cut) names.resize(most);
    return fmt::format("{}{}", fmt::join(names, ", "), cut ? ", …" : "");
}

int simulate_netlist(const Request& request, const LoadedGrafcet& loaded, const Stimuli& stimuli,
                     const Netlist& netlist, Language language) {
    SimulateOptions options;
    options.waveform = !request.output.vcd.empty();
    if (!request.scan.empty()) {
        const auto period = parse_period(request.scan);
        if (!period) return bad_request;
        if (!netlist.is_clocked()) {
            complain("--scan is for the clocked style: the others have no scans");
            return bad_request;
        }
        options.scan_period = *period;
    }
    // Let the gates work.
    const SimulateResult result =
        simulate(loaded.grafcet, netlist, unit_delays(netlist), stimuli, options);
    // Write the trace, up to the instant at which they do not settle if there is one.
    if (result.unsettled_at) {
        complain(fmt::format(fmt::runtime(language == Language::french
                                              ? "le câblage ne se stabilise pas à {} ms ; changent "
                                                "sans cesse : {}"
                                              : "the netlist does not settle at {} ms; these keep "
                                                "changing: {}"),
                             format_milliseconds(*result.unsettled_at),
                             oscillation_text(netlist, result.oscillating)));
    }
    OutputFiles files({request.path, request.stimuli, request.against});
    request.output.add_files(files, result.trace, result.waveform);
    return finish(files, result.unsettled_at ? answer_is_no : done);
}

}  // namespace

std::function<int()> declare_simulate(const CommandLine& line, const Language& language) {
    const auto request = std::make_shared<Request>();
    line.add("FILE", request->path, "the GRAFCET, - for standard input").required();
    line.add("STIM", request->stimuli, "the stimuli (.stim), - for standard input").required();
    request->netlist.declare(line, false);
    line.add("--against", request->against,
             "simulate this .blif or .json netlist instead of a generated one");
    line.add("--power-up", request->power_up,
             "netlists from elsewhere without Init: how their steps start: unknown (the default), "
             "or initial, taken as given")
        .one_of({"unknown", "initial"});
    line.add("--delay", request->delay, "delay of every gate: unit (1 ns)")
        .one_of({"unit"})
        .shows_default();
    line.add("--scan", request->scan,
             "clocked style: one scan every so much time (default: until stable)");
    request->output.declare(line);
    return [request, &language] {
        // Read the GRAFCET and the stimuli.
        if (share_standard_input(request->path, request->stimuli)) {
            return static_cast<int>(bad_request);
        }
        const auto loaded = load_grafcet(request->path);
        if (!loaded) return static_cast<int>(bad_request);
        const auto stimuli = load_stimuli(request->stimuli, loaded->grafcet);
        if (!stimuli) return static_cast<int>(bad_request);
        if (request->against.empty() && !request->power_up.empty()) {
            complain("--power-up has no effect here: it is for a netlist given with --against");
            return static_cast<int>(bad_request);
        }
        // Make the netlist, or read it.
        auto netlist = request->against.empty() ? make_netlist(*loaded, request->netlist)
                                                : load_netlist(request->against);
        if (!netlist) return static_cast<int>(bad_request);
        if (!request->against.empty()) {
            const PortComparison ports = compare_ports(loaded->grafcet, *netlist);
            if (ports.missing_outputs.empty()) {
                adopt_ports(loaded->grafcet, *netlist);
                netlist->starts_initially = request->power_up == "initial";
            }
            if (!ports.fits()) warn("ports:\n" + write_port_table(ports, language));
        }
        warn_of_broken_assumptions(loaded->grafcet, broken_assumptions(loaded->grafcet, *stimuli));
        return simulate_netlist(*request, *loaded, *stimuli, *netlist, language);
    };
}

}  // namespace grafwire
