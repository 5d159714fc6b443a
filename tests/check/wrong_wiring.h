#pragma once

#include <string>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire::testing {

/// The net of a name; a new one where there is none.
NetId net_named(Netlist& netlist, const std::string& name);

/// One more cell, in the last module, its pins by name.
void add_cell(Netlist& netlist, CellType type, const std::string& output,
              const std::vector<std::string>& pins, Logic initial = Logic::unknown);

/// Three inverters in a ring that runs while a net is 1 and nothing depends on.
void add_ring(Netlist& netlist, const std::string& while_one);

/// Moves the driver of a net to another net and drives the net by a gate over that and some more.
void put_gate_before(Netlist& netlist, const std::string& net, CellType type,
                     const std::vector<std::string>& more);

}  // namespace grafwire::testing
