#pragma once

#include <string>

#include "netlist/netlist.h"

namespace grafwire {

/// The netlist in figures: cells by type, feedback loops with the steps in them, the largest
/// fan-out, and the depth of the logic outside the loops. Flip-flops cut loops and paths.
std::string write_stats(const Netlist& netlist);

}  // namespace grafwire
