#pragma once

#include <cstdint>
#include <vector>

#include "s7/listing.h"

namespace grafwire::s7 {

/// A printed offset at which the instruction before it does not end.
struct OffsetDeviation {
    std::uint32_t network = 0;
    std::uint32_t printed = 0;
    std::uint32_t computed = 0;  ///< the printed offset of the instruction before it, and its size
    Location where;
};

/// Compares each printed offset with the one before it, so that one misprint is one deviation,
/// whatever follows. Instructions without offset count with their size.
std::vector<OffsetDeviation> offset_deviations(const Listing& listing);

/// Gives every instruction its offset from the beginning of the program.
void set_offsets(Listing& listing);

}  // namespace grafwire::s7
