#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The program as a function block in Instruction List (IEC 61131-3, edition 2, section 3.2).
std::string write_il(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     Diagnostics& diagnostics);

}  // namespace grafwire
