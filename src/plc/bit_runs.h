#pragma once

#include <span>
#include <vector>

#include "program/program.h"

namespace grafwire {

/// Bits that stand one after the other in a table.
struct BitRun {
    Bit first;
    std::uint32_t count = 1;
};

/// The bits, in their order, with four or more neighbours in a table of steps or graphs taken
/// together, for languages that would rather write a loop.
std::vector<BitRun> bit_runs(std::span<const Bit> bits);

}  // namespace grafwire
