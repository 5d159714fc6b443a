#pragma once

#include <cstddef>
#include <vector>

#include "draw/chart_flow.h"

namespace grafwire {

// Sequences cut in two for sheets of paper: at links from transitions to steps, as IEC 60848 has
// it. The ends that are cut carry the name of the step, and the step the names of the transitions.

/// The numbers of the pieces before which a sequence may be cut, in their order.
std::vector<std::size_t> places_to_cut(const std::vector<FlowNode>& nodes,
                                       const FlowSequence& sequence);

/// Cuts a sequence before one of these pieces; returns the rest.
FlowSequence cut_before(std::vector<FlowNode>& nodes, FlowSequence& sequence, std::size_t piece);

/// Cuts one of the branches within a sequence, so that about half of it goes, and returns what is
/// cut off, a sequence of its own; nothing where no branch can be cut.
std::vector<FlowSequence> cut_largest_branch(std::vector<FlowNode>& nodes, FlowSequence& sequence);

}  // namespace grafwire
