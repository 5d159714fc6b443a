#pragma once

#include <string>
#include <string_view>

#include "evolution/run.h"
#include "grafcet/grafcet.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

/// Reads a text that has no errors; fails the test with the messages otherwise.
Grafcet grafcet_from(std::string_view text);
Stimuli stimuli_from(std::string_view text, const Grafcet& grafcet);

/// The named columns (separated by spaces) of a trace: a line `time_ms value value …` per row.
std::string rows(const Trace& trace, std::string_view columns);

/// The rows of a run until stable; a line `unstable at TIME: NAMES` follows where it ends early.
std::string until_stable(std::string_view grafcet, std::string_view stimuli,
                         std::string_view columns);
/// The rows of a run scan by scan.
std::string scans(std::string_view grafcet, std::string_view stimuli, Time period,
                  std::string_view columns);

}  // namespace grafwire::testing
