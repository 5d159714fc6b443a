#pragma once

#include <cstddef>
#include <vector>

#include "netlist/netlist.h"
#include "netlist/part_families.h"

namespace grafwire {

/// What a netlist takes from a part family: the delays of one kind of its cells.
struct UsedFigures {
    CellType type = CellType::buffer;
    std::size_t inputs = 0;
    std::size_t cells = 0;  ///< how many of them the netlist has
    EdgeBands bands;
    /// The part that they are; nullptr where each is composed of several, whose delays add up. Such
    /// a cell is taken as one gate, so what may race within it is not looked at.
    const PartFigures* part = nullptr;
};

/// One for each type and number of inputs that the netlist has, in this order. Cells that the
/// family cannot give (timers of clocked netlists) are left out, and so are constants.
std::vector<UsedFigures> used_figures(const PartFamily& family, const Netlist& netlist);

}  // namespace grafwire
