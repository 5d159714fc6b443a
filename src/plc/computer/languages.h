#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

// Writers of programming languages; see the table in formats.cpp.

std::string write_c(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                    Diagnostics& diagnostics);
std::string write_arduino(const Grafcet& grafcet, const ScanProgram& program,
                          const PlcOptions& options, Diagnostics& diagnostics);
std::string write_pascal(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics& diagnostics);
std::string write_python(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics& diagnostics);

}  // namespace grafwire
