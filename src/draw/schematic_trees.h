#pragma once

#include <cstdint>
#include <vector>

#include "draw/schematic_nets.h"
#include "netlist/netlist.h"
#include "text/table.h"

namespace grafwire {

// How the cells of a module hang together in its schematic: in trees, whose root is a gate at the
// right edge, and in which each gate stands left of all that read it.

/// A gate within a tree.
struct TreeGate {
    CellId cell = no_cell;
    std::uint32_t column = 0;           ///< from the right edge, 0 there
    std::vector<std::uint32_t> inputs;  ///< by pin: the gate of the tree that hangs there, or none
    std::vector<std::uint32_t> order;   ///< its pins, from the uppermost one down
};

/// The first gate is the root. A latch made of two gates has two: its upper gate, and `partner`.
struct GateTree {
    std::vector<TreeGate> gates;
    std::uint32_t partner = none;
};

/// The trees of some cells. Each cell is in one of them; what a tree does not join is joined by
/// name, or by what the layout adds. None is deeper than a sheet is wide, or has more inputs than
/// it is high. Pins of a tree are in the order of the cell, but that the way back from its root
/// comes last, and the two inputs through which a latch holds itself face each other.
std::vector<GateTree> trees_of(const SchematicNets& nets, Range<CellId> cells);

}  // namespace grafwire
