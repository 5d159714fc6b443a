#pragma once

#include <string>
#include <vector>

#include "draw/gate_symbols.h"
#include "draw/scene.h"
#include "logic/logic.h"
#include "netlist/netlist.h"
#include "text/message.h"

namespace grafwire {

/// How a netlist is to be drawn.
struct SchematicDrawing {
    std::string title;
    GateShapes shapes = GateShapes::iec;
    Paper paper = papers[0];
    Language language = Language::english;
    /// By net, what it is at a moment; empty: no moment is shown.
    std::vector<Logic> values{};
};

/// The schematic of a netlist, drawn from the netlist alone: each of its cells once, each pin at
/// the end of a line or at the name of its net. A dashed frame for each module with its equation
/// above it, those of the steps first, in the order of the chart and all in the same form; then the
/// others. Lines do not leave a module: nets go from one to the other by name. Where there are
/// several sheets, an index says on which of them a name is found.
std::vector<Sheet> draw_schematic(const Netlist& netlist, const SchematicDrawing& how);

}  // namespace grafwire
