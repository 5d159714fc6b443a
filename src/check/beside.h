#pragma once

#include <optional>
#include <vector>

#include "check/check_result.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"
#include "text/keep_going.h"

namespace grafwire {

/// Per net, 1 where one of the `roots` can ever depend on it.
std::vector<std::uint8_t> relevant_nets(const Netlist& netlist, const std::vector<NetId>& roots);

/// Looks for an oscillation in parts of a netlist on which neither an X nor an output depends,
/// which the exploration does not go through for their own sake: walks at random, from known values
/// at power-up. Found, it is shown; not found, nothing is said.
std::optional<Witness> oscillation_beside(const Grafcet& grafcet, const Netlist& netlist,
                                          const CellDelays& delays, const CheckOptions& options);

}  // namespace grafwire
