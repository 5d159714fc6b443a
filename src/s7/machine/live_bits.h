#pragma once

#include <cstdint>
#include <vector>

#include "s7/machine/decoded.h"

namespace grafwire::s7 {

/// A mask per byte of memory: the bits whose value at the start of a scan can matter, for that
/// scan's course or for what is observed after it or any later one. Inputs and SMB0 are
/// not among them, because they are written again before each scan.
std::vector<std::uint8_t> live_bits(const Decoded& program, const std::vector<Operand>& observed);

}  // namespace grafwire::s7
