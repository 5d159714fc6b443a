// A difference counts only if it can be shown again: the stimuli are run once more from the start,
// through the reference on the one side and from power-up through the gates on the other, with real
// moments and real lengths of delays, and the first moment at which the two differ is the witness.

#include "check/netlist_witness.h"

#include <algorithm>

#include "evolution/run.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

/// A scan period that leaves room for so many scans between two changes of the inputs, and for not
/// more than some hundred thousand rows altogether.
Time scan_period_for(const Stimuli& stimuli, Time room) {
    Time spacing = 100 * millisecond;
    for (std::size_t i = 1; i < stimuli.changes.size(); ++i) {
        spacing = std::min(spacing, stimuli.changes[i].at - stimuli.changes[i - 1].at);
    }
    return std::max({spacing / room, stimuli.end / 100'000, nanosecond});
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
    for (const Time room : {100, 10'000}) {
        const Time period = scan_period_for(stimuli, room);
        Stimuli by_scan = stimuli;
        by_scan.end = add_times(stimuli.end, room * period);
        const RunResult scans = run_scans(grafcet, by_scan, period);
        const SimulateResult cycles =
            simulate(grafcet, netlist, delays, by_scan, {false, period, {}});
        witness = first_difference(grafcet, by_scan, scans, cycles.trace, cycles.unsettled_at);
        if (!witness) continue;
        witness->scan_period = period;
        return witness;
    }
    return std::nullopt;
}

}  // namespace grafwire
