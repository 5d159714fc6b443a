#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

#include "draw/flow_symbols.h"
#include "draw/scene.h"
#include "text/table.h"

namespace grafwire {

// Parts of a block that are laid out, and the links from their ends back up to a step.

/// The end of a branch that is to be joined to something.
struct Exit {
    bool goes_up = false;  ///< to a step above, else into what follows the branches
    double x = 0;
    double y = 0;      ///< where its link begins
    double clear = 0;  ///< the link must go down to here before it may turn
    std::uint32_t from = none;
    std::uint32_t target = none;  ///< of one that goes up
    Bounds name{};                ///< likewise: where its name would stand if it has to be cut
};

struct Laid {
    std::vector<Shape> shapes;
    std::vector<double> heads;  ///< where links enter from above, at y = 0
    std::vector<Exit> exits;
    double bottom = 0;

    /// How far all of it reaches, its axis included.
    Bounds extent() const {
        Bounds bounds = bounds_of(shapes);
        bounds.include({-0.2, 0, 0.2, 0});
        for (const Exit& exit : exits) {
            if (exit.goes_up) bounds.include(exit.name);
        }
        return bounds;
    }
    void shift(double dx, double dy) {
        move(shapes, dx, dy);
        for (double& head : heads) head += dx;
        for (Exit& exit : exits) {
            exit.x += dx;
            exit.y += dy;
            exit.clear += dy;
            Bounds& name = exit.name;
            name = {name.left + dx, name.top + dy, name.right + dx, name.bottom + dy};
        }
        bottom += dy;
    }
    void take(Laid other) {
        shapes.insert(shapes.end(), std::make_move_iterator(other.shapes.begin()),
                      std::make_move_iterator(other.shapes.end()));
        exits.insert(exits.end(), other.exits.begin(), other.exits.end());
        bottom = std::max(bottom, other.bottom);
    }
};

/// A step that stands on the axis of a sequence.
struct Target {
    double top = 0;
    double right_room = 0;    ///< above it, of its actions
    bool is_entered = false;  ///< a link comes from above
};

/// Draws the link from an end back up to a step that stands above it on the axis: along the left
/// side of what is laid out there or along the right one. False where something is in its way on
/// both sides.
bool draw_link_up(FlowSymbols& symbols, Laid& laid, const Exit& exit, const Target& target);

/// Draws a short link with an arrow and the name of where it leads.
void draw_cut(FlowSymbols& symbols, Laid& laid, const Exit& exit);

}  // namespace grafwire
