#pragma once

#include <memory>
#include <string>

#include "plc/plc_machine.h"

namespace grafwire::testing {

/// Runs a PL7-2 listing: rungs of the preliminary processing, then one evolution of the chart by an
/// engine of its own (all transitions on the situation the scan begins with; a step that is left
/// and entered stays active), then rungs of the posterior processing. Shares nothing with what
/// writes such listings.
std::unique_ptr<PlcMachine> pl7_machine(const std::string& text, const Grafcet& grafcet);

}  // namespace grafwire::testing
