#pragma once

#include <string>

#include "equations/report/page.h"
#include "equations/report/words.h"
#include "equations/report/write_equations.h"

namespace grafwire {

// The reports behind write_equations. The equations are a copy that may grow: right-hand sides and
// minimised forms are added to its pool as they are needed.

void write_report(Equations& equations, const EquationReport& report, Page& page);
void write_karnaugh(Equations& equations, StepId step, const Words& words, Page& page);
std::string write_csv_report(Equations& equations);
std::string write_json_report(Equations& equations, bool with_minimised);

}  // namespace grafwire
