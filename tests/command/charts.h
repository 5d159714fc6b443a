#pragma once

#include <string>

#include "support/files.h"

namespace grafwire::testing {

/// The charts that most requests are about, and stimuli for them.
inline const std::string sequence_chart = example("single-sequence.grafcet");
inline const std::string sequence_stimuli = example("single-sequence.stim");
inline const std::string rule_5_chart = example("rule-5.grafcet");
inline const std::string rule_5_stimuli = example("rule-5.stim");

}  // namespace grafwire::testing
