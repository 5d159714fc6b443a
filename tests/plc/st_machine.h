#pragma once

#include <memory>
#include <string>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// Runs a function block in Structured Text: assignments, IF, FOR, calls of TON, TOF and LIMIT.
/// Shares nothing with what writes such programs.
std::unique_ptr<PlcMachine> st_machine(const std::string& text, const Grafcet& grafcet);

}  // namespace grafwire::testing
