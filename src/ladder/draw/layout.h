#pragma once

#include <string>
#include <vector>

#include "ladder/ladder.h"

namespace grafwire::ladder {

// Where the parts of a rung stand in a drawing: on a grid of cells of one character each, so that
// the same layout serves text, SVG and the coordinates of a project file. Names stand in the row
// above the wire. A part that would exceed the width goes on in a new line, joined by numbered
// arrows.

struct Drawing {
    /// A straight line between two points in half cells: the centre of cell (x, y) is
    /// (2x + 1, 2y + 1).
    struct Wire {
        int x1 = 0;
        int y1 = 0;
        int x2 = 0;
        int y2 = 0;
    };
    /// A contact or coil: three cells around its middle; a comparison is as wide as its text needs.
    struct Symbol {
        enum class Kind { contact, comparison, coil };
        Kind kind = Kind::contact;
        int x = 0;  ///< of the middle cell
        int y = 0;
        std::string text;  ///< the mark (empty, `/`, `P`, `N`, `S`, `R`), or what is compared
        int width = 3;     ///< in cells; the first is x - width / 2
    };
    struct Label {
        enum class Kind { name, arrow };
        Kind kind = Kind::name;
        int x = 0;  ///< of its first cell
        int y = 0;
        std::string text;
    };
    /// A block: a frame with the power line in its second row.
    struct Box {
        int x = 0;
        int y = 0;
        int width = 0;
        int height = 0;
        std::string title;
        std::vector<std::string> rows;   ///< at the left, from the power line down
        std::vector<std::string> right;  ///< at the right, likewise
    };
    int width = 0;
    int height = 0;
    std::vector<Wire> wires;
    /// Contacts and comparisons in the order of the tree, then coils in their order.
    std::vector<Symbol> symbols;
    std::vector<Label> labels;
    std::vector<Box> boxes;  ///< in the order of the blocks
};

/// A rung between two rails that stand in the middle of the first and of the last column. It takes
/// at least `width` cells, more only where a single contact or block does not fit.
Drawing draw(const Ladder& ladder, const Rung& rung, int width);

/// A text cut into lines of at most `width` characters, at blanks where there are some.
std::vector<std::string> wrapped_text(const std::string& text, std::size_t width);

}  // namespace grafwire::ladder
