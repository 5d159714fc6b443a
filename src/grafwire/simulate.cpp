// Runs of the reference and of a netlist. Time is in picoseconds inside, in nanoseconds outside.

#include "grafwire/simulate.h"

#include "grafwire/messages.h"
#include "grafwire/parts.h"
#include "workflow/runs.h"

namespace grafwire::api {

namespace {

/// A moment of the run, outside.
std::optional<std::chrono::nanoseconds> moment(std::optional<Time> time) {
    if (!time) return std::nullopt;
    return std::chrono::nanoseconds(*time / nanosecond);
}

}  // namespace

Result<Run> run(const Chart& chart, std::string stimuli,
                std::optional<std::chrono::nanoseconds> period) {
    const grafwire::Chart& read = chart.parts().chart;
    Start start = begin(read, std::move(stimuli), period);
    Result<Run> result{std::nullopt, std::move(start.messages)};
    if (!start.is_good) return result;
    const RunResult ran = run_reference(read, *start.stimuli, start.period);
    result.value = Run{write_csv(ran.trace), waveform_of(ran.trace, read.grafcet.name).vcd,
                       moment(ran.unstable_at)};
    return result;
}

Result<Run> simulate(const Netlist& netlist, std::string stimuli,
                     std::optional<std::chrono::nanoseconds> period) {
    const Netlist::Parts& parts = netlist.parts();
    const grafwire::Chart& chart = parts.chart.parts().chart;
    Start start = begin(chart, std::move(stimuli), period);
    Result<Run> result{std::nullopt, std::move(start.messages)};
    if (period && !netlist.is_clocked()) {
        result.messages.push_back(error(messages::library::period_without_clock()));
        return result;
    }
    if (!start.is_good) return result;
    SimulateResult ran =
        simulate_gates(chart, parts.netlist, *start.stimuli, DelayModel(), start.period, true);
    result.value = Run{write_csv(ran.trace), std::move(ran.waveform.vcd), moment(ran.unsettled_at)};
    return result;
}

}  // namespace grafwire::api
