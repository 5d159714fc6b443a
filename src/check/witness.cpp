// A difference counts only if it can be shown again: the stimuli are run once more from the start,
// through the reference on the one side and from power-up through the gates on the other, with real
// moments and real lengths of delays, and the first moment at which the two differ is the witness.

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

/// The rows of two runs side by side. A netlist can have instants of its own, at which a delay ends
/// that the reference does not have, and the reverse; what a side shows holds until its next row.
class SideBySide {
  public:
    SideBySide(const Trace& left, const Trace& right) : left_{left, 0}, right_{right, 0} {}

    Row left() const { return left_; }
    Row right() const { return right_; }
    /// The moment of the later of the two rows.
    Time now() const { return std::max(time_of(left_), time_of(right_)); }
    /// On to the next moment at which either has a row; `never` after the last.
    Time next() const { return std::min(next_of(left_), next_of(right_)); }
    void advance() {
        const Time moment = next();
        for (Row* row : {&left_, &right_}) {
            if (next_of(*row) == moment) ++row->row;
        }
    }

  private:
    static Time time_of(const Row& row) { return row.trace.times[row.row]; }
    static Time next_of(const Row& row) {
        return row.row + 1 < row.trace.row_count() ? row.trace.times[row.row + 1] : never;
    }
    Row left_;
    Row right_;
};

/// The gates do not settle at a moment at which the reference does.
Witness oscillation(const Grafcet& grafcet, const Netlist& netlist, const Stimuli& stimuli,
                    const Trace& expected, const SimulateResult& got) {
    Witness witness;
    witness.kind = DifferenceKind::oscillation;
    witness.stimuli = cut_after(stimuli, *got.unsettled_at);
    const auto after =
        std::upper_bound(expected.times.begin(), expected.times.end(), *got.unsettled_at);
    const auto row = static_cast<std::size_t>(after - expected.times.begin()) - 1;
    fill_values(grafcet, witness, {expected, row}, nullptr);
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    for (const NetId net : got.oscillating) {
        if (drivers[net] != no_cell) witness.oscillating.push_back(drivers[net]);
    }
    return witness;
}

/// The first moment at which two runs differ, or where the gates do not settle; nothing where the
/// reference finds no stable situation before.
std::optional<Witness> first_difference(const Grafcet& grafcet, const Netlist& netlist,
                                        const Stimuli& stimuli, const RunResult& expected,
                                        const SimulateResult& got) {
    const Time unsettled = got.unsettled_at.value_or(never);
    const Time unstable = expected.unstable_at.value_or(never);
    if (std::min(unsettled, unstable) > 0) {
        for (SideBySide rows(expected.trace, got.trace);; rows.advance()) {
            if (const auto kind = difference(grafcet, rows.left(), rows.right())) {
                Witness witness;
                witness.kind = *kind;
                witness.stimuli = cut_after(stimuli, rows.now());
                const Row got_row = rows.right();
                fill_values(grafcet, witness, rows.left(), &got_row);
                return witness;
            }
            if (rows.next() == never || rows.next() >= std::min(unsettled, unstable)) break;
        }
    }
    if (unsettled >= unstable) return std::nullopt;
    return oscillation(grafcet, netlist, stimuli, expected.trace, got);
}

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
    auto witness = first_difference(grafcet, netlist, stimuli, expected, got);
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
        witness = first_difference(grafcet, netlist, by_scan, scans, cycles);
        if (!witness) continue;
        witness->scan_period = period;
        return witness;
    }
    return std::nullopt;
}

}  // namespace grafwire
