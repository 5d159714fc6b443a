#pragma once

#include "ladder/draw/layout.h"

namespace grafwire::ladder {

/// The row before which a drawing is best cut so that at most `most` rows from `from` on stand
/// above: no block is cut, and no name is parted from its contact. Where that cannot be, `from +
/// most`.
int row_to_cut(const Drawing& drawing, int from, int most);

/// The rows from `from` to before `to`, moved up to the top. Vertical wires go on beyond the cut.
Drawing rows_of(const Drawing& drawing, int from, int to);

}  // namespace grafwire::ladder
