#pragma once

#include <span>
#include <vector>

#include "program/program.h"

namespace grafwire {

/// Steps `first` to `last`, both included, of one table.
struct StepRange {
    BitKind table = BitKind::step;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
};

/// The targets of a statement that are bits of step tables, table by table, neighbours as ranges.
std::vector<StepRange> step_ranges(std::span<const Bit> targets);

/// The other targets.
std::vector<Bit> single_bits(std::span<const Bit> targets);

}  // namespace grafwire
