#pragma once

#include <cstdint>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// Per cell, 1 where it lies on a loop of cells without a memory of their own: a latch made of
/// gates, a ring of inverters. Cells with a memory cut loops, as their outputs do not follow their
/// inputs at once. So the outputs of cells with a memory and of those on loops are all that a
/// settled netlist remembers; every other net follows from them and the inputs.
std::vector<std::uint8_t> cells_on_loops(const Netlist& netlist);

}  // namespace grafwire
