// Every part of the tree of a rung becomes a piece; a whole is its pieces side by side, shifted so
// that the rows of their wires meet, or one below the other between two vertical wires.

#include "ladder/draw/layout_pieces.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/expression.h"
#include "text/utf8.h"

namespace grafwire::ladder {

namespace {

int length(std::string_view text) {
    return static_cast<int>(count_code_points(text));
}

void shift(Drawing& drawing, int dx, int dy) {
    for (Drawing::Wire& wire : drawing.wires) {
        wire.x1 += 2 * dx;
        wire.x2 += 2 * dx;
        wire.y1 += 2 * dy;
        wire.y2 += 2 * dy;
    }
    const auto move = [&](auto& items) {
        for (auto& item : items) {
            item.x += dx;
            item.y += dy;
        }
    };
    move(drawing.symbols);
    move(drawing.labels);
    move(drawing.boxes);
}

Piece wire() {
    Piece piece{{}, 1, 1};
    piece.drawing.width = 1;
    piece.drawing.height = 2;
    wire_across(piece.drawing, 0, 1, 1);
    return piece;
}

}  // namespace

void place(Drawing& whole, Drawing part, int x, int y) {
    shift(part, x, y);
    const auto append = [](auto& to, auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(whole.wires, part.wires);
    append(whole.symbols, part.symbols);
    append(whole.labels, part.labels);
    append(whole.boxes, part.boxes);
    whole.width = std::max(whole.width, x + part.width);
    whole.height = std::max(whole.height, y + part.height);
}

void wire_across(Drawing& drawing, int from, int to, int row) {
    if (from < to) drawing.wires.push_back({2 * from, 2 * row + 1, 2 * to, 2 * row + 1});
}

Piece PieceMaker::symbol(Drawing::Symbol::Kind kind, const std::string& name, std::string mark) {
    Piece piece{{}, 1, 1};
    Drawing& drawing = piece.drawing;
    const int label = length(name);
    const bool is_coil = kind == Drawing::Symbol::Kind::coil;
    drawing.width = std::max(label + 2, is_coil ? 9 : 7);
    if (drawing.width % 2 == 0) ++drawing.width;
    drawing.height = 2;
    // Coils stand below one another, however long their names are.
    const int middle = is_coil ? drawing.width - 5 : drawing.width / 2;
    const int label_x = std::min(middle - label / 2, drawing.width - 1 - label);
    drawing.symbols.push_back({kind, middle, 1, std::move(mark), 3});
    drawing.labels.push_back({Drawing::Label::Kind::name, label_x, 0, name});
    wire_across(drawing, 0, middle - 1, 1);
    wire_across(drawing, middle + 2, drawing.width, 1);
    return piece;
}

Piece PieceMaker::comparison(const Power& power) {
    const std::string text =
        fmt::format("{} {} {}", operand_text(ladder_, power.left), text_of(power.relation),
                    operand_text(ladder_, power.right));
    Piece piece{{}, 1, 1};
    Drawing& drawing = piece.drawing;
    const int width = length(text) + 4;
    drawing.width = width + 2;
    drawing.height = 2;
    drawing.symbols.push_back({Drawing::Symbol::Kind::comparison, 1 + width / 2, 1, text, width});
    wire_across(drawing, 0, 1, 1);
    wire_across(drawing, width + 1, width + 2, 1);
    return piece;
}

/// An arrow with the number of the joint, at the end of a line or at the beginning of the next.
Piece PieceMaker::arrow(bool leaves) {
    Piece piece{{}, 1, 1};
    Drawing& drawing = piece.drawing;
    const std::string text =
        leaves ? fmt::format("▶{}", next_arrow_) : fmt::format("{}▶", next_arrow_);
    drawing.width = length(text) + 2;
    drawing.height = 2;
    drawing.labels.push_back({Drawing::Label::Kind::arrow, leaves ? 2 : 0, 1, text});
    if (leaves) {
        wire_across(drawing, 0, 2, 1);
    } else {
        wire_across(drawing, length(text), drawing.width, 1);
    }
    return piece;
}

/// Side by side; where that is too wide, in several lines.
Piece PieceMaker::in_series(std::vector<Piece> parts, int limit) {
    constexpr int arrow_width = 4;
    Piece whole;
    Piece line;
    bool is_first_line = true;
    int line_ends = 0;
    const auto append = [&](Piece& to, Piece part) {
        if (to.drawing.width == 0) {
            to = std::move(part);
            return;
        }
        const int dy = to.out - part.in;
        if (dy < 0) {
            shift(to.drawing, 0, -dy);
            to.drawing.height -= dy;
            to.in -= dy;
            to.out -= dy;
        }
        const int y = std::max(dy, 0);
        const int x = to.drawing.width;
        to.out = y + part.out;
        place(to.drawing, std::move(part.drawing), x, y);
    };
    const auto end_line = [&] {
        const int y = whole.drawing.height;
        if (is_first_line) whole.in = line.in;
        whole.out = y + line.out;
        line_ends = line.drawing.width;
        place(whole.drawing, std::move(line.drawing), 0, y);
        line = Piece();
        is_first_line = false;
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const int room = i + 1 == parts.size() ? limit : limit - arrow_width;
        const bool has_parts = line.drawing.width > (is_first_line ? 0 : arrow_width);
        if (has_parts && line.drawing.width + parts[i].drawing.width > room) {
            append(line, arrow(true));
            end_line();
            line = arrow(false);
            ++next_arrow_;
        }
        append(line, std::move(parts[i]));
    }
    end_line();
    wire_across(whole.drawing, line_ends, whole.drawing.width, whole.out);
    return whole;
}

/// One below the other between two vertical wires; without the right one where not `joined`.
Piece PieceMaker::in_parallel(std::vector<Piece> parts, bool joined) {
    Piece whole;
    int inner = 0;
    for (const Piece& part : parts) inner = std::max(inner, part.drawing.width);
    const int right = inner + 1;
    int y = 0;
    int last_in = 0;
    int last_out = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Piece& part = parts[i];
        const int width = part.drawing.width;
        const int height = part.drawing.height;
        last_in = y + part.in;
        last_out = y + part.out;
        if (i == 0) {
            whole.in = last_in;
            whole.out = last_out;
        }
        place(whole.drawing, std::move(part.drawing), 1, y);
        std::vector<Drawing::Wire>& wires = whole.drawing.wires;
        wires.push_back({i == 0 ? 0 : 1, 2 * last_in + 1, 2, 2 * last_in + 1});
        wire_across(whole.drawing, 1 + width, right, last_out);
        if (joined) {
            const int end = 2 * right + (i == 0 ? 2 : 1);
            wires.push_back({2 * right, 2 * last_out + 1, end, 2 * last_out + 1});
        }
        y += height;
    }
    std::vector<Drawing::Wire>& wires = whole.drawing.wires;
    wires.push_back({1, 2 * whole.in + 1, 1, 2 * last_in + 1});
    if (joined) {
        wires.push_back({2 * right + 1, 2 * whole.out + 1, 2 * right + 1, 2 * last_out + 1});
    }
    whole.drawing.width = right + (joined ? 1 : 0);
    return whole;
}

Piece PieceMaker::power(const Power& power, int limit) {
    static constexpr const char* marks[] = {"", "/", "P", "N"};
    std::vector<Piece> parts;
    switch (power.kind) {
        case Power::Kind::wire:
            return wire();
        case Power::Kind::contact:
            return symbol(Drawing::Symbol::Kind::contact, name(power.variable),
                          marks[static_cast<std::size_t>(power.contact)]);
        case Power::Kind::comparison:
            return comparison(power);
        case Power::Kind::series:
            for (const Power& part : power.parts) parts.push_back(this->power(part, limit - 8));
            return in_series(std::move(parts), limit);
        case Power::Kind::parallel:
            for (const Power& part : power.parts) parts.push_back(this->power(part, limit - 2));
            return in_parallel(std::move(parts), true);
    }
    return wire();
}

Piece PieceMaker::block(const Block& block) {
    const BlockTypeRow& row = row_of(block.type);
    Drawing::Box box;
    box.title = row.name;
    const auto text = [&](std::size_t i) { return operand_text(ladder_, block.operands[i]); };
    std::string label;
    box.rows.emplace_back(row.power);
    if (row.is_function) {
        box.right.emplace_back("ENO");
        const std::string& target = name(block.target);
        switch (block.type) {
            case BlockType::move:
                box.rows.push_back(fmt::format("{} := {}", target, text(0)));
                break;
            case BlockType::limit:
                box.rows.push_back(
                    fmt::format("{} := {}, {} .. {}", target, text(1), text(0), text(2)));
                break;
            default: {
                const char* sign = block.type == BlockType::add        ? "+"
                                   : block.type == BlockType::subtract ? "-"
                                                                       : "*";
                box.rows.push_back(fmt::format("{} := {} {} {}", target, text(0), sign, text(1)));
            }
        }
    } else {
        label = name(block.target);
        box.right.emplace_back(row.output);
        for (std::size_t i = 0; i < block.operands.size(); ++i) {
            box.rows.push_back(fmt::format("{} {}", row.inputs[i], text(i)));
        }
    }
    int inner =
        std::max(length(box.title) + 2, length(box.rows.front()) + length(box.right.front()) + 3);
    for (const std::string& line : box.rows) inner = std::max(inner, length(line) + 2);
    inner = std::max(inner, length(label) - 2);
    Piece piece{{}, 2, 2};
    box.x = 1;
    box.y = 1;
    box.width = inner + 2;
    box.height = static_cast<int>(box.rows.size()) + 2;
    Drawing& drawing = piece.drawing;
    drawing.width = box.width + 2;
    drawing.height = box.height + 1;
    if (!label.empty()) {
        const int x = 1 + (box.width - length(label)) / 2;
        drawing.labels.push_back({Drawing::Label::Kind::name, x, 0, label});
    }
    wire_across(drawing, 0, 1, 2);
    wire_across(drawing, box.width + 1, box.width + 2, 2);
    drawing.boxes.push_back(std::move(box));
    return piece;
}

Piece PieceMaker::coils(const std::vector<Coil>& coils) {
    static constexpr const char* marks[] = {"", "/", "S", "R", "P", "N"};
    std::vector<Piece> parts;
    for (const Coil& coil : coils) {
        parts.push_back(symbol(Drawing::Symbol::Kind::coil, name(coil.variable),
                               marks[static_cast<std::size_t>(coil.kind)]));
    }
    if (parts.empty()) return wire();
    if (parts.size() > 1) return in_parallel(std::move(parts), false);
    Piece only = std::move(parts.front());
    return only;
}

}  // namespace grafwire::ladder
