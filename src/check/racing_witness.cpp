// The witness of a difference that depends on delays: stimuli, and one circuit out of all those
// that a delay model stands for.
//
// An order of firings that ends wrong (race_search.h) gives delays which change from moment to
// moment (firing_times.h). Those always show it. But a circuit with one constant delay for each
// gate says more, and one where few gates are slow says most. So constant delays are tried first,
// the slowest that each gate has had; then gates are made nominal again, one by one, and faster, as
// long as the difference still shows.
//
// Where delays have bounds, all orders of firings with all their times can be very many, while a
// simulation takes no time: some circuits in which every gate is as fast or as slow as it can be
// are tried before. That finds most differences; what it does not find is looked for.
//
// A net that changes too often is shown in the same way: beside it, everything has to be as in the
// reference at the end of each instant, or it would only be what follows from a difference.

#include "check/racing_witness.h"

#include <algorithm>
#include <functional>
#include <map>
#include <random>

#include "check/firing_times.h"
#include "check/netlist_witness.h"
#include "check/race_search.h"
#include "evolution/run.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr int most_simulations = 4'000;
constexpr unsigned most_extreme_circuits = 4'000;

/// A circuit in which each edge of some gates is, by chance, as slow as it can be, and all else as
/// fast.
DelaySchedule extreme_circuit(const CellBands& bands, const std::vector<CellId>& may_be_slow,
                              unsigned against, std::mt19937& random) {
    DelaySchedule schedule;
    for (std::uint32_t cell = 0; cell < bands.rise.size(); ++cell) {
        schedule.changes.push_back(
            {0, CellId{cell}, bands.rise[cell].min, bands.fall[cell].min, 0});
    }
    for (const CellId cell : may_be_slow) {
        DelayChange& change = schedule.changes[index_of(cell)];
        if (random() % (against + 1) == 0) change.rise = bands.rise[index_of(cell)].max;
        if (random() % (against + 1) == 0) change.fall = bands.fall[index_of(cell)].max;
    }
    return schedule;
}

