#pragma once

#include <cstdint>

#include "evolution/evaluate.h"
#include "evolution/evolution.h"
#include "evolution/small_list.h"
#include "evolution/tables.h"

namespace grafwire {

/// What the subroutines of one scan work on.
struct ScanContext {
    const Grafcet& grafcet;
    const EvolutionTables& tables;
    EvolutionState& state;
    Evaluator read;  ///< reads `state` as it is at the time
    Time now;
};

/// The transitions cleared in a scan.
using ClearedList = SmallList<TransitionId, 32>;

/// SBR 5 up to AUdur: forcing, enclosures. `init` is the value of Init.
void apply_forcing(const ScanContext& scan, bool init);

/// The last part of SBR 5. `cleared` in any order.
void run_stored_actions(const ScanContext& scan, const ClearedList& cleared);

/// SBR 6.
void update_time_conditions(const ScanContext& scan);

}  // namespace grafwire
