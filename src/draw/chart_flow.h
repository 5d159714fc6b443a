#pragma once

#include <cstdint>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

// How a graph, or the expansion of a macro-step, reads from top to bottom: what follows what on one
// line, where branches begin and come together, which links lead back up. Without any measure yet.

/// A step, a macro-step or a transition.
struct FlowNode {
    enum class Kind : std::uint8_t { step, macro, transition } kind = Kind::step;
    std::uint32_t index = 0;           ///< a StepId, MacroId or TransitionId
    std::vector<std::uint32_t> next;   ///< the nodes that its links lead to, in the order written
    std::vector<std::uint32_t> named;  ///< the nodes from which a cut link leads here
    bool is_initial = false;
};

struct FlowSequence;

/// A part of a sequence: a node, with the branches beside the line that begin below it; or
/// branches that all begin below the node before.
struct FlowPiece {
    std::uint32_t node = none;
    std::vector<FlowSequence> branches;       ///< node none: in the order of the file
    std::vector<FlowSequence> before, after;  ///< left of the line and right of it
};

/// What stands on one vertical line.
struct FlowSequence {
    std::vector<FlowPiece> pieces;
    /// How it goes on below: into what follows the branches that it is one of; up, to a step above;
    /// to a step that stands elsewhere, whose name is written; or not at all. Where the last piece
    /// is a set of branches, each of them has its own end, or all those that are `into` have this
    /// one.
    enum class End : std::uint8_t { stops, into, up, named } end = End::stops;
    std::uint32_t target = none;  ///< of `up` and `named`
};

struct ChartFlow {
    std::vector<FlowNode> nodes;
    /// From left to right: those that begin with the initial steps, then those of sources, then
    /// what no link reaches.
    std::vector<FlowSequence> sequences;
};

ChartFlow flow_of(const Grafcet& grafcet, BlockId block);

}  // namespace grafwire
