#pragma once

#include <string>

#include "netlist/netlist.h"

namespace grafwire {

/// The netlist as a Graphviz graph: a node per cell, in a cluster per module, and a node per port.
/// A node shows the net it drives, what it is, and what of the GRAFCET it was made for.
std::string write_dot(const Netlist& netlist);

}  // namespace grafwire
