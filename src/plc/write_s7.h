#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The program as a listing of the table method for S7-200; see src/s7/README.md.
std::string write_s7(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     Diagnostics& diagnostics);

void check_s7_io(const Grafcet& grafcet, const PlcOptions& options, Diagnostics& diagnostics);

/// The addresses of that listing, as a table of assignment.
std::string write_s7_addresses(const Grafcet& grafcet, const ScanProgram& program,
                               const PlcOptions& options, Diagnostics& diagnostics);

}  // namespace grafwire
