#pragma once

#include "check/check_result.h"
#include "check/running_delays.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"

namespace grafwire {

/// What an exploration of the pairs (reference, netlist) goes through.
struct ExplorationPlan {
    Changes changes = Changes::one;  ///< of asynchronous netlists
    Passing passing = Passing::free;
    Time period = 0;  ///< of Passing::by_a_period
};

struct ExplorationResult {
    CheckResult result;
    /// Ended without a verdict, because the lengths of delays were ignored and matter.
    bool needs_lengths = false;
};

/// Goes through every case that can be reached, asynchronous netlists instant by instant, clocked
/// ones scan by scan, within the bounds of `options`.
ExplorationResult explore(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                          const CheckOptions& options, const ExplorationPlan& plan);

}  // namespace grafwire
