#pragma once

#include "ladder/ladder.h"
#include "program/program.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire::ladder {

/// The ladder diagram of a GRAFCET: a rung per transition says which are cleared, then every step
/// is reset by the transitions out of it and set by those into it (course "Mise en œuvre du
/// GRAFCET", section 3.1). Inputs, outputs, steps, vars and counters keep the names of the chart.
/// Remarks, headings and comments are in the language. Sums of counters beyond 64 bits are an
/// error.
Ladder ladder_from(const Grafcet& grafcet, const ScanProgram& program, Diagnostics& diagnostics,
                   Language language = Language::english);

}  // namespace grafwire::ladder
