// The witness of a difference that depends on delays: stimuli, and one circuit out of all those
// that a delay model stands for.
//
// An order of firings that ends wrong (race_search.h) gives delays which change from moment to
// moment (firing_times.h). Those always show it. But a circuit with one constant delay for each
// gate says more, and one where few gates are slow says most. So constant delays are tried first,
// the slowest that each gate has had; then gates are made nominal again, one by one, and faster, as
// long as the difference still shows.

#include "check/racing_witness.h"

#include <algorithm>
#include <map>

#include "check/firing_times.h"
#include "check/race_search.h"
#include "evolution/run.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr int most_simulations = 2'000;

class DelayReduction {
  public:
    DelayReduction(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& nominal,
                   const Stimuli& stimuli, const RunResult& expected, const KeepGoing& keep_going)
        : grafcet_(grafcet),
          netlist_(netlist),
          nominal_(nominal),
          stimuli_(stimuli),
          expected_(expected),
          keep_going_(keep_going) {}

    std::optional<Witness> make(const DelaySchedule& moments) {
        for (const DelaySchedule& candidate : {constant(moments), moments}) {
            if (shows(candidate)) break;
        }
        if (!best_) return std::nullopt;
        leave_out();
        shorten();
        return std::move(best_);
    }

  private:
    /// Per cell the longest of its delays.
    static DelaySchedule constant(const DelaySchedule& moments) {
        std::map<CellId, DelayChange> longest;
        for (const DelayChange& change : moments.changes) {
            DelayChange& all = longest.try_emplace(change.cell, change).first->second;
            all.at = 0;
            all.rise = all.fall = std::max(all.rise, change.rise);
            all.width = std::max(all.width, change.width);
        }
        DelaySchedule schedule;
        for (const auto& [cell, change] : longest) schedule.changes.push_back(change);
        return schedule;
    }

    bool shows(const DelaySchedule& schedule) {
        if (trials_ == most_simulations || (keep_going_ && !keep_going_())) return false;
        ++trials_;
        SimulateOptions options;
        options.schedule = schedule;
        const SimulateResult got = simulate(grafcet_, netlist_, nominal_, stimuli_, options);
        auto witness = first_difference(grafcet_, stimuli_, expected_, got.trace, got.unsettled_at);
        if (!witness || witness->kind == DifferenceKind::race) return false;
        witness->delays = schedule;
        best_ = std::move(witness);
        return true;
    }

    void leave_out() {
        for (bool smaller = true; smaller;) {
            smaller = false;
            for (std::size_t i = best_->delays.changes.size(); i-- > 0;) {
                DelaySchedule trial = best_->delays;
                trial.changes.erase(trial.changes.begin() + static_cast<std::ptrdiff_t>(i));
                if (shows(trial)) smaller = true;
            }
        }
    }

    void shorten() {
        for (std::size_t i = 0; i < best_->delays.changes.size(); ++i) {
            const DelayChange change = best_->delays.changes[i];
            const Time least = nominal_.rise[index_of(change.cell)];
            for (Time delay = 2 * least; delay < change.rise; delay += least) {
                DelaySchedule trial = best_->delays;
                trial.changes[i].rise = trial.changes[i].fall = delay;
                if (shows(trial)) break;
            }
        }
    }

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& nominal_;
    const Stimuli& stimuli_;
    const RunResult& expected_;
    const KeepGoing& keep_going_;
    std::optional<Witness> best_;
    int trials_ = 0;
};

}  // namespace

std::optional<Witness> racing_witness(const Grafcet& grafcet, const Netlist& netlist,
                                      const CellDelays& nominal, const Circuit& circuit,
                                      const DelayModel& model, const Stimuli& stimuli,
                                      const KeepGoing& keep_going) {
    const RunResult expected = run_until_stable(grafcet, stimuli);
    const auto race =
        find_race({grafcet, netlist, nominal, circuit, model, stimuli, expected, keep_going});
    if (!race) return std::nullopt;
    const CellBands bands = cell_bands(netlist, model);
    const bool is_bounded = model.kind == DelayModel::Kind::bounded;
    const auto moments = delays_for(circuit, *race, is_bounded ? &bands : nullptr);
    if (!moments) return std::nullopt;
    return DelayReduction(grafcet, netlist, nominal, stimuli, expected, keep_going).make(*moments);
}

}  // namespace grafwire
