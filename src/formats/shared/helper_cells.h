#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// Cells that a file format has none for are black boxes there, or modules of our own. Their models
/// are called `grafwire_latch`, `grafwire_timer`, … after the cell table, and the output is `q`.

/// The names of the input pins of such a cell, in the order of its pins: `d` and `c` of a
/// flip-flop.
std::span<const std::string_view> helper_pins(CellType type);

/// What begins the names of the models in the file of a netlist: `grafwire_`, with further `_`
/// where the netlist itself is called so.
std::string helper_prefix(const Netlist& netlist);

/// The type behind the name of a model, whatever netlist it was written for.
std::optional<CellType> helper_type_named(std::string_view name);

/// What a black box has beyond its pins: INIT (0, 1 or x), RISE and FALL (durations), ORDINAL (a
/// number).
struct HelperParameter {
    std::string_view name;
    std::string value;
};

/// The parameters to be written for a cell: those that it has.
std::vector<HelperParameter> helper_parameters(const Netlist& netlist, const Cell& cell);

/// Undoes this for one parameter. Returns whether there is such a parameter and the value fits it.
bool set_helper_parameter(Logic& initial, Timing& timing, std::string_view name,
                          std::string_view value);

/// The names of all parameters.
std::span<const std::string_view> helper_parameter_names();

}  // namespace grafwire
