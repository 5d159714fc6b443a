#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace grafwire::testing {

/// The GRAFCETs of examples/ by their names, as texts.
std::map<std::string, std::string> example_charts();

/// A small random chart of the kind that goes with the seed: a bit of everything, timers, a single
/// token, counters.
std::string chart_of(std::uint64_t seed);

}  // namespace grafwire::testing
