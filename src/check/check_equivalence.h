#pragma once

#include "check/check_result.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"

namespace grafwire {

/// Compares a netlist with the reference evolution: an asynchronous one in every stable situation
/// that can be reached, a clocked one after every scan, under every change of the inputs that can
/// matter there. The ports must fit (compare_ports), and every timer cell must say which time
/// condition it stands for.
CheckResult check_equivalence(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const CheckOptions& options);

/// The same for the changes asked for alone: `together` stays empty.
CheckResult check_changes(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                          const CheckOptions& options);

}  // namespace grafwire