/// The cells that change in the last instant of a simulation.
std::vector<CellId> last_to_change(const Grafcet& grafcet, const Netlist& netlist,
                                   const CellDelays& delays, const Stimuli& stimuli) {
    const auto drivers = drivers_of(netlist);
    std::vector<CellId> changed;
    SimulateOptions options;
    options.instant = [&](Time, const Simulator&) { changed.clear(); };
    options.observer = [&](Time, NetId net, Logic) {
        if (drivers[net] != no_cell) changed.push_back(drivers[net]);
    };
    simulate(grafcet, netlist, delays, stimuli, options);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

/// Looks for delays that show something, as few and as small as can be.
class DelayReduction {
  public:
    /// Whether a simulation with these delays shows it.
    using Shows = std::function<bool(const DelaySchedule&)>;

    DelayReduction(const CellDelays& nominal, Shows shows, const KeepGoing& keep_going)
        : nominal_(nominal), is_shown_by_(std::move(shows)), keep_going_(keep_going) {}

    std::optional<DelaySchedule> make(const DelaySchedule& moments) {
        for (const DelaySchedule& candidate : {constant(moments), moments}) {
            if (shows(candidate)) break;
        }
        return reduced();
    }

    /// Of the circuits that are tried, every other one is slow only where something changes at the
    /// end (`last`).
    std::optional<DelaySchedule> make_extreme(const CellBands& bands,
                                              const std::vector<CellId>& last) {
        std::vector<CellId> all;
        for (std::uint32_t cell = 0; cell < bands.rise.size(); ++cell) all.push_back(CellId{cell});
        std::mt19937 random;
        for (unsigned i = 0; i < most_extreme_circuits && !best_; ++i) {
            shows(i % 2 == 0 ? extreme_circuit(bands, last, 1, random)
                             : extreme_circuit(bands, all, 1U << i / 2 % 5, random));
        }
        trials_ = 0;
        return reduced();
    }

  private:
    std::optional<DelaySchedule> reduced() {
        if (!best_) return std::nullopt;
        leave_out();
        shorten();
        return std::move(best_);
    }

    /// Per cell the longest of its delays.
    static DelaySchedule constant(const DelaySchedule& moments) {
        std::map<CellId, DelayChange> longest;
        for (const DelayChange& change : moments.changes) {
            DelayChange& all = longest.try_emplace(change.cell, change).first->second;
            all.at = 0;
            all.rise = std::max(all.rise, change.rise);
            all.fall = std::max(all.fall, change.fall);
            all.width = std::max(all.width, change.width);
        }
        DelaySchedule schedule;
        for (const auto& [cell, change] : longest) schedule.changes.push_back(change);
        return schedule;
    }

    bool shows(const DelaySchedule& schedule) {
        if (trials_ == most_simulations || (keep_going_ && !keep_going_())) return false;
        ++trials_;
        if (!is_shown_by_(schedule)) return false;
        best_ = schedule;
        return true;
    }

    void leave_out() {
        for (bool smaller = true; smaller;) {
            smaller = false;
            for (std::size_t i = best_->changes.size(); i-- > 0;) {
                DelaySchedule trial = *best_;
                trial.changes.erase(trial.changes.begin() + static_cast<std::ptrdiff_t>(i));
                if (shows(trial)) smaller = true;
            }
        }
    }

    void shorten() {
        for (std::size_t i = 0; i < best_->changes.size(); ++i) {
            const DelayChange change = best_->changes[i];
            const Time rise = nominal_.rise[index_of(change.cell)];
            const Time fall = nominal_.fall[index_of(change.cell)];
            const Time least = std::min(rise, fall);
            for (Time delay = 2 * least; delay < std::max(change.rise, change.fall);
                 delay += least) {
                DelaySchedule trial = *best_;
                trial.changes[i].rise = std::clamp(delay, rise, std::max(rise, change.rise));
                trial.changes[i].fall = std::clamp(delay, fall, std::max(fall, change.fall));
                if (shows(trial)) break;
            }
        }
    }

    const CellDelays& nominal_;
    const Shows is_shown_by_;
    const KeepGoing& keep_going_;
    std::optional<DelaySchedule> best_;
    int trials_ = 0;
};

/// Delays of the model that show what is looked for, if any are found.
std::optional<DelaySchedule> find_delays(const RaceQuestion& question, WitnessSearch search,
                                         const DelayReduction::Shows& shows) {
    DelayReduction reduction(question.nominal, shows, question.keep_going);
    const bool is_bounded = question.model.kind == DelayModel::Kind::bounded;
    const CellBands bands = cell_bands(question.netlist, question.model);
    if (is_bounded) {
        const std::vector<CellId> last =
            last_to_change(question.grafcet, question.netlist, question.nominal, question.stimuli);
        if (auto delays = reduction.make_extreme(bands, last)) return delays;
        if (search == WitnessSearch::by_trial) return std::nullopt;
    }
    const auto race = find_race(question);
    if (!race) return std::nullopt;
    const auto moments = delays_for(question.circuit, *race, is_bounded ? &bands : nullptr);
    return moments ? reduction.make(*moments) : std::nullopt;
}

}  // namespace

std::optional<Witness> racing_witness(const Grafcet& grafcet, const Netlist& netlist,
                                      const CellDelays& nominal, const Circuit& circuit,
                                      const DelayModel& model, const Stimuli& stimuli,
                                      WitnessSearch search, const KeepGoing& keep_going) {
    const RunResult expected = run_until_stable(grafcet, stimuli);
    std::optional<Witness> last;
    const auto shows = [&](const DelaySchedule& schedule) {
        SimulateOptions options;
        options.schedule = schedule;
        const SimulateResult got = simulate(grafcet, netlist, nominal, stimuli, options);
        auto witness = first_difference(grafcet, stimuli, expected, got.trace, got.unsettled_at);
        if (!witness || witness->kind == DifferenceKind::race) return false;
        witness->delays = schedule;
        last = std::move(witness);
        return true;
    };
    const RaceQuestion question{grafcet, netlist, nominal,  circuit,
                                model,   stimuli, expected, keep_going};
    // The last that showed it is the one that was kept.
    return find_delays(question, search, shows) ? std::move(last) : std::nullopt;
}

std::optional<DelaySchedule> racing_pulse(const Grafcet& grafcet, const Netlist& netlist,
                                          const CellDelays& nominal, const Circuit& circuit,
                                          const DelayModel& model, const Stimuli& stimuli,
                                          const WatchedNet& watched, const KeepGoing& keep_going) {
    const RunResult expected = run_until_stable(grafcet, stimuli);
    const auto shows = [&](const DelaySchedule& schedule) {
        return changes_at_end(grafcet, netlist, nominal, stimuli, expected, schedule, watched.net) >
               watched.most;
    };
    const RaceQuestion question{grafcet, netlist,  nominal,    circuit, model,
                                stimuli, expected, keep_going, &watched};
    return find_delays(question, WitnessSearch::thorough, shows);
}

}  // namespace grafwire
