#pragma once

#include <optional>

#include "core/arguments.h"
#include "core/json.h"
#include "workflow/schematics.h"

namespace grafwire::playground {

/// `symbols`, `paper`, and the values of the moment `at` of `stimuli` where one is given. Where it
/// returns nothing the reason is in `answer`.
std::optional<SchematicDrawing> asked_schematic(const Arguments& arguments, const Chart& chart,
                                                const Netlist& netlist,
                                                const NetlistOptions& options, Json& answer);

}  // namespace grafwire::playground
