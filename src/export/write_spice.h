#pragma once

#include <string>

#include "export/bench.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The netlist and a bench as one ngspice deck of XSPICE digital models; `ngspice -b` on it prints,
/// for every row of the bench, the outputs that are 1.
std::string write_spice(const Netlist& netlist, const Bench& bench, Time scan_period,
                        Diagnostics& diagnostics);

}  // namespace grafwire
