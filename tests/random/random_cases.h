#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "random/features.h"
#include "random/shrink.h"

namespace grafwire::testing {

/// How many cases a property is tried on: the environment variable GRAFWIRE_RANDOM_CASES if it is
/// set, else the given number, or a third of it where sanitizers make everything slower.
std::size_t case_count(std::size_t usual);

/// The random case of a seed.
RandomCase random_case(std::uint64_t seed, const Features& features, std::size_t stimuli_lines);

/// Tries a property on random cases, of seeds first_seed, first_seed + 1, …. The first that fails
/// is shrunk, and the test fails with its seed, the GRAFCET and the stimuli.
void check_property(const Property& property, const Features& features, std::uint64_t first_seed,
                    std::size_t usual_count, std::size_t stimuli_lines = 12);

}  // namespace grafwire::testing
