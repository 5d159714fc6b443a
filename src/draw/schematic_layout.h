#pragma once

#include <cstdint>
#include <vector>

#include "draw/gate_symbols.h"
#include "draw/schematic_trees.h"
#include "draw/schematic_view.h"

namespace grafwire {

// Trees of gates laid out one above the other, and how their pins are joined. Names of nets that
// come from elsewhere stand at the left edge, each at the beginning of a line of its own; names of
// nets that lead elsewhere stand at the right edge. Between the columns of gates are channels, in
// which lines go up and down. So no line passes through a gate, and lines cross only where one goes
// up or down.

/// A pin as it is laid out.
struct LaidPin {
    enum class Kind : std::uint8_t {
        gate,      ///< by the line from the gate that hangs there
        branch,    ///< by a branch of the line from a gate that hangs elsewhere
        feedback,  ///< by the way back from the root
        crossed,   ///< by the crossed lines of a latch
        name,      ///< by a name at the left edge
        own_name,  ///< by a name at the pin itself: clocks
    };
    Kind kind = Kind::name;
    NetId net = no_net;
    std::uint32_t from = none;  ///< gate, branch: the number of the gate that the line comes from
    double row = 0;             ///< at what height the line comes
    std::uint32_t track = 0;    ///< where it turns to the height of the pin, from right to left
};

struct LaidGate {
    CellId cell = no_cell;
    GateSymbol symbol;
    std::uint32_t column = 0;
    double middle = 0;                 ///< the height of its output
    std::vector<std::uint32_t> order;  ///< its pins, from the uppermost one down
    std::vector<LaidPin> pins;         ///< in the order of the cell
    bool is_root = false;
    bool is_named = false;  ///< its net leads elsewhere
    /// Of one that is no root: its line branches, to other gates or to its name.
    bool branches = false;
    std::uint32_t branch_track = 0;  ///< where, from left to right
    double name_row = 0;             ///< of one that is named and no root
};

struct LaidTree {
    std::uint32_t root = none;
    std::uint32_t end = none;      ///< behind its last gate
    std::uint32_t partner = none;  ///< the lower gate of a latch
    double bottom = 0;
    std::uint32_t feedback_gate = none;  ///< that reads the root over the way back
    std::uint32_t feedback_pin = none;
    std::uint32_t feedback_track = 0;
};

/// How wide the parts of a drawing are: where several are to look alike, the same for all.
struct PartWidths {
    /// A column of gates, from the right, and the channel on its left, from left to right.
    struct Column {
        double outputs = 0;   ///< behind the gates of the next column
        double branches = 0;  ///< tracks of branches
        double turns = 0;     ///< tracks of lines that turn to their pins
        double gates = 0;
    };
    double names = 0;  ///< at the left edge
    std::vector<Column> columns;
    double roots = 0;  ///< behind the roots, with their names

    void include(const PartWidths& other);
    double total() const;
};

struct LaidPart {
    std::vector<LaidGate> gates;
    std::vector<LaidTree> trees;
    PartWidths widths;
    double height = 0;
};

// The distances that the layout keeps and the lines are drawn by.
inline constexpr double pin_length = 0.2;
inline constexpr double output_length = 0.12;
inline constexpr double track_width = 0.18;
inline constexpr double name_gap = 0.08;
inline constexpr double room_for_value = 0.35;  ///< at an output
inline constexpr double way_back = 0.3;         ///< from a root to the line that leads back

LaidPart lay_out(const SchematicView& view, const std::vector<GateTree>& trees);

/// How high a tree will be, about.
double height_of(const SchematicView& view, const GateTree& tree);

}  // namespace grafwire
