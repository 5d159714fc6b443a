#pragma once

#include <string>

#include "ladder/ladder.h"
#include "random/random_source.h"
#include "s7/listing.h"

namespace grafwire::testing {

// One slip of the hand, drawn at random; `told` says in words which. A listing may come out as one
// that no controller accepts.

ladder::Ladder mutated(ladder::Ladder ladder, RandomSource& random, std::string& told);
s7::Listing mutated(s7::Listing listing, RandomSource& random, std::string& told);

}  // namespace grafwire::testing
