#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/scene.h"
#include "netlist/netlist.h"

namespace grafwire {

// The symbols of cells: rectangles with a sign at the top as IEC 60617-12 has them, or the
// distinctive shapes of IEEE Std 91. Negation is a circle outside. Each symbol stands right of its
// origin, which is at half its height.

enum class GateShapes : std::uint8_t { iec, us };

/// From one input to the next.
inline constexpr double pin_pitch = 0.45;

/// How large a symbol is and where its inputs are.
struct GateSymbol {
    double width = 0;
    double height = 0;
    std::vector<double> pins;  ///< the heights of the inputs, from the middle, y downwards
    bool is_negated = false;   ///< a circle follows
    bool is_distinctive = false;

    /// Where the output is.
    double output() const;
};

GateSymbol symbol_of(const Netlist& netlist, const Cell& cell, GateShapes shapes);

/// Where the line of an input ends, from the left edge: the back of OR and XOR is curved.
double end_of_input(const GateSymbol& symbol, CellType type, double height_of_pin);

/// Draws the symbol with its origin there.
void draw_symbol(Pen& pen, const Netlist& netlist, const Cell& cell, const GateSymbol& symbol,
                 Point at);

/// Whether its inputs may be drawn in any order.
bool is_symmetrical(CellType type);

}  // namespace grafwire
