#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "netlist/cell_types.h"
#include "netlist/part_figures.h"
#include "text/message.h"

namespace grafwire {

/// Parts that a netlist can be built from, and which of their figures are counted on.
struct PartFamily {
    std::string_view name;  ///< as users ask for it: `74HC`
    Message<> description;
    std::span<const PartFigures> parts;
    /// From 0.4 to 1.6 times the typical figures, in place of what the sheets allow.
    bool is_typical = false;
};

/// All families, each followed by its typical one.
std::span<const PartFamily> part_families();

/// The family of that name, nullptr if there is none.
const PartFamily* part_family_named(std::string_view name);

/// How long a cell with so many inputs takes from a change of an input to the rise and to the fall
/// of its output, at the least and at the most. A pulse cell: to the start of the pulse. Where no
/// part of the family is such a cell, it is composed of several (part_families.cpp says how). Empty
/// where that cannot be done: timers of clocked netlists, which no part is.
std::optional<EdgeBands> bands_of(const PartFamily& family, CellType type, std::size_t inputs);

/// The part that a cell with so many inputs is; nullptr where it is composed of several, or
/// lacking.
const PartFigures* part_for(const PartFamily& family, CellType type, std::size_t inputs);

}  // namespace grafwire
