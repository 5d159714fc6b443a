#pragma once

#include <memory>
#include <string>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// Runs a function block in Instruction List (IEC 61131-3, edition 2, table 52): LD, ST, S, R, AND,
/// OR, XOR with N and parentheses, NOT, ADD, SUB, comparisons, MAX, MIN, jumps and CAL of timers.
/// Shares nothing with what writes such programs.
std::unique_ptr<PlcMachine> il_machine(const std::string& text, const Grafcet& grafcet);

}  // namespace grafwire::testing
