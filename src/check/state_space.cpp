// The state space of an exploration: which product states it has reached, and by what path.
//
// A state reached again is new only if more can remain of its delays than before: its zone is
// compared with those it was reached with, and none that another includes is kept (inclusion of
// zones, as for timed automata: see zone.cpp).
//
// Inputs that a state does not depend on are unassigned there. What a later step of a path needs of
// them is assigned when the path is asked for, from its end back to the root.

#include "check/state_space.h"

#include <algorithm>
#include <map>

namespace grafwire {

namespace {

/// The first inputs where they say something, else the second.
PartialInputs merged(PartialInputs first, const PartialInputs& second) {
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] == PartialInput::unassigned) first[i] = second[i];
    }
    return first;
}

/// Whether the inputs are as wanted, where the latter says something.
bool agree(const PartialInputs& inputs, const PartialInputs& wanted) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (wanted[i] != PartialInput::unassigned && inputs[i] != wanted[i]) return false;
    }
    return true;
}

}  // namespace

bool VisitedStates::add(const std::string& encoding, const Zone& zone) {
    std::vector<Zone>& zones = zones_[encoding];
    for (const Zone& seen : zones) {
        if (seen.includes(zone)) return false;
    }
    std::erase_if(zones, [&](const Zone& seen) { return zone.includes(seen); });
    zones.push_back(zone);
    return true;
}

bool VisitedStates::is_covered(const std::string& encoding, const Zone& zone) const {
    const std::vector<Zone>& zones = zones_.at(encoding);
    return std::find(zones.begin(), zones.end(), zone) == zones.end();
}

/// What a later step needs of the inputs that are unassigned all through a step, assigned before it
/// as well, so that the step changes no more than it did; if the plant allows that.
void PredecessorTree::assign_throughout(PathStep& step, const PartialInputs& wanted,
                                        bool is_first) const {
    PathStep assigned = step;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (step.inputs[i] != PartialInput::unassigned || wanted[i] == PartialInput::unassigned)
            continue;
        assigned.inputs[i] = wanted[i];
        assigned.before[i] = wanted[i];
    }
    if (is_first) assigned.before = assigned.inputs;
    if (assumptions_.can_hold(assigned.inputs) && assumptions_.can_hold(assigned.before)) {
        step = std::move(assigned);
    }
}

void PredecessorTree::add(std::uint32_t predecessor, PathStep step) {
    nodes_.push_back({predecessor, std::move(step)});
}

std::vector<PathStep> PredecessorTree::path(std::uint32_t predecessor, PathStep last) const {
    std::vector<PathStep> path{std::move(last)};
    std::map<std::size_t, std::size_t> from_end;  // per step of the path: its place, from the end
    for (std::uint32_t at = predecessor; at != root; at = nodes_[at].predecessor) {
        // What a later step assigns in the state it leaves was unassigned there. So it can be
        // assigned in the step that led there, if the plant allows that; else it changes in
        // between, which has no effect.
        PathStep step = nodes_[at].step;
        const PartialInputs wanted = path.back().before;
        if (!inserts_) {
            assign_throughout(step, wanted, nodes_[at].predecessor == root);
            from_end[at] = path.size();
            path.push_back(std::move(step));
            continue;
        }
        PartialInputs reached = merged(step.inputs, wanted);
        const bool can_be = assumptions_.can_hold(reached);
        if (!can_be) reached = step.inputs;
        if (!can_be || !agree(reached, wanted)) path.push_back({reached, wanted, {}, {}});
        step.inputs = reached;
        if (nodes_[at].predecessor == root) step.before = step.inputs;
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
