#pragma once

#include <optional>

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
                              const CheckOptions& options);

// What check_equivalence puts its verdict together from.

/// The verdict for the changes asked for alone: `together` stays empty, and parts on which no X and
/// no output depends are not looked at.
CheckResult check_changes(const Grafcet& grafcet, const Netlist& netlist,
                          const CheckOptions& options);

/// What becomes of an asynchronous netlist that is equivalent under Changes::one where many inputs
/// change at once. `unexercised`: what Changes::one did not exercise.
Together check_many_changes(const Grafcet& grafcet, const Netlist& netlist,
                            const CheckOptions& options, const NeverExercised& unexercised);

/// Looks for an oscillation beside X and outputs that are right: in parts on which none of these
/// depends, which the exploration does not go through for their own sake, and in memories that have
/// never been given a value (`has_uninitialised_memory`). Walks at random, from known values at
/// power-up. Found, it is a witness; not found, nothing is said.
std::optional<Witness> find_unobserved_oscillation(const Grafcet& grafcet, const Netlist& netlist,
                                                   const CheckOptions& options,
                                                   bool has_uninitialised_memory);

}  // namespace grafwire
