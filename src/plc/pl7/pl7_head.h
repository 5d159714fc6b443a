#pragma once

#include <string>

#include "plc/pl7/pl7_objects.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// An error for each thing of the chart that the GRAFCET of a PL7-2 controller does not have.
void check_pl7_chart(const Grafcet& grafcet, Diagnostics& diagnostics);

/// What a listing begins with: the title, its conventions, the assignment of objects.
std::string pl7_head(const ScanProgram& program, Pl7Objects& objects);

/// The steps of the chart, a line each; `#` marks the initial ones, as in the printouts.
std::string pl7_steps(const ScanProgram& program, Pl7Objects& objects);

}  // namespace grafwire
