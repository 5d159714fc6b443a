// Where two runs part: their rows side by side, in order of time, up to the first that differs.
//
// The two need not have rows at the same times: a netlist has instants of its own at which a timer
// ends that the reference lacks, and the reverse. What a side shows holds until its next row. Of a
// row that differs in several ways the situation counts first, then an output, then a value that is
// left open.

#include "check/witness.h"

#include <algorithm>

namespace grafwire {

namespace {

Logic traced(std::int64_t value) {
    if (value == Trace::unknown) return Logic::unknown;
    return logic_of(value != 0);
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
        value.expected = traced(expected.at(first + i));
        if (got != nullptr) value.got = traced(got->at(first + i));
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

/// It does not settle at a moment at which the reference does.
Witness oscillation(const Grafcet& grafcet, const Stimuli& stimuli, const Trace& expected,
                    Time unsettled) {
    Witness witness;
    witness.kind = DifferenceKind::oscillation;
    witness.stimuli = cut_after(stimuli, unsettled);
    const auto after = std::upper_bound(expected.times.begin(), expected.times.end(), unsettled);
    const auto row = static_cast<std::size_t>(after - expected.times.begin()) - 1;
    fill_values(grafcet, witness, {expected, row}, nullptr);
    return witness;
}

}  // namespace

std::optional<Witness> first_difference(const Grafcet& grafcet, const Stimuli& stimuli,
                                        const RunResult& expected, const Trace& got,
                                        std::optional<Time> unsettled_at) {
    const Time unsettled = unsettled_at.value_or(never);
    const Time unstable = expected.unstable_at.value_or(never);
    if (std::min(unsettled, unstable) > 0) {
        for (SideBySide rows(expected.trace, got);; rows.advance()) {
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
    return oscillation(grafcet, stimuli, expected.trace, unsettled);
}

}  // namespace grafwire
