#pragma once

#include <string>

#include "grafcet/grafcet.h"
#include "ladder/ladder.h"
#include "text/message.h"

namespace grafwire::plcopen {

/// A PLCopen TC6 XML 2.01 project with two programs: the ladder diagram, which is the GRAFCET scan
/// for scan, and a sequential function chart of it, which is so too as far as SFC can say it, and
/// tells the rest in comments. Names are made identifiers; the mapping stands in the documentation.
/// Documentation and comments of the chart are in the language; those of the diagram are its own.
std::string write_project(const Grafcet& grafcet, const ladder::Ladder& ladder,
                          Language language = Language::english);

/// The identifiers of the variables of a diagram, in their order.
std::vector<std::string> identifiers_of(const ladder::Ladder& ladder);

}  // namespace grafwire::plcopen
