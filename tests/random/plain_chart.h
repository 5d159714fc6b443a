#pragma once

#include <string>

#include "random/features.h"
#include "random/random_source.h"

namespace grafwire::testing {

/// The text of a chart that the wiring with the successor form of CDX ought to get right: a closed
/// sequence of at least three steps, with selections whose conditions exclude each other and
/// simultaneous sequences inside one another, levels of inputs as conditions, continuous outputs.
std::string plain_chart(RandomSource& random, const Features& features);

}  // namespace grafwire::testing
