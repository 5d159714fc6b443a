#pragma once

#include "equations/equations.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Writes the equation that a module was made from into its comment: of steps, outputs, stored
/// outputs and vars.
void annotate(Netlist& netlist, const Grafcet& grafcet, const Equations& equations);

}  // namespace grafwire
