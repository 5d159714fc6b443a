#pragma once

#include <string>

#include "equations/report/page.h"
#include "equations/report/report_parts.h"
#include "equations/report/words.h"
#include "equations/report/write_equations.h"

namespace grafwire {

// The reports behind write_equations.

void write_report(Reported& reported, const EquationReport& report, Page& page);
void write_karnaugh(Reported& reported, StepId step, const Words& words, Page& page);
std::string write_csv_report(Reported& reported);
std::string write_json_report(Reported& reported, bool with_minimised);

}  // namespace grafwire
