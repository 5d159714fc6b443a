#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "random/random_source.h"

namespace grafwire::testing {

/// The GRAFCETs of examples/ by their names, as texts.
std::map<std::string, std::string> texts_of_examples();

/// A small random chart of the kind that goes with the seed: a bit of everything, timers, a single
/// token, counters.
std::string chart_of(std::uint64_t seed);

/// The chart with a transition less, or with the conditions of two transitions exchanged: what
/// might have been built instead. Steps, inputs and outputs are the same.
std::string altered(const std::string& chart, RandomSource& random);

}  // namespace grafwire::testing
