// From a path of the exploration to stimuli with moments.
//
// The exploration knows which orders of events are possible, but no moments. Here every instant of
// the path gets one such that exactly those delays end that are to end: a system of difference
// constraints
//
//     t(i+1) >= t(i) + gap                       instants follow one another
//     t(i)    = t(s) + d                         a delay of length d, begun at s, ends at i
//     t(i)   <= t(s) + d - gap                   one that is still running at i has not ended
//
// solved as longest paths (Bellman-Ford); a cycle that keeps growing means that no moments fit.
//
// With an arbitrarily small gap every path of the exploration fits. How small is enough? A cycle of
// constraints is possible if the lengths in it, some added and some subtracted, leave room for the
// gaps in it. All lengths are multiples of their greatest common divisor, so a cycle that leaves
// any room leaves that much; and it holds one gap per instant at most.

#include <algorithm>
#include <numeric>

#include "check/path.h"

namespace grafwire {

namespace {

/// t[to] >= t[from] + distance
struct Constraint {
    std::size_t from = 0;
    std::size_t to = 0;
    Time distance = 0;
};

std::vector<Constraint> constraints_of(const std::vector<PathStep>& path, Time gap) {
    std::vector<Constraint> constraints;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i != 0) constraints.push_back({i - 1, i, gap});
        for (const RunningDelay& delay : path[i].running) {
            if (delay.ends) {
                constraints.push_back({delay.begun, i, delay.length});
                constraints.push_back({i, delay.begun, -delay.length});
            } else {
                constraints.push_back({i, delay.begun, gap - delay.length});
            }
        }
    }
    return constraints;
}

/// The earliest moments, from 0 on.
std::optional<std::vector<Time>> solve(const std::vector<Constraint>& constraints,
                                       std::size_t instants) {
    std::vector<Time> at(instants, 0);
    for (std::size_t round = 0; round <= instants; ++round) {
        bool changed = false;
        for (const Constraint& constraint : constraints) {
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

std::vector<Stimuli::Assignment> differences(const InputValues& from, const InputValues& to) {
    std::vector<Stimuli::Assignment> assignments;
    for (std::uint32_t input = 0; input < to.size(); ++input) {
        if (from[input] != to[input]) assignments.push_back({input, to[input] != 0});
    }
    return assignments;
}

std::vector<Time> gaps_for(const std::vector<PathStep>& path) {
    std::vector<Time> gaps{100 * millisecond, millisecond, 10 * microsecond, microsecond};
    Time grain = 0;
    for (const PathStep& step : path) {
        for (const RunningDelay& delay : step.running) grain = std::gcd(grain, delay.length);
    }
    if (grain == 0) return gaps;
    const Time enough = grain / static_cast<Time>(path.size() + 1);
    Time smallest = gaps.back();
    while (smallest > enough && smallest > 1) smallest /= 10;
    if (smallest < gaps.back()) gaps.push_back(smallest);
    return gaps;
}

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
    const auto moments = solve(constraints_of(path, gap), path.size());
    if (!moments) return std::nullopt;

    Stimuli stimuli;
    previous.assign(grafcet.all_input_count(), 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        Stimuli::Change change;
        change.at = (*moments)[i];
        change.assignments = differences(previous, values[i]);
        previous = values[i];
        // An instant at which only a delay ends, or nothing changes, comes about by itself; but the
        // latter would not, so its line stays.
        const bool comes_by_itself = change.assignments.empty() && !path[i].ended.none();
        if (!comes_by_itself) stimuli.changes.push_back(std::move(change));
    }
    stimuli.end = moments->back();
    return stimuli;
}

}  // namespace grafwire
