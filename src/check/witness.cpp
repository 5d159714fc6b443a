// A difference counts only if it can be shown again: the stimuli are run once more from the start,
// through the reference on the one side and from power-up through the gates on the other, with real
// moments and real lengths of delays, and the first row in which the two differ is the witness.

#include "check/witness.h"

#include <algorithm>

#include "evolution/run.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

Logic logic_of(std::int64_t value) {
    if (value == Trace::unknown) return Logic::unknown;
    return value != 0 ? Logic::one : Logic::zero;
}

struct Row {
    const Trace& trace;
    std::size_t row;
    std::int64_t at(std::size_t column) const {
        return trace.values[row * trace.columns.size() + column];
    }
};

/// The kind of the difference between two rows, if there is one.
std::optional<DifferenceKind> difference(const Grafcet& grafcet, const Row& expected,
                                         const Row& got) {
    const std::size_t first = grafcet.all_input_count();
    const std::size_t outputs = first + grafcet.steps.size();
    const std::size_t end = outputs + grafcet.outputs.size();
    std::optional<DifferenceKind> kind;
    for (std::size_t column = first; column < end; ++column) {
        if (expected.at(column) == got.at(column)) continue;
        if (got.at(column) == Trace::unknown) {
            if (!kind) kind = DifferenceKind::race;
        } else if (column < outputs) {
            return DifferenceKind::situation;
        } else if (!kind || *kind == DifferenceKind::race) {
            kind = DifferenceKind::output;
        }
    }
    return kind;
}

void fill_values(const Grafcet& grafcet, Witness& witness, const Row& expected, const Row* got) {
    const std::size_t first = grafcet.all_input_count();
    const std::size_t count = grafcet.steps.size() + grafcet.outputs.size();
    for (std::size_t i = 0; i < count; ++i) {
        Witness::Value value;
        value.name = expected.trace.columns[first + i].name;
        value.expected = logic_of(expected.at(first + i));
        if (got != nullptr) value.got = logic_of(got->at(first + i));
        witness.values.push_back(std::move(value));
    }
}

Stimuli cut_after(Stimuli stimuli, Time end) {
    std::erase_if(stimuli.changes, [&](const Stimuli::Change& c) { return c.at > end; });
    stimuli.end = end;
    return stimuli;
}

/// The first row in which two runs differ, or where the gates do not settle.
std::optional<Witness> first_difference(const Grafcet& grafcet, const Netlist& netlist,
                                        const Stimuli& stimuli, const Trace& expected,
                                        const SimulateResult& got) {
    const std::size_t rows = std::min(expected.row_count(), got.trace.row_count());
    for (std::size_t row = 0; row < rows; ++row) {
        const Row wanted{expected, row};
        const Row shown{got.trace, row};
        const auto kind = difference(grafcet, wanted, shown);
        if (!kind) continue;
        Witness witness;
        witness.kind = *kind;
        witness.stimuli = cut_after(stimuli, expected.times[row]);
        fill_values(grafcet, witness, wanted, &shown);
        return witness;
    }
    if (!got.unsettled_at || rows >= expected.row_count()) return std::nullopt;
    Witness witness;
    witness.kind = DifferenceKind::oscillation;
    witness.stimuli = cut_after(stimuli, *got.unsettled_at);
    fill_values(grafcet, witness, {expected, rows}, nullptr);
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    for (const NetId net : got.oscillating) {
        if (drivers[net] == no_cell) continue;
        witness.oscillating.push_back(drivers[net]);
    }
    return witness;
}

/// A scan period that leaves room for a hundred scans between two changes of the inputs, and for
/// not more than some hundred thousand rows altogether.
Time scan_period_for(const Stimuli& stimuli) {
    Time spacing = 100 * millisecond;
    for (std::size_t i = 1; i < stimuli.changes.size(); ++i) {
        spacing = std::min(spacing, stimuli.changes[i].at - stimuli.changes[i - 1].at);
    }
    return std::max({spacing / 100, stimuli.end / 100'000, nanosecond});
}

}  // namespace

std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli) {
    const RunResult expected = run_until_stable(grafcet, stimuli);
    const SimulateResult got = simulate(grafcet, netlist, delays, stimuli, SimulateOptions());
    auto witness = first_difference(grafcet, netlist, stimuli, expected.trace, got);
    if (witness || !netlist.is_clocked()) return witness;

    // A clocked netlist may go astray within an instant and find back. Then the scans show it.
    const Time period = scan_period_for(stimuli);
    Stimuli by_scan = stimuli;
    by_scan.end = add_times(stimuli.end, 100 * period);
    const RunResult scans = run_scans(grafcet, by_scan, period);
    const SimulateResult cycles = simulate(grafcet, netlist, delays, by_scan, {false, period, {}});
    witness = first_difference(grafcet, netlist, by_scan, scans.trace, cycles);
    if (witness) witness->scan_period = period;
    return witness;
}

}  // namespace grafwire
