// From a path of the exploration to stimuli with moments.
//
// In the exploration delays end when they please. Here every instant of the path gets a moment such
// that exactly those delays end that are to end: a system of difference constraints
//
//     t(i+1) >= t(i) + gap                       instants follow one another
//     t(i)    = t(s) + d                         a delay of length d, begun at s, ends at i
//     t(i)   <= t(s) + d - gap                   one that is still running at i has not ended
//
// solved as longest paths (Bellman-Ford); a cycle that keeps growing means that no moments fit.
// When a delay began is told by the evolution itself: it is run along the path with the number of
// the instant as its clock, so that the moment at which a delay is due gives away its beginning.

#include <algorithm>

#include "check/witness.h"
#include "evolution/evolution.h"

namespace grafwire {

namespace {

/// t[to] >= t[from] + distance
struct Constraint {
    std::size_t from = 0;
    std::size_t to = 0;
    Time distance = 0;
};

class Timeline {
  public:
    Timeline(const Grafcet& grafcet, Time gap)
        : grafcet_(grafcet), evolution_(grafcet), gap_(gap) {}

    /// Follows the path and collects the constraints; false where the path is not a path.
    bool follow(const std::vector<PathStep>& path, const std::vector<InputValues>& values);
    std::optional<std::vector<Time>> solve(std::size_t instants) const;

  private:
    void constrain_delays(const EvolutionState& state, std::size_t instant,
                          const std::vector<std::uint32_t>& ended);

    const Grafcet& grafcet_;
    Evolution evolution_;
    Time gap_;
    std::vector<Constraint> constraints_;
};

void Timeline::constrain_delays(const EvolutionState& state, std::size_t instant,
                                const std::vector<std::uint32_t>& ended) {
    const Expressions& pool = grafcet_.expressions;
    for (std::uint32_t k = 0; k < state.due.size(); ++k) {
        if (!Evolution::is_running(state, k)) continue;
        const TimeCondition& condition = pool.time_condition_of(pool.time_conditions()[k]);
        const Time length = state.time_values.test(k) ? condition.off_delay : condition.on_delay;
        const auto begun = static_cast<std::size_t>(state.due[k] - length);
        if (std::find(ended.begin(), ended.end(), k) != ended.end()) {
            constraints_.push_back({begun, instant, length});
            constraints_.push_back({instant, begun, -length});
        } else {
            constraints_.push_back({instant, begun, -(length - gap_)});
        }
    }
}

bool Timeline::follow(const std::vector<PathStep>& path, const std::vector<InputValues>& values) {
    EvolutionState state = evolution_.start({values[0]});
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i != 0) {
            constraints_.push_back({i - 1, i, gap_});
            constrain_delays(state, i, path[i].ended);
            for (const std::uint32_t k : path[i].ended) {
                if (!Evolution::is_running(state, k)) return false;
                evolution_.end_delay(state, k);
            }
        }
        const auto clock = static_cast<Time>(i);
        if (!evolution_.settle(state, {values[i]}, clock).stable) return i + 1 == path.size();
    }
    return true;
}

std::optional<std::vector<Time>> Timeline::solve(std::size_t instants) const {
    std::vector<Time> at(instants, 0);
    for (std::size_t round = 0; round <= instants; ++round) {
        bool changed = false;
        for (const Constraint& constraint : constraints_) {
            const Time earliest = at[constraint.from] + constraint.distance;
            if (earliest <= at[constraint.to]) continue;
            at[constraint.to] = earliest;
            changed = true;
        }
        if (!changed) {
            const Time first = at[0];
            for (Time& moment : at) moment -= first;
            return at;
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<Stimuli> stimuli_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                   const std::vector<PathStep>& path, Time gap) {
    std::vector<InputValues> values;
    InputValues previous(grafcet.all_input_count(), 0);
    for (const PathStep& step : path) {
        auto complete = assumptions.complete(step.inputs, previous);
        if (!complete) return std::nullopt;
        previous = *complete;
        values.push_back(std::move(*complete));
    }
    Timeline timeline(grafcet, gap);
    if (!timeline.follow(path, values)) return std::nullopt;
    const auto moments = timeline.solve(path.size());
    if (!moments) return std::nullopt;

    Stimuli stimuli;
    previous.assign(grafcet.all_input_count(), 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        Stimuli::Change change;
        change.at = (*moments)[i];
        for (std::uint32_t input = 0; input < previous.size(); ++input) {
            if (values[i][input] == previous[input]) continue;
            change.assignments.push_back({input, values[i][input] != 0});
        }
        previous = values[i];
        // An instant at which only a delay ends, or nothing changes, comes about by itself; but the
        // latter would not, so its line stays.
        const bool comes_by_itself = change.assignments.empty() && !path[i].ended.empty();
        if (!comes_by_itself) stimuli.changes.push_back(std::move(change));
    }
    stimuli.end = moments->back();
    return stimuli;
}

}  // namespace grafwire
