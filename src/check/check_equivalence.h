#pragma once

#include "check/check_result.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Compares a netlist with the reference evolution: an asynchronous one in every stable situation
/// that can be reached, a clocked one after every scan, under every change of the inputs that can
/// matter there. The ports must fit (compare_ports), and every timer cell must say which time
/// condition it stands for. Bounds and a stop by the caller (`options`) end it undecided.
///
/// An asynchronous netlist that is equivalent with one change at a time is looked at with many as
/// well, if the options say so; what comes of that is told apart (CheckResult::together) and does
/// not change the verdict.
CheckResult check_equivalence(const Grafcet& grafcet, const Netlist& netlist,
                              const CheckOptions& options);

/// The verdict for the changes asked for alone, from which the above puts its own together:
/// `together` stays empty, and parts on which no X and no output depends are not looked at.
CheckResult check_changes(const Grafcet& grafcet, const Netlist& netlist,
                          const CheckOptions& options);

}  // namespace grafwire
