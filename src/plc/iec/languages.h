#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

// Writers of the textual languages of IEC 61131-3 (edition 2); see the table in plc/formats.cpp. An
// integer that needs more than the 64 bits of LINT is an error, and the text is empty then.

/// The program as a function block in Instruction List (section 3.2).
std::string write_il(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     Diagnostics& diagnostics);

/// The program as a function block in Structured Text (section 3.3).
std::string write_st(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     Diagnostics& diagnostics);

}  // namespace grafwire
