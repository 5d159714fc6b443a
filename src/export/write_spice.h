#pragma once

#include <string>

#include "export/bench.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The netlist and a bench as one ngspice deck (ngspice 39 or later) of XSPICE digital models.
/// `ngspice -b` on it prints the sampled outputs with `eprint`: a row in which the node `sample`
/// has come back to 0 shows them as they were at one instant, instant after instant. Clocked timers
/// have no counterpart there; a netlist with one is refused.
std::string write_spice(const Netlist& netlist, const Bench& bench, Diagnostics& diagnostics);

}  // namespace grafwire
