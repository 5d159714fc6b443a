#pragma once

#include <string>

#include "trace/stimuli.h"

namespace grafwire::testing {

/// The times of a random chart ten times as long, for timers that count in steps of 10 ms.
std::string with_long_times(const std::string& chart);
Stimuli ten_times_as_long(Stimuli stimuli);

}  // namespace grafwire::testing
