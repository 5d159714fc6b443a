// A path through the product states made concrete: from partial inputs and orders of events to
// stimuli with times, which a run repeats.
//
// Instants. The exploration knows which orders of events are possible, but no times. Here every
// instant of the path gets one such that exactly those delays end that are to end: a system of
// difference constraints
//
//     t(i+1) >= t(i) + gap                       instants follow one another
//     t(i)    = t(s) + d                         a delay of length d, begun at s, ends at i
//     t(i)   <= t(s) + d - gap                   one that is still running at i has not ended
//
// solved as longest paths (Bellman-Ford: T. H. Cormen et al., "Introduction to Algorithms",
// "Difference constraints and shortest paths"); a cycle that keeps growing means that no times fit.
// With an arbitrarily small gap every path of the exploration fits. How small is enough? A cycle of
// constraints is possible if the lengths in it, some added and some subtracted, leave room for the
// gaps in it. All lengths are multiples of their greatest common divisor, so a cycle that leaves
// any room leaves that much; and it holds one gap per instant at most.
//
// Scans follow each other at 0, T, 2T, ... A delay of length d that begins at scan b has fallen due
// by scan i, and not by an earlier one, where
//
//     (i - b) T >= d      it has fallen due by scan i
//     (i - b) T <  d      it is still running after scan i
//
// so every path bounds T from below and from above, and any period within the bounds will do: one
// that is easy to read is taken.
//
// One input at a time. An input that is unassigned in a state can change there without an effect. A
// path says only what it has to be by the time something reads it, so several may have to be
// brought to their values between two of its instants. Each of these changes gets an instant of its
// own, in an order in which the assumptions hold all the way, which is searched for depth first.
// Where there is none (of two complementary contacts neither can change alone), they change
// together.

#include "check/path.h"

#include <algorithm>
#include <numeric>

namespace grafwire {

std::vector<Stimuli::Assignment> differences(const InputValues& from, const InputValues& to) {
    std::vector<Stimuli::Assignment> assignments;
    for (std::uint32_t input = 0; input < to.size(); ++input) {
        if (from[input] != to[input]) assignments.push_back({input, to[input] != 0});
    }
    return assignments;
}

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

/// The earliest times, from 0 on.
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
            for (Time& time : at) time -= first;
            return at;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<Time> gaps_for(const std::vector<PathStep>& path) {
    std::vector<Time> gaps{100 * millisecond, millisecond, 10 * microsecond, microsecond};
    Time quantum = 0;
    for (const PathStep& step : path) {
        for (const RunningDelay& delay : step.running) quantum = std::gcd(quantum, delay.length);
    }
    if (quantum == 0) return gaps;
    const Time enough = quantum / static_cast<Time>(path.size() + 1);
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
    const auto times = solve(constraints_of(path, gap), path.size());
    if (!times) return std::nullopt;

    Stimuli stimuli;
    previous.assign(grafcet.all_input_count(), 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        Stimuli::Change change;
        change.at = (*times)[i];
        change.assignments = differences(previous, values[i]);
        previous = values[i];
        // An instant at which only a delay ends, or nothing changes, comes about by itself; but the
        // latter would not, so its line stays.
        const bool comes_by_itself = change.assignments.empty() && !path[i].ended.none();
        if (!comes_by_itself) stimuli.changes.push_back(std::move(change));
    }
    stimuli.end = times->back();
    return stimuli;
}

namespace {

struct Bounds {
    Time lowest = 1;
    Time highest = hour;
};

Time divided_up(Time length, std::size_t by) {
    const auto parts = static_cast<Time>(by);
    return (length + parts - 1) / parts;
}

Bounds bounds_of(const std::vector<PathStep>& path) {
    Bounds bounds;
    for (std::size_t i = 0; i < path.size(); ++i) {
        for (const RunningDelay& delay : path[i].running) {
            const Time share = divided_up(delay.length, i - delay.begun);
            if (delay.ends) {
                bounds.lowest = std::max(bounds.lowest, share);
            } else {
                bounds.highest = std::min(bounds.highest, share - 1);
            }
        }
    }
    // With a delay longer than an hour that ends in one scan the period is as long.
    if (bounds.highest == hour) bounds.highest = std::max(hour, bounds.lowest);
    return bounds;
}

/// The roundest within the bounds, 10 ms if it is.
Time readable_period(const Bounds& bounds) {
    const Time usual = 10 * millisecond;
    if (bounds.lowest <= usual && usual <= bounds.highest) return usual;
    for (Time unit = 100 * second; unit > 1; unit /= 10) {
        const Time period = (bounds.lowest + unit - 1) / unit * unit;
        if (period <= bounds.highest) return period;
    }
    return bounds.lowest;
}

}  // namespace

std::optional<ScanStimuli> scans_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                     const std::vector<PathStep>& path, Time period) {
    const Bounds bounds = bounds_of(path);
    if (period != 0 ? period < bounds.lowest || period > bounds.highest
                    : bounds.lowest > bounds.highest) {
        return std::nullopt;
    }
    ScanStimuli scans;
    scans.period = period != 0 ? period : readable_period(bounds);
    InputValues previous(grafcet.all_input_count(), 0);
    for (const PathStep& step : path) {
        const auto values = assumptions.complete(step.inputs, previous);
        if (!values) return std::nullopt;
        std::vector<Stimuli::Assignment> changed = differences(previous, *values);
        if (!changed.empty() || scans.stimuli.changes.empty()) {
            scans.stimuli.changes.push_back({scans.stimuli.end, std::move(changed), {}});
        }
        previous = *values;
        scans.stimuli.end += scans.period;
    }
    scans.stimuli.end -= scans.period;
    return scans;
}

