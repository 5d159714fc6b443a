#pragma once

#include <vector>

#include "plc/pl7/pl7_objects.h"
#include "plc/pl7/pl7_rungs.h"
#include "program/program.h"
#include "text/message.h"

namespace grafwire {

/// Whether the chart has forcing orders or enclosures, so that its own evolution is not enough.
bool has_orders(const Grafcet& grafcet);

/// Rungs of the preliminary processing that work out, an internal bit a step, the situation that
/// the scan is to reach, and make SY23 where the controller's own evolution, or SY21 under Init,
/// would not reach it. `conditions` are those of the transitions, in their order, over bits that
/// the rungs before have written.
void write_situation(const Grafcet& grafcet, const ScanProgram& program,
                     const std::vector<Condition>& conditions, Language language,
                     Pl7Objects& objects, Pl7Rungs& rungs);

/// Rungs that, where SY23 is 1, set and reset all steps as worked out. The last of the preliminary
/// processing.
void write_presets(const Grafcet& grafcet, Language language, Pl7Objects& objects, Pl7Rungs& rungs);

}  // namespace grafwire
