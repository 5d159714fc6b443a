#pragma once

#include <string>

#include "random/random_source.h"

namespace grafwire::testing {

/// A random GRAFCET of two sequences of one token each, as people write them: selections that
/// exclude each other, delayed and time-limited actions, bits that are set and reset, counters,
/// actions on events, edges of steps and of conditions. No two writes of a variable ever meet in a
/// scan, so that a sequential function chart can say all of it.
std::string sequence_chart(RandomSource& random);

}  // namespace grafwire::testing
