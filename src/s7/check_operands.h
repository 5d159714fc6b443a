#pragma once

#include "s7/addresses/cpu.h"
#include "s7/listing.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// The kinds of an instruction's operands, and that the controller has what they name.
void check_operands(const Instruction& instruction, const CpuRow& cpu, Diagnostics& diagnostics);

}  // namespace grafwire::s7
