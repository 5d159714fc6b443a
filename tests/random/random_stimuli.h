#pragma once

#include <cstddef>
#include <string>

#include "grafcet/grafcet.h"
#include "random/random_source.h"

namespace grafwire::testing {

/// The text of random stimuli for a GRAFCET, one line per change, in whole milliseconds; the
/// control inputs change rarely. `lines` changes at most, plus an end.
std::string random_stimuli(RandomSource& random, const Grafcet& grafcet, std::size_t lines);

}  // namespace grafwire::testing
