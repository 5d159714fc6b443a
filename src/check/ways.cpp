// Inputs that a state did not depend on were left open there; what a later step needs of them is
// settled here, from the end of the path back to its start.

#include "check/ways.h"

#include <algorithm>
#include <map>

namespace grafwire {

namespace {

/// The first inputs where they say something, else the second.
PartialInputs merged(PartialInputs first, const PartialInputs& second) {
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] == Logic::unknown) first[i] = second[i];
    }
    return first;
}

/// Whether the inputs are as wanted, where the latter says something.
bool agree(const PartialInputs& inputs, const PartialInputs& wanted) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (wanted[i] != Logic::unknown && inputs[i] != wanted[i]) return false;
    }
    return true;
}

}  // namespace

/// What a later step needs of the inputs that are open all through a step, before it as well, so
/// that the step changes no more than it did; if the plant allows that.
void Ways::close_all_along(PathStep& step, const PartialInputs& wanted, bool is_first) const {
    PathStep closed = step;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (step.inputs[i] != Logic::unknown || wanted[i] == Logic::unknown) continue;
        closed.inputs[i] = wanted[i];
        closed.before[i] = wanted[i];
    }
    if (is_first) closed.before = closed.inputs;
    if (assumptions_.can_hold(closed.inputs) && assumptions_.can_hold(closed.before)) {
        step = std::move(closed);
    }
}

void Ways::add(std::uint32_t parent, PathStep step) {
    steps_.push_back({parent, std::move(step)});
}

std::vector<PathStep> Ways::path(std::uint32_t parent, PathStep last) const {
    std::vector<PathStep> path{std::move(last)};
    std::map<std::size_t, std::size_t> from_end;  // per step on the way: its place, from the end
    for (std::uint32_t at = parent; at != start; at = steps_[at].parent) {
        // What a later step closes in the state it leaves was open there. So it can be closed in
        // the step that led there, if the plant allows that; else it changes in between, which has
        // no effect.
        PathStep step = steps_[at].step;
        const PartialInputs wanted = path.back().before;
        if (!inserts_) {
            close_all_along(step, wanted, steps_[at].parent == start);
            from_end[at] = path.size();
            path.push_back(std::move(step));
            continue;
        }
        PartialInputs reached = merged(step.inputs, wanted);
        const bool can_be = assumptions_.can_hold(reached);
        if (!can_be) reached = step.inputs;
        if (!can_be || !agree(reached, wanted)) path.push_back({reached, wanted, {}, {}});
        step.inputs = reached;
        if (steps_[at].parent == start) step.before = step.inputs;
        from_end[at] = path.size();
        path.push_back(std::move(step));
    }
    std::reverse(path.begin(), path.end());
    for (PathStep& step : path) {
        for (RunningDelay& delay : step.running) {
            delay.begun = path.size() - 1 - from_end.at(delay.begun);
        }
    }
    return path;
}

}  // namespace grafwire
