#pragma once

#include "check/check_result.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"

namespace grafwire {

/// What becomes of an asynchronous netlist that is equivalent under Changes::one where many inputs
/// change at once. `unexercised`: what Changes::one did not exercise.
Together look_at_many(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                      const CheckOptions& options, const NeverExercised& unexercised);

}  // namespace grafwire
