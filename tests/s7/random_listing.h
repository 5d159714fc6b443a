#pragma once

#include <cstdint>

#include "s7/listing.h"

namespace grafwire::testing {

/// A listing that a CPU 214 accepts: a main program and up to three subroutines, with any
/// instruction, on the first few addresses of each area so that they meet. It always comes to an
/// end: jumps go forwards.
s7::Listing random_listing(std::uint64_t seed);

}  // namespace grafwire::testing
