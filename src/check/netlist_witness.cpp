// The witness of a difference between a netlist and its GRAFCET: replayed, and made small.
//
// Replay. A difference counts only if it can be shown again: the stimuli are run once more from the
// start, through the reference on the one side and from power-up through the gates on the other,
// with real times and real lengths of delays, and the first instant at which the two differ is the
// witness. A value that comes out unknown is no difference yet: three-valued simulation is
// pessimistic. It comes from memories whose value at power-up is not known, so such values are
// tried until one leads to a wrong value that is known.
//
// Reduction. The exploration finds a path with as few instants as possible, but not one with as few
// changes: inputs that nothing read were given some value, and where many change together not all
// need to. So changes are left out one by one, from the last to the first, as long as what is left
// still shows a difference from power-up (delta debugging: A. Zeller, R. Hildebrandt, "Simplifying
// and isolating failure-inducing input", IEEE Trans. Softw. Eng. 28, 2002; with pieces of one).

#include "check/netlist_witness.h"

#include <algorithm>

#include "evolution/run.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr int most_power_ups = 64;

/// Whether a value that comes out unknown is really left open: some power-up of the memories that
/// nothing is known of leads to a difference between known values, or to no rest at all.
bool is_left_open(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                  const Stimuli& stimuli, const RunResult& expected, Time period) {
    SimulateOptions options;
    options.scan_period = period;
    for (int number = 0; number < most_power_ups; ++number) {
        const std::vector<Netlist::InitialValue> values = power_up_values(netlist, number);
        if (values.empty()) return false;
        const Netlist powered = with_power_up(netlist, values);
        const SimulateResult got = simulate(grafcet, powered, delays, stimuli, options);
        const auto witness =
            first_difference(grafcet, stimuli, expected, got.trace, got.unsettled_at);
        if (witness && witness->kind != DifferenceKind::race) return true;
    }
    return false;
}

}  // namespace

std::vector<Netlist::InitialValue> power_up_values(const Netlist& netlist, int number) {
    std::uint64_t random = 0x9e3779b97f4a7c15U * static_cast<std::uint64_t>(number + 1);
    const auto next_value = [&] {
        if (number < 2) return number == 1;
        random = random * 6364136223846793005U + 1442695040888963407U;
        return (random >> 63U) != 0;
    };
    std::vector<std::uint8_t> is_known(netlist.net_count());
    for (const Netlist::InitialValue& initial : netlist.initial_values) {
        is_known[index_of(initial.net)] = 1;
    }
    // A net that is held at its initial value until the others rest closes no loop for them.
    Netlist cut = netlist;
    for (Cell& cell : cut.cells) {
        if (is_known[index_of(cell.output)] != 0) cell.pin_count = 0;
    }
    const std::vector<std::uint8_t> on_loop = cells_on_loops(cut);
    std::vector<Netlist::InitialValue> values;
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const Cell& cell = netlist.cells.items()[i];
        const bool is_open = row_of(cell.type).has_memory
                                 ? cell.initial == Logic::unknown
                                 : on_loop[i] != 0 && is_known[index_of(cell.output)] == 0;
        if (is_open) values.push_back({cell.output, next_value()});
    }
    return values;
}

Netlist with_power_up(const Netlist& netlist, const std::vector<Netlist::InitialValue>& values) {
    Netlist powered = netlist;
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    for (const Netlist::InitialValue& value : values) {
        Cell& cell = powered.cells[drivers[value.net]];
        if (row_of(cell.type).has_memory) {
            cell.initial = logic_of(value.value);
        } else {
            powered.initial_values.push_back(value);
        }
    }
    return powered;
}

