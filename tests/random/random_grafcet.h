#pragma once

#include <string>

#include "random/features.h"
#include "random/random_source.h"

namespace grafwire::testing {

/// The text of a random GRAFCET without errors, one item a line.
std::string random_grafcet(RandomSource& random, const Features& features);

}  // namespace grafwire::testing
