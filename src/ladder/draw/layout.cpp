#include "ladder/draw/layout.h"

#include <algorithm>

#include "ladder/draw/layout_pieces.h"
#include "text/utf8.h"

namespace grafwire::ladder {

Drawing draw(const Ladder& ladder, const Rung& rung, int width) {
    PieceMaker layout(ladder);
    Piece coils = layout.coils(rung.coils);
    const int room = std::max(width - 3 - coils.drawing.width, 20);
    std::vector<Piece> parts;
    parts.push_back(layout.power(rung.power, room));
    for (const Block& block : rung.blocks) parts.push_back(layout.block(block));
    Piece left = layout.in_series(std::move(parts), room);

    // The contacts begin at the left rail, the coils end at the right one.
    Drawing whole;
    const int total = std::max(width, left.drawing.width + coils.drawing.width + 3);
    const int down = std::max(coils.in - left.out, 0);
    const int coils_y = left.out + down - coils.in;
    const int coils_x = total - 1 - coils.drawing.width;
    const int left_end = 2 + left.drawing.width;
    std::vector<int> rows;
    for (const Drawing::Symbol& symbol : coils.drawing.symbols) rows.push_back(symbol.y);
    if (rows.empty()) rows.push_back(coils.in);
    place(whole, std::move(left.drawing), 2, down);
    place(whole, std::move(coils.drawing), coils_x, coils_y);
    whole.wires.push_back({1, 2 * (left.in + down) + 1, 4, 2 * (left.in + down) + 1});
    wire_across(whole, left_end, coils_x, left.out + down);
    for (const int row : rows) {
        const int y = 2 * (row + coils_y) + 1;
        whole.wires.push_back({2 * (total - 1), y, 2 * total - 1, y});
    }
    whole.width = total;
    return whole;
}

std::vector<std::string> wrapped_text(const std::string& text, std::size_t width) {
    std::vector<std::string> lines;
    std::string line;
    std::size_t in_line = 0;
    std::size_t last_blank = std::string::npos;  // in `line`
    for (std::size_t at = 0; at < text.size();) {
        const std::uint32_t bytes = std::max(decode_utf8(text, at).length, 1U);
        if (in_line == width && text[at] == ' ') {
            lines.push_back(std::move(line));
            line.clear();
            in_line = 0;
            last_blank = std::string::npos;
            ++at;
            continue;
        }
        if (in_line == width) {
            const bool at_blank = last_blank != std::string::npos && last_blank > 0;
            lines.push_back(at_blank ? line.substr(0, last_blank) : line);
            line = at_blank ? line.substr(last_blank + 1) : std::string();
            in_line = count_code_points(line);
            last_blank = std::string::npos;
        }
        if (text[at] == ' ') last_blank = line.size();
        line += text.substr(at, bytes);
        ++in_line;
        at += bytes;
    }
    lines.push_back(line);
    return lines;
}

}  // namespace grafwire::ladder
