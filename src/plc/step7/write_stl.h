#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The program in Statement List for STEP 7, SIMATIC S7-300 and S7-400 (AWL; the course "Mise en
/// œuvre du GRAFCET", section 3.2): a source file with FC 1, which is one scan, OB 1, which calls
/// it, and OB 100, which has the next scan begin in the initial situation.
std::string write_stl(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                      Diagnostics& diagnostics);

}  // namespace grafwire