namespace {

constexpr int most_orders_tried = 2000;

/// Puts changes into an order in which the assumptions hold after each; false where none is found.
bool put_in_order(const Assumptions& assumptions, InputValues values,
                  std::vector<Stimuli::Assignment>& changes, std::size_t done, int& trials) {
    if (done == changes.size()) return true;
    for (std::size_t next = done; next < changes.size() && ++trials < most_orders_tried; ++next) {
        std::swap(changes[done], changes[next]);
        InputValues after = values;
        after[changes[done].input] = changes[done].value ? 1 : 0;
        if (assumptions.can_hold(assigned_inputs(after)) &&
            put_in_order(assumptions, after, changes, done + 1, trials)) {
            return true;
        }
        std::swap(changes[done], changes[next]);
    }
    return false;
}

/// Appends instants that bring the inputs from some values to others without an effect.
void append_changes(const Assumptions& assumptions, const InputValues& from, const InputValues& to,
                    std::vector<PathStep>& path) {
    std::vector<Stimuli::Assignment> changes = differences(from, to);
    int trials = 0;
    if (!put_in_order(assumptions, from, changes, 0, trials)) {
        path.push_back({assigned_inputs(from), assigned_inputs(to), {}, {}});
        return;
    }
    InputValues values = from;
    for (const Stimuli::Assignment& change : changes) {
        PathStep step;
        step.before = assigned_inputs(values);
        values[change.input] = change.value ? 1 : 0;
        step.inputs = assigned_inputs(values);
        path.push_back(std::move(step));
    }
}

}  // namespace

std::optional<Stimuli> first_stimuli_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                         const std::vector<PathStep>& path) {
    for (const Time gap : gaps_for(path)) {
        if (auto stimuli = stimuli_for(grafcet, assumptions, path, gap)) return stimuli;
    }
    return std::nullopt;
}

std::optional<std::vector<PathStep>> one_by_one(const Assumptions& assumptions,
                                                const std::vector<PathStep>& path,
                                                std::size_t input_count) {
    std::vector<PathStep> result;
    std::vector<std::size_t> place;  // per step of the path: where it stands in the result
    InputValues present(input_count, 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        PathStep step = path[i];
        if (i != 0) {
            const auto before = assumptions.complete(step.before, present);
            if (!before) return std::nullopt;
            append_changes(assumptions, present, *before, result);
            present = *before;
        }
        const auto inputs = assumptions.complete(step.inputs, present);
        if (!inputs) return std::nullopt;
        step.before = assigned_inputs(present);
        present = *inputs;
        step.inputs = assigned_inputs(present);
        for (RunningDelay& delay : step.running) delay.begun = place[delay.begun];
        place.push_back(result.size());
        result.push_back(std::move(step));
    }
    return result;
}

}  // namespace grafwire
