#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The program as a listing in PL7-2, for Telemecanique TSX 17-20, TSX 27 and TSX 47 (the course
/// "Mise en œuvre du GRAFCET", section 3.3): preliminary processing, the chart itself with its
/// receptivities, posterior processing. The controller evolves the chart by its own means; what it
/// cannot evolve (forcing orders, enclosures, source and sink transitions) is an error.
std::string write_pl7(const ScanProgram& program, const PlcOptions& options,
                      Diagnostics& diagnostics);

}  // namespace grafwire
