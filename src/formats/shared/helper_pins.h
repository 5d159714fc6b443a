#pragma once

#include <string>
#include <string_view>

#include "netlist/cell_types.h"

namespace grafwire {

/// The names of the pins of cells that are black boxes in file formats, in the order of the pins;
/// the output is `q`.
constexpr std::string_view helper_pin_name(CellType type, std::uint32_t pin) {
    switch (type) {
        case CellType::latch:
            return pin == 0 ? "s" : "r";
        case CellType::hold_latch:
            return pin == 0 ? "d" : "e";
        case CellType::flip_flop:
            return pin == 0 ? "d" : "c";
        case CellType::scan_timer_next:
            return pin == 0 ? "a" : pin == 1 ? "h" : "c";
        default:
            return pin == 0 ? "a" : "c";
    }
}

}  // namespace grafwire
