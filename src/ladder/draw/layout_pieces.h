#pragma once

#include <string>
#include <vector>

#include "ladder/draw/layout.h"

namespace grafwire::ladder {

/// A part of a rung, drawn: the wire enters at its left edge in row `in` and leaves at its right
/// edge in row `out`.
struct Piece {
    Drawing drawing;
    int in = 0;
    int out = 0;
};

/// Adds a drawing to another, its corner at (x, y).
void place(Drawing& whole, Drawing part, int x, int y);
/// A wire from edge to edge of the cells from..to (excluded) of a row.
void wire_across(Drawing& drawing, int from, int to, int row);

/// Makes the pieces of one rung, none wider than `limit` where that can be.
class PieceMaker {
  public:
    explicit PieceMaker(const Ladder& ladder) : ladder_(ladder) {}

    Piece power(const Power& power, int limit);
    Piece coils(const std::vector<Coil>& coils);
    Piece in_series(std::vector<Piece> parts, int limit);
    Piece block(const Block& block);

  private:
    Piece symbol(Drawing::Symbol::Kind kind, const std::string& name, std::string mark);
    Piece comparison(const Power& power);
    Piece in_parallel(std::vector<Piece> parts, bool joined);
    Piece arrow(bool leaves);
    const std::string& name(VariableId id) const { return ladder_.variable(id).name; }

    const Ladder& ladder_;
    int next_arrow_ = 1;
};

}  // namespace grafwire::ladder
