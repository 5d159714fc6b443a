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

/// Looks for an oscillation beside X and outputs that are right: in parts on which none of these
/// depends, which the exploration does not go through for their own sake, and in memories that have
/// never been given a value (`has_open_memory`). Walks at random, from known values at power-up.
/// Found, it is shown; not found, nothing is said.
std::optional<Witness> oscillation_beside(const Grafcet& grafcet, const Netlist& netlist,
                                          const CellDelays& delays, const CheckOptions& options,
                                          bool has_open_memory);

}  // namespace grafwire