std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli, Time period,
                              const DelaySchedule& schedule) {
    const RunResult expected =
        period == 0 ? run_until_stable(grafcet, stimuli) : run_scans(grafcet, stimuli, period);
    SimulateOptions options;
    options.scan_period = period;
    options.schedule = schedule;
    const SimulateResult got = simulate(grafcet, netlist, delays, stimuli, options);
    auto witness = first_difference(grafcet, stimuli, expected, got.trace, got.unsettled_at);
    if (!witness) return std::nullopt;
    witness->scan_period = period;
    witness->delays = schedule;
    if (witness->kind == DifferenceKind::race) {
        if (!is_left_open(grafcet, netlist, delays, stimuli, expected, period)) return std::nullopt;
        if (witness->stimuli.end == 0) witness->kind = DifferenceKind::power_up;
    }
    return witness;
}

unsigned changes_at_end(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& nominal,
                        const Stimuli& stimuli, const RunResult& expected,
                        const DelaySchedule& schedule, NetId net) {
    SimulateOptions options;
    options.schedule = schedule;
    unsigned changes = 0;
    Time instant = 0;
    options.instant = [&](Time at, const Simulator&) {
        instant = at;
        changes = 0;
    };
    options.observer = [&](Time, NetId changed, Logic) { changes += changed == net ? 1 : 0; };
    const SimulateResult got = simulate(grafcet, netlist, nominal, stimuli, options);
    const bool is_right = instant == stimuli.end && !first_difference(grafcet, stimuli, expected,
                                                                      got.trace, got.unsettled_at);
    return is_right ? changes : 0;
}

namespace {

/// A long witness is left as it is found: trying costs a run for every change.
constexpr std::size_t most_lines = 300;
constexpr int most_trials = 1000;

class Reduction {
  public:
    Reduction(const Grafcet& grafcet, const Netlist& netlist, const CheckOptions& options,
              Witness&& witness)
        : grafcet_(grafcet),
          netlist_(netlist),
          delays_(cell_delays(netlist, options.delays)),
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

    /// Drops what no longer changes anything; false where an assumption is broken.
    bool tidy(Stimuli& stimuli) const {
        InputValues values(grafcet_.all_input_count(), 0);
        bool is_first = true;
        bool holds = true;
        std::erase_if(stimuli.changes, [&](Stimuli::Change& change) {
            const bool was_empty = change.assignments.empty();
            std::erase_if(change.assignments, [&](const Stimuli::Assignment& set) {
                return (values[set.input] != 0) == set.value;
            });
            for (const Stimuli::Assignment& set : change.assignments) {
                values[set.input] = set.value ? 1 : 0;
            }
            holds = holds && broken_assumption(grafcet_, values) == grafcet_.assumptions.size();
            const bool is_dropped = !is_first && !was_empty && change.assignments.empty();
            is_first = false;
            return is_dropped;
        });
        return holds;
    }

    bool is_still_a_witness(Stimuli&& trial) {
        if (trials_ == most_trials || (options_.keep_going && !options_.keep_going())) return false;
        if (!tidy(trial)) return false;
        ++trials_;
        auto witness = replay(grafcet_, netlist_, delays_, trial, best_.scan_period, best_.delays);
        if (!witness) return false;
        best_ = std::move(*witness);
        return true;
    }

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays delays_;
    const CheckOptions& options_;
    Witness best_;
    int trials_ = 0;
};

}  // namespace

Witness smallest_witness(const Grafcet& grafcet, const Netlist& netlist, Witness witness,
                         const CheckOptions& options) {
    // Leaving a change out moves the ends of delays, which must not come together with the change
    // of an input where one thing happens at a time.
    const bool has_delays = !grafcet.expressions.time_conditions().empty() ||
                            std::any_of(netlist.cells.begin(), netlist.cells.end(),
                                        [](const Cell& cell) { return is_timer(cell.type); });
    if (has_delays && options.changes == Changes::one && !netlist.is_clocked()) return witness;
    const auto& delays = witness.delays.changes;
    const bool are_constant = std::all_of(delays.begin(), delays.end(),
                                          [](const DelayChange& change) { return change.at <= 0; });
    if (!are_constant) return witness;
    return Reduction(grafcet, netlist, options, std::move(witness)).make();
}

}  // namespace grafwire
