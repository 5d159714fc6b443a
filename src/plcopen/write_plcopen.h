#pragma once

#include <string>

#include "ladder/ladder.h"
#include "program/program.h"

namespace grafwire::ladder {

/// A PLCopen TC6 XML 2.01 project with two programs: the ladder diagram, which is the GRAFCET scan
/// for scan, and a sequential function chart of it, which is so too as far as SFC can say it, and
/// tells the rest in comments. Names are made identifiers; the mapping stands in the documentation.
std::string write_plcopen(const ScanProgram& program, const Ladder& ladder);

/// The identifiers of the variables of a diagram, in their order.
std::vector<std::string> identifiers_of(const Ladder& ladder);

}  // namespace grafwire::ladder
