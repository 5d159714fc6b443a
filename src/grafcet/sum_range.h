#pragma once

#include <cstdint>
#include <optional>

#include "grafcet/grafcet.h"

namespace grafwire {

/// The smallest and the largest value that any partial sum can take on the way, the terms taken in
/// order; empty where that is beyond 64 bits. For languages whose integers are narrower.
struct IntegerRange {
    std::int64_t low = 0;
    std::int64_t high = 0;
};
std::optional<IntegerRange> range_of(const Grafcet& grafcet, const Sum& sum);
/// The smallest and the largest value of the whole sum; of one that range_of is not empty for.
IntegerRange value_range(const Grafcet& grafcet, const Sum& sum);

}  // namespace grafwire
