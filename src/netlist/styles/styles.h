#pragma once

#include "equations/equations.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

// The makers of style_table, each in a file of its own: style_NAME.cpp.

Netlist make_gates(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_nand(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_nor(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_clocked(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);

}  // namespace grafwire
