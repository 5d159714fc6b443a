// A rung taller than a page is drawn in parts. Only vertical wires cross a cut.

#include "ladder/draw/cut_drawing.h"

#include <algorithm>
#include <vector>

namespace grafwire::ladder {

int row_to_cut(const Drawing& drawing, int from, int most) {
    const int last = from + most;
    if (last >= drawing.height) return drawing.height;
    // Whether a cut before that row would part what belongs together.
    std::vector<bool> parts(static_cast<std::size_t>(last) + 1, false);
    const auto keep_together = [&](int first, int count) {
        for (int row = std::max(first + 1, 0); row < first + count && row <= last; ++row) {
            parts[static_cast<std::size_t>(row)] = true;
        }
    };
    // A name stands in the row above the wire, that of a block in the row above its frame.
    for (const Drawing::Symbol& symbol : drawing.symbols) keep_together(symbol.y - 1, 2);
    for (const Drawing::Box& box : drawing.boxes) keep_together(box.y - 1, box.height + 1);
    for (int row = last; row > from; --row) {
        if (!parts[static_cast<std::size_t>(row)]) return row;
    }
    return last;
}

Drawing rows_of(const Drawing& drawing, int from, int to) {
    Drawing part;
    part.width = drawing.width;
    part.height = to - from;
    for (Drawing::Wire wire : drawing.wires) {
        wire.y1 = std::clamp(wire.y1, 2 * from, 2 * to) - 2 * from;
        wire.y2 = std::clamp(wire.y2, 2 * from, 2 * to) - 2 * from;
        const bool is_outside = wire.y1 == wire.y2 && (wire.y1 == 0 || wire.y1 == 2 * part.height);
        if (!is_outside) part.wires.push_back(wire);
    }
    const auto take = [&](const auto& items, auto& taken) {
        for (auto item : items) {
            if (item.y < from || item.y >= to) continue;
            item.y -= from;
            taken.push_back(item);
        }
    };
    take(drawing.symbols, part.symbols);
    take(drawing.labels, part.labels);
    take(drawing.boxes, part.boxes);
    return part;
}

}  // namespace grafwire::ladder
