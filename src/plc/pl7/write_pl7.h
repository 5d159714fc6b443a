#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The program as a listing in PL7-2, for Telemecanique TSX 17-20, TSX 27 and TSX 47 (the course
/// "Mise en œuvre du GRAFCET", section 3.3): preliminary processing, the chart itself with its
/// transition conditions, posterior processing. The controller evolves the chart by its own means;
/// in scans in which forcing orders or enclosures want another situation, that one is preset.
/// Errors: more objects than the controller has, durations that no timer holds, integers beyond 16
/// bits.
std::string write_pl7(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                      Diagnostics& diagnostics);

}  // namespace grafwire
