#pragma once

#include <optional>
#include <string>

#include "command/command_line.h"
#include "text/time.h"
#include "workflow/chart.h"

namespace grafwire {

/// Steps through a GRAFCET with what is typed at the terminal, or with lines from standard input:
/// then there is no prompt, and a line that is refused makes the request a bad one in the end.
/// `path`: the file of the chart, which no file that is saved may replace.
ExitStatus step_by_step(const std::string& path, const Chart& chart, std::optional<Time> period,
                        Language language);

}  // namespace grafwire
