#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "evolution/evolution.h"
#include "grafcet/grafcet.h"

namespace grafwire {

using Transitions = std::vector<TransitionId>;

inline bool contains(const Transitions& transitions, TransitionId id) {
    return std::find(transitions.begin(), transitions.end(), id) != transitions.end();
}

/// Some of what can be cleared in a state, and the state that follows, by its number.
struct Way {
    Transitions chosen;
    std::size_t to = 0;
};

/// A state between the beginning of an instant and its end, in some order.
struct OrderNode {
    EvolutionState state;
    Transitions clearable;
    Transitions by_edge;  ///< among them, those that were waiting for an edge that has come
    std::size_t parent = 0;
    Transitions chosen;     ///< what was cleared to come here from the parent
    std::vector<Way> ways;  ///< the last: all cleared at once
    bool is_end = false;
};

/// States among which one can go round for ever, though every transition that can be cleared all
/// the time is cleared at some time; none: there are no such.
std::vector<std::size_t> endless_part(const std::vector<OrderNode>& nodes);

}  // namespace grafwire
