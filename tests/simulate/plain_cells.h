#pragma once

#include <cstdint>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire::testing {

/// A cell as its definition says, in two values and nanosecond by nanosecond, without events: what
/// the simulation of a cell is judged by.
struct PlainCell {
    CellType type = CellType::buffer;
    std::int64_t rise = 1;  ///< delays, in nanoseconds
    std::int64_t fall = 1;
    std::int64_t width = 1;     ///< of pulses, in nanoseconds
    std::int64_t on_delay = 0;  ///< of timers, in instants
    std::int64_t off_delay = 0;
    bool initial = false;  ///< what a cell with a memory holds at first
};

/// The pins in one nanosecond.
struct PlainMoment {
    std::vector<bool> pins;
    std::int64_t instant = 0;  ///< the number of the instant that it belongs to
};

/// The output during these moments, one a nanosecond. The cell has been at rest with the pins of
/// the first moment, at which delays of timers may have begun.
/// `delays_end`: delays of timers end by themselves at the beginning of an instant; else those of
/// clocked timers end at a rise of the clock only.
std::vector<bool> plain_output(const PlainCell& cell, const std::vector<PlainMoment>& moments,
                               bool delays_end);

}  // namespace grafwire::testing
