#pragma once

#include "check/check_result.h"
#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"

namespace grafwire {

/// A witness of the same netlist that changes as few inputs as possible: none of its changes can be
/// left out. `options` say what may happen in one instant of it, and how long to look.
Witness smallest_witness(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                         Witness witness, const CheckOptions& options);

}  // namespace grafwire
