// A difference counts only if it can be shown again: the stimuli are run once more from the start,
// through the reference on the one side and from power-up through the gates on the other, with real
// moments and real lengths of delays, and the first moment at which the two differ is the witness.

#include "check/netlist_witness.h"

#include <algorithm>

#include "evolution/evolution.h"
#include "evolution/run.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

/// The shortest time between two lines, or a convenient one.
Time spacing_of(const Stimuli& stimuli) {
    Time spacing = 100 * millisecond;
    for (std::size_t i = 1; i < stimuli.changes.size(); ++i) {
        spacing = std::min(spacing, stimuli.changes[i].at - stimuli.changes[i - 1].at);
    }
    return spacing;
}

/// Per line of the stimuli, whether a delay of the reference ends at that very moment.
std::vector<bool> lines_at_ends(const Grafcet& grafcet, const Stimuli& stimuli) {
    const Evolution evolution(grafcet);
    std::vector<bool> at_end;
    InputValues inputs(grafcet.all_input_count(), 0);
    EvolutionState state;
    const auto next_end = [&] { return *std::min_element(state.due.begin(), state.due.end()); };
    for (const Stimuli::Change& change : stimuli.changes) {
        while (!at_end.empty() && !state.due.empty() && next_end() < change.at) {
            const Time end = next_end();
            evolution.end_delays(state, end);
            evolution.settle(state, {inputs}, end);
        }
        at_end.push_back(!at_end.empty() && !state.due.empty() && next_end() == change.at);
        for (const auto& set : change.assignments) inputs[set.input] = set.value;
        if (at_end.size() == 1) state = evolution.start({inputs});
        evolution.end_delays(state, change.at);
        evolution.settle(state, {inputs}, change.at);
    }
    return at_end;
}

/// The stimuli for a run scan by scan, going on for a while after their end. There a delay ends at
/// the end of a scan, not before its beginning; so a change that comes together with the end of one
/// is made some scans later.
Stimuli stimuli_by_scan(const Stimuli& stimuli, const std::vector<bool>& at_end, Time later,
                        Time after) {
    Stimuli by_scan = stimuli;
    for (std::size_t i = 0; i < at_end.size(); ++i) {
        if (at_end[i]) by_scan.changes[i].at += later;
    }
    by_scan.end = add_times(stimuli.end, after);
    return by_scan;
}

}  // namespace

std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli) {
    const RunResult expected = run_until_stable(grafcet, stimuli);
    const SimulateResult got = simulate(grafcet, netlist, delays, stimuli, SimulateOptions());
    auto witness = first_difference(grafcet, stimuli, expected, got.trace, got.unsettled_at);
    if (witness || !netlist.is_clocked()) return witness;

    // A clocked netlist may go astray within an instant and find back. Then the scans show it. A
    // hundred are usually enough for what happens within an instant.
    const std::vector<bool> at_end = lines_at_ends(grafcet, stimuli);
    const Time spacing = spacing_of(stimuli);
    for (const Time room : {100, 10'000}) {
        // Not more than some hundred thousand rows altogether.
        const Time period = std::max({spacing / room, stimuli.end / 100'000, nanosecond});
        for (const Time scans_later : {0, 1, 2}) {
            if (scans_later * period >= spacing) break;
            const Stimuli by_scan =
                stimuli_by_scan(stimuli, at_end, scans_later * period, room * period);
            const SimulateResult cycles =
                simulate(grafcet, netlist, delays, by_scan, {false, period, {}});
            witness = first_difference(grafcet, by_scan, run_scans(grafcet, by_scan, period),
                                       cycles.trace, cycles.unsettled_at);
            if (!witness) continue;
            witness->scan_period = period;
            return witness;
        }
    }
    return std::nullopt;
}

}  // namespace grafwire
