#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

// Ladder diagrams (src/ladder) as rows of the table of languages.

std::string write_ladder_text(const Grafcet& grafcet, const ScanProgram& program,
                              const PlcOptions& options, Diagnostics& diagnostics);
std::string write_ladder_svg(const Grafcet& grafcet, const ScanProgram& program,
                             const PlcOptions& options, Diagnostics& diagnostics);
std::string write_plcopen(const Grafcet& grafcet, const ScanProgram& program,
                          const PlcOptions& options, Diagnostics& diagnostics);

}  // namespace grafwire
