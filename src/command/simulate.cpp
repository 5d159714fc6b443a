// grafwire simulate: the gates of a netlist, made or read, under stimuli, in the columns of the
// reference.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "command/option_uses.h"
#include "command/terminal.h"
#include "text/joined.h"
#include "text/wrapped.h"
#include "workflow/check.h"
#include "workflow/gate_delays.h"
#include "workflow/runs.h"
#include "workflow/zoom.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

/// What may be written after `grafwire simulate`.
struct SimulateArguments {
    std::string path;
    std::string stimuli;
    NetlistRequest netlist;
    std::string against;
    std::string power_up;  ///< empty: unknown
    std::string delays;    ///< empty: as the model says
    std::string scan;
    bool explain = false;
    std::string zoom;  ///< empty: the whole run
    TraceOutput output;
};

/// What is known of the request before anything is read.
unsigned facts_of(const SimulateArguments& request) {
    if (!request.against.empty()) {
        return fact::elsewhere | fact::open_start | fact::asynchronous | fact::clocked;
    }
    return fact::generated | (request.netlist.is_handshake() ? fact::handshake : fact::none) |
           (request.netlist.options().style == Style::clocked ? fact::clocked : fact::asynchronous);
}

/// What is known once the netlist is there.
unsigned facts_of(const SimulateArguments& request, const Chart& chart, const Netlist& netlist) {
    unsigned facts = request.against.empty() ? fact::generated : fact::elsewhere;
    facts |= netlist.is_clocked() ? fact::clocked : fact::asynchronous;
    if (!request.against.empty() && power_up_of(chart, netlist, true) != PowerUp::init) {
        facts |= fact::open_start;
    }
    return facts;
}

/// The netlist, made or read; one from elsewhere is made to fit.
std::optional<Netlist> netlist_for(const SimulateArguments& request, const Chart& chart,
                                   const CommandLine& line) {
    if (request.against.empty()) return make_netlist(chart, request.netlist);
    auto netlist = load_netlist(request.against);
    if (!netlist) return std::nullopt;
    const PortComparison ports = fit_netlist(chart, *netlist, request.power_up == "initial");
    if (!ports.fits()) warn(say::ports(port_table(ports)));
    if (refuse_idle_options(line, "simulate", facts_of(request, chart, *netlist))) {
        return std::nullopt;
    }
    return netlist;
}

/// How long its gates take, and the wires that are named.
std::optional<GateDelays> delays_for(const SimulateArguments& request, Netlist& netlist) {
    const DelayModel model = request.netlist.delays();
    if (request.delays.empty() && !model.is_fixed()) {
        complain(say::delays_are_open(model.name));
        return std::nullopt;
    }
    if (request.delays.empty()) return model;
    auto schedule = load_delays(request.delays, netlist);
    if (!schedule) return std::nullopt;
    return GateDelays(model, std::move(*schedule));
}

/// Whether the delays are to come from standard input, as something else is; shows it if so.
bool shares_delays(const SimulateArguments& request) {
    if (request.delays != "-" || (request.path != "-" && request.stimuli != "-")) return false;
    complain(say::delays_share_standard_input());
    return true;
}

/// What is simulated.
struct Simulation {
    const Chart& chart;
    const Netlist& netlist;
    const GateDelays& delays;
    const Stimuli& stimuli;
    std::optional<Time> period;
};

/// What the gates did.
struct Work {
    SimulateResult result;
    std::string story;                   ///< in words, if asked for
    std::optional<ZoomResult> zoomed{};  ///< with the instant that is asked for
};

/// `zoom`: empty for the whole run.
Work let_work(const SimulateArguments& request, const Simulation& run, std::optional<Time> zoom,
              Language language) {
    const bool with_waveform = !request.output.vcd.empty();
    Work work;
    if (zoom) {
        work.zoomed = zoom_into(run.chart, run.netlist, run.stimuli, run.delays, run.period,
                                with_waveform, *zoom, language);
        work.result = std::move(work.zoomed->simulation);
    }
    if (request.explain) {
        // Its observers are others than those of an instant.
        ExplainedSimulation explained = explain_gates(
            run.chart, run.netlist, run.stimuli, run.delays, run.period, with_waveform, language);
        work.result = std::move(explained.result);
        work.story = std::move(explained.text);
    } else if (!zoom) {
        work.result = simulate_gates(run.chart, run.netlist, run.stimuli, run.delays, run.period,
                                     with_waveform);
    }
    return work;
}

