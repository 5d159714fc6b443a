#pragma once

#include <memory>
#include <string>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// Runs a PL7-2 listing: rungs of the preliminary processing, then one evolution of the chart by an
/// engine of its own (all transitions on the situation the scan begins with; a step that is left
/// and entered stays active), then rungs of the posterior processing. Instead of the evolution, as
/// the preliminary processing says: SY21 gives the initial situation, SY22 the empty one, SY23 the
/// steps as they were set and reset there, which is not allowed elsewhere (after Schneider, PL7
/// reference manual 35015365, "Description of preliminary processing"). Shares nothing with what
/// writes such listings.
std::unique_ptr<PlcMachine> pl7_machine(const std::string& text, const Grafcet& grafcet);

}  // namespace grafwire::testing
