// The exploration finds a way with as few instants as possible, but not one with as few changes:
// inputs that nobody read were given some value, and where many change together not all need to. So
// changes are left out one by one, from the last to the first, as long as what is left still shows
// a difference from power-up (delta debugging: A. Zeller, R. Hildebrandt, "Simplifying and
// isolating failure-inducing input", IEEE Trans. Softw. Eng. 28, 2002; with pieces of one).

#include "check/smallest_witness.h"

#include <algorithm>

#include "check/netlist_witness.h"

namespace grafwire {

namespace {

/// A long witness is left as it is found: trying costs a run for every change.
constexpr std::size_t most_lines = 300;
constexpr int most_trials = 1000;

class Reduction {
  public:
    Reduction(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
              const CheckOptions& options, Witness&& witness)
        : grafcet_(grafcet),
          netlist_(netlist),
          delays_(delays),
          options_(options),
          best_(std::move(witness)) {}

    Witness make() {
        bool smaller = best_.stimuli.changes.size() <= most_lines;
        while (smaller) {
            smaller = false;
            for (std::size_t line = best_.stimuli.changes.size(); line-- > 0;) {
                if (line >= best_.stimuli.changes.size()) continue;
                while (leave_out_one_of(line)) smaller = true;
            }
        }
        return std::move(best_);
    }

  private:
    bool leave_out_one_of(std::size_t line) {
        const Stimuli& stimuli = best_.stimuli;
        if (line >= stimuli.changes.size()) return false;
        for (std::size_t i = stimuli.changes[line].assignments.size(); i-- > 0;) {
            Stimuli trial = stimuli;
            auto& assignments = trial.changes[line].assignments;
            assignments.erase(assignments.begin() + static_cast<std::ptrdiff_t>(i));
            if (assignments.empty() && line != 0) {
                trial.changes.erase(trial.changes.begin() + static_cast<std::ptrdiff_t>(line));
            }
            if (is_still_a_witness(std::move(trial))) return true;
        }
        return false;
    }

    /// Drops what changes nothing any more; false where an assumption is broken.
    bool tidy(Stimuli& stimuli) const {
        InputValues values(grafcet_.all_input_count(), 0);
        bool is_first = true;
        std::erase_if(stimuli.changes, [&](Stimuli::Change& change) {
            const bool was_empty = change.assignments.empty();
            std::erase_if(change.assignments, [&](const Stimuli::Assignment& set) {
                return (values[set.input] != 0) == set.value;
            });
            for (const Stimuli::Assignment& set : change.assignments) {
                values[set.input] = set.value ? 1 : 0;
            }
            holds_ = holds_ && broken_assumption(grafcet_, values) == grafcet_.assumptions.size();
            const bool is_dropped = !is_first && !was_empty && change.assignments.empty();
            is_first = false;
            return is_dropped;
        });
        return std::exchange(holds_, true);
    }

    bool is_still_a_witness(Stimuli&& trial) {
        if (trials_ == most_trials || (options_.keep_going && !options_.keep_going({})))
            return false;
        if (!tidy(trial)) return false;
        ++trials_;
        auto witness = replay(grafcet_, netlist_, delays_, trial, best_.scan_period);
        if (!witness) return false;
        best_ = std::move(*witness);
        return true;
    }

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& delays_;
    const CheckOptions& options_;
    Witness best_;
    int trials_ = 0;
    mutable bool holds_ = true;
};

}  // namespace

Witness smallest_witness(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                         Witness witness, const CheckOptions& options) {
    // Leaving a change out moves the ends of delays, which must not come together with the change
    // of an input where one thing happens at a time.
    const bool has_delays = !grafcet.expressions.time_conditions().empty() ||
                            std::any_of(netlist.cells.begin(), netlist.cells.end(),
                                        [](const Cell& cell) { return is_timer(cell.type); });
    if (has_delays && options.changes == Changes::one && !netlist.is_clocked()) return witness;
    return Reduction(grafcet, netlist, delays, options, std::move(witness)).make();
}

}  // namespace grafwire