/// The picture of an instant; empty, and shown, where there is none.
std::optional<std::string> zoomed_picture(const SimulateArguments& request,
                                          const ZoomResult& zoomed, const Chart& chart,
                                          Language language) {
    if (zoomed.instant) return request.output.text_of(zoomed.instant->shown(), chart, language);
    std::vector<std::string> nearest;
    for (const Time instant : zoomed.nearest) nearest.push_back(format_duration(instant));
    complain(say::no_instant_at(request.zoom, joined(nearest, ", ")));
    return std::nullopt;
}

/// The trace or the picture; empty, and shown, where there is no such instant.
std::optional<std::string> text_of(const SimulateArguments& request, const Simulation& run,
                                   const Work& work, Language language) {
    if (work.zoomed) return zoomed_picture(request, *work.zoomed, run.chart, language);
    const Trace& trace = work.result.trace;
    ShownRun shown{trace, title_of(run.chart.grafcet)};
    if (request.output.is_picture()) {
        shown.causes =
            causes_of(trace, run.chart.grafcet, tell_reference(run.chart, run.stimuli, run.period));
    }
    return request.output.text_of(shown, run.chart, language);
}

/// Assumptions that the stimuli break are warned of: the gates then do what no check has looked at.
ExitStatus simulate_netlist(const SimulateArguments& request, const CommandLine& line) {
    if (request.output.is_refused()) return ExitStatus::bad_request;
    const ChosenFormat format = request.output.chosen();
    if (refuse_idle_options(line, "simulate", facts_of(request), &format)) {
        return ExitStatus::bad_request;
    }
    std::optional<Time> zoom;
    if (!request.zoom.empty()) {
        zoom = parse_moment(request.zoom);
        if (!zoom) return ExitStatus::bad_request;
    }
    // Read the GRAFCET and the stimuli.
    if (share_standard_input(request.path, request.stimuli) || shares_delays(request)) {
        return ExitStatus::bad_request;
    }
    auto chart = load_chart(request.path, line);
    if (!chart) return ExitStatus::bad_request;
    chart = to_wire(std::move(*chart), request.netlist).chart;
    const auto stimuli = load_stimuli(request.stimuli, chart->grafcet);
    if (!stimuli) return ExitStatus::bad_request;
    // Make the netlist, or read it.
    auto netlist = netlist_for(request, *chart, line);
    if (!netlist) return ExitStatus::bad_request;
    const auto delays = delays_for(request, *netlist);
    if (!delays) return ExitStatus::bad_request;
    for (const auto& broken : broken_assumptions(chart->grafcet, *stimuli)) {
        warn(broken_assumption_text(chart->grafcet, broken));
    }
    const Period period = parse_period(request.scan);
    if (period.is_wrong || has_too_many_scans(chart->grafcet, *stimuli, period)) {
        return ExitStatus::bad_request;
    }
    // Let the gates work.
    const Simulation run{*chart, *netlist, *delays, *stimuli, period.value};
    const Work work = let_work(request, run, zoom, line.language());
    const SimulateResult& result = work.result;
    // Write the trace, up to the instant at which they do not settle if there is one.
    if (result.unsettled_at) {
        complain(say::netlist_does_not_settle(format_milliseconds(*result.unsettled_at),
                                              oscillating_cells(*netlist, result.oscillating)));
    }
    const auto trace = text_of(request, run, work, line.language());
    if (!trace) return ExitStatus::bad_request;
    OutputFiles files({request.path, request.stimuli, request.against, request.delays});
    if (request.explain) files.add("-", wrapped(work.story, width_of_output()));
    if (!request.output.add_files(files, *trace, result.waveform, request.explain)) {
        return ExitStatus::bad_request;
    }
    return finish(files, result.unsettled_at ? ExitStatus::answer_is_no : ExitStatus::done);
}

}  // namespace

Task declare_simulate(const CommandLine& line) {
    const auto request = std::make_shared<SimulateArguments>();
    line.add_argument(help::file_name, request->path, help::file()).names_file({".grafcet"});
    line.add_argument(help::stim_name, request->stimuli, help::stim()).names_file({".stim"});
    request->netlist.declare(line, false);
    line.add("--against", request->against, help::simulate_against())
        .names_file({".blif", ".json"});
    line.add("--power-up", request->power_up, help::power_up()).one_of({"unknown", "initial"});
    request->netlist.declare_delay(line);
    line.add("--delays", request->delays, help::simulate_delays()).names_file({".delays"});
    line.add("--scan", request->scan, help::simulate_scan());
    line.add_flag("--explain", request->explain, help::simulate_explain());
    line.add("--zoom", request->zoom, help::simulate_zoom());
    request->output.declare(line);
    request->output.declare_format(line);
    line.add_strict();
    return [request, line] { return simulate_netlist(*request, line); };
}

}  // namespace grafwire
