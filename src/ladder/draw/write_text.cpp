// Ladder diagrams in characters.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ladder/draw/layout.h"
#include "ladder/draw/messages.h"
#include "ladder/draw/write_drawings.h"
#include "text/utf8.h"

namespace grafwire::ladder {

namespace {

/// Rows of cells; a cell holds a character, or the directions in which wires leave its middle.
class Canvas {
  public:
    Canvas(int width, int height)
        : width_(width), cells_(static_cast<std::size_t>(width * height)) {}

    void wire(const Drawing::Wire& wire);
    void text(int x, int y, const std::string& text);
    void box(const Drawing::Box& box);
    void symbol(const Drawing::Symbol& symbol);
    std::string row(int y) const;

  private:
    enum : std::uint8_t { right = 1, down = 2, left = 4, up = 8 };
    struct Cell {
        std::uint8_t directions = 0;
        std::string character;
    };
    Cell& cell(int x, int y) { return cells_[static_cast<std::size_t>(y * width_ + x)]; }

    int width_;
    std::vector<Cell> cells_;
};

void Canvas::wire(const Drawing::Wire& wire) {
    if (wire.y1 == wire.y2) {
        for (int x = wire.x1; x < wire.x2; ++x) {
            cell(x / 2, wire.y1 / 2).directions |= x % 2 == 0 ? left : right;
        }
        return;
    }
    for (int y = wire.y1; y < wire.y2; ++y) {
        cell(wire.x1 / 2, y / 2).directions |= y % 2 == 0 ? up : down;
    }
}

void Canvas::text(int x, int y, const std::string& text) {
    for (std::size_t at = 0; at < text.size(); ++x) {
        const std::uint32_t bytes = std::max(decode_utf8(text, at).length, 1U);
        cell(x, y).character = text.substr(at, bytes);
        at += bytes;
    }
}

void Canvas::box(const Drawing::Box& box) {
    const int x2 = box.x + box.width - 1;
    const int y2 = box.y + box.height - 1;
    const auto edge = [&](int y, const char* first, const char* last) {
        text(box.x, y, first);
        for (int x = box.x + 1; x < x2; ++x) text(x, y, "─");
        text(x2, y, last);
    };
    edge(box.y, "┌", "┐");
    edge(y2, "└", "┘");
    text(box.x + 2, box.y, box.title);
    for (std::size_t i = 0; i < box.rows.size(); ++i) {
        const int y = box.y + 1 + static_cast<int>(i);
        text(box.x, y, i == 0 ? "┤" : "│");
        text(x2, y, i == 0 ? "├" : "│");
        text(box.x + 2, y, box.rows[i]);
        if (i < box.right.size()) {
            text(x2 - 1 - static_cast<int>(count_code_points(box.right[i])), y, box.right[i]);
        }
    }
}

void Canvas::symbol(const Drawing::Symbol& symbol) {
    const bool is_coil = symbol.kind == Drawing::Symbol::Kind::coil;
    const int first = symbol.x - symbol.width / 2;
    text(first, symbol.y, is_coil ? "(" : "┤");
    text(first + symbol.width - 1, symbol.y, is_coil ? ")" : "├");
    const int at = symbol.kind == Drawing::Symbol::Kind::comparison ? first + 2 : symbol.x;
    text(at, symbol.y, symbol.text);
}

std::string Canvas::row(int y) const {
    static constexpr std::array<const char*, 16> lines{" ", "─", "│", "┌", "─", "─", "┐", "┬",
                                                       "│", "└", "│", "├", "┘", "┴", "┤", "┼"};
    std::string text;
    for (int x = 0; x < width_; ++x) {
        const Cell& cell = cells_[static_cast<std::size_t>(y * width_ + x)];
        text += cell.character.empty() ? lines[cell.directions] : cell.character;
    }
    return text;
}

Canvas canvas_of(const Drawing& drawing) {
    Canvas canvas(drawing.width, drawing.height);
    canvas.wire({1, 0, 1, 2 * drawing.height});
    canvas.wire({2 * drawing.width - 1, 0, 2 * drawing.width - 1, 2 * drawing.height});
    for (const Drawing::Wire& wire : drawing.wires) canvas.wire(wire);
    for (const Drawing::Label& label : drawing.labels) canvas.text(label.x, label.y, label.text);
    for (const Drawing::Symbol& symbol : drawing.symbols) canvas.symbol(symbol);
    for (const Drawing::Box& box : drawing.boxes) canvas.box(box);
    return canvas;
}

std::string padded(const std::string& text, int width) {
    const int blanks = width - static_cast<int>(count_code_points(text));
    return text + std::string(static_cast<std::size_t>(std::max(blanks, 0)), ' ');
}

/// `Inputs   a, b, c`, in as many lines as that takes.
void write_names(const Ladder& ladder, Role role, Type type, const std::string& title, int width,
                 std::string& text) {
    std::string names;
    for (const Variable& variable : ladder.variables) {
        if (variable.role != role || variable.type != type) continue;
        if (!names.empty()) names += ", ";
        names += variable.name;
    }
    if (names.empty()) return;
    std::string head = title;
    for (const std::string& line : wrapped_text(names, static_cast<std::size_t>(width - 12))) {
        text += fmt::format("{:<12}{}\n", head, line);
        head.clear();
    }
}

std::string heading(const std::string& text, int width) {
    std::string line = "── " + text + " ";
    while (static_cast<int>(count_code_points(line)) < width) line += "─";
    return line + "\n";
}

}  // namespace

std::string write_rung(const Ladder& ladder, const Rung& rung, int width, std::size_t indent) {
    const Drawing drawing = draw(ladder, rung, width);
    const Canvas canvas = canvas_of(drawing);
    std::string text;
    for (int y = 0; y < drawing.height; ++y) {
        text += std::string(indent, ' ') + canvas.row(y) + "\n";
    }
    return text;
}

std::string write_text(const Ladder& ladder, int width, Language language) {
    namespace say = messages::ladder_draw;
    std::string text = heading_of(ladder, language);
    text += "\n\n";
    for (const std::string& remark : ladder.remarks) {
        for (const std::string& line : wrapped_text(remark, static_cast<std::size_t>(width))) {
            text += line + "\n";
        }
    }
    if (!ladder.remarks.empty()) text += "\n";
    write_names(ladder, Role::input, Type::bit, say::inputs.in(language), width, text);
    write_names(ladder, Role::output, Type::bit, say::outputs.in(language), width, text);
    write_names(ladder, Role::memory, Type::bit, say::bits.in(language), width, text);
    write_names(ladder, Role::memory, Type::integer, say::integers.in(language), width, text);
    write_names(ladder, Role::memory, Type::block, say::blocks.in(language), width, text);
    for (const Rung& rung : ladder.rungs) {
        const Drawing drawing = draw(ladder, rung, width);
        if (!rung.heading.empty()) text += "\n" + heading(rung.heading, width) + "\n";
        const std::string number = fmt::format("{:>3}  ", rung.number);
        std::string head = number;
        const auto room = static_cast<std::size_t>(drawing.width - 4) - number.size();
        for (const std::string& line : wrapped_text(rung.comment, room)) {
            text += "│" + padded(head + line, drawing.width - 2) + "│\n";
            head = std::string(number.size(), ' ');
        }
        text += write_rung(ladder, rung, width);
        text += "│" + padded("", drawing.width - 2) + "│\n";
    }
    return text;
}

}  // namespace grafwire::ladder
