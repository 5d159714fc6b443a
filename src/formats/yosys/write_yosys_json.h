#pragma once

#include <string>

#include "netlist/netlist.h"

namespace grafwire {

/// The netlist as Yosys reads it with read_json. Every cell is one Yosys cell of the same function,
/// so that reading it back gives the same netlist; what Yosys does not have is a black box named
/// `grafwire_…`, declared in the same file.
std::string write_yosys_json(const Netlist& netlist);

}  // namespace grafwire
