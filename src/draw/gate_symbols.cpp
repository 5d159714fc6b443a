#include "draw/gate_symbols.h"

#include <algorithm>

#include "text/time.h"

namespace grafwire {

namespace {

constexpr double circle_radius = 0.1;
/// How deep the back of OR and XOR is, and how far the second line of XOR stands before it.
constexpr double depth_of_back = 0.2;
constexpr double second_back = 0.14;

/// What a symbol consists of, by type.
struct SymbolForm {
    std::string_view sign;  ///< of IEC 60617-12, at the top
    bool is_negated = false;
    std::string_view first = "", second = "";  ///< written at the inputs
};

SymbolForm form_of(CellType type) {
    switch (type) {
        case CellType::low:
            return {"0"};
        case CellType::high:
            return {"1"};
        case CellType::buffer:
            return {"1"};
        case CellType::inverter:
            return {"1", true};
        case CellType::and_gate:
            return {"&"};
        case CellType::or_gate:
            return {"≥1"};
        case CellType::nand_gate:
            return {"&", true};
        case CellType::nor_gate:
            return {"≥1", true};
        case CellType::xor_gate:
            return {"=1"};
        case CellType::latch:
            return {"", false, "S1", "R"};
        case CellType::hold_latch:
            return {"", false, "1D", "C1"};
        case CellType::flip_flop:
            return {"", false, "1D", "C1"};
        case CellType::rise_pulse:
            return {"↑"};
        case CellType::fall_pulse:
            return {"↓"};
        case CellType::timer:
        case CellType::scan_timer:
        case CellType::scan_timer_next:
            break;
    }
    return {""};
}

/// The delays of a timer, of the rise and of the fall.
std::string delays_of(const Netlist& netlist, const Cell& cell) {
    const Timing& timing = netlist.timings[cell.timing];
    const auto shown = [](Time time) { return time == 0 ? "0" : format_duration(time); };
    return shown(timing.rise) + "  " + shown(timing.fall);
}

bool has_distinctive_shape(CellType type) {
    return type >= CellType::buffer && type <= CellType::xor_gate;
}

bool is_or(CellType type) {
    return type == CellType::or_gate || type == CellType::nor_gate || type == CellType::xor_gate;
}

/// A straight piece of an outline.
Outline::Curve straight(Point from, Point to) {
    return {from, to, to};
}

/// The shape of AND: straight to its half, then round.
Outline and_shape(Point at, double width, double height) {
    constexpr double round = 0.5523;  // what makes a quarter of an ellipse of a Bézier curve
    const double half = height / 2;
    const double x = at.x + width / 2;
    const double right = at.x + width;
    const Point top{at.x, at.y - half};
    const Point bottom{at.x, at.y + half};
    const Point tip{right, at.y};
    return {top,
            {straight(top, {x, top.y}),
             {{x + round * width / 2, top.y}, {right, at.y - round * half}, tip},
             {{right, at.y + round * half}, {x + round * width / 2, bottom.y}, {x, bottom.y}},
             straight({x, bottom.y}, bottom),
             straight(bottom, top)}};
}

/// The hollow back of OR, from below upwards.
Outline::Curve back(Point at, double height) {
    const double x = at.x + 4.0 / 3 * depth_of_back;
    return {{x, at.y + height / 6}, {x, at.y - height / 6}, {at.x, at.y - height / 2}};
}

Outline or_shape(Point at, double width, double height) {
    const double half = height / 2;
    const Point top{at.x, at.y - half};
    const Point bottom{at.x, at.y + half};
    const double x1 = at.x + 0.5 * width;
    const double x2 = at.x + 0.85 * width;
    return {top,
            {{{x1, top.y}, {x2, at.y - 0.3 * height}, {at.x + width, at.y}},
             {{x2, at.y + 0.3 * height}, {x1, bottom.y}, bottom},
             back(at, height)}};
}

Outline triangle(Point at, double width, double height) {
    const Point top{at.x, at.y - height / 2};
    const Point tip{at.x + width, at.y};
    const Point bottom{at.x, at.y + height / 2};
    return {top, {straight(top, tip), straight(tip, bottom), straight(bottom, top)}};
}

void draw_distinctive(Pen& pen, CellType type, const GateSymbol& symbol, Point at) {
    if (type == CellType::buffer || type == CellType::inverter) {
        pen.outline(triangle(at, symbol.width, symbol.height));
    } else if (type == CellType::xor_gate) {
        const Point body{at.x + second_back, at.y};
        pen.outline(or_shape(body, symbol.width - second_back, symbol.height));
        pen.outline({{at.x, at.y + symbol.height / 2}, {back(at, symbol.height)}, false});
    } else if (is_or(type)) {
        pen.outline(or_shape(at, symbol.width, symbol.height));
    } else {
        pen.outline(and_shape(at, symbol.width, symbol.height));
    }
}

/// A pulse beside the arrow of its edge.
void draw_pulse(Pen& pen, Point at) {
    constexpr double high = 0.14;
    pen.line({{at.x + 0.44, at.y + high},
              {at.x + 0.52, at.y + high},
              {at.x + 0.52, at.y - high},
              {at.x + 0.66, at.y - high},
              {at.x + 0.66, at.y + high},
              {at.x + 0.74, at.y + high}},
             Line::Weight::thin);
}

void draw_rectangle(Pen& pen, const Netlist& netlist, const Cell& cell, const GateSymbol& symbol,
                    Point at) {
    const SymbolForm form = form_of(cell.type);
    const double top = at.y - symbol.height / 2;
    pen.rectangle({at.x, top, at.x + symbol.width, at.y + symbol.height / 2});
    const auto write = [&](std::string_view text, Point where, Label::Anchor anchor) {
        if (!text.empty()) pen.label(plain_text(std::string(text)), where, anchor);
    };
    const bool is_pulse = cell.type == CellType::rise_pulse || cell.type == CellType::fall_pulse;
    const std::string sign =
        is_timer(cell.type) ? delays_of(netlist, cell) : std::string(form.sign);
    const double middle = is_pulse ? 0.25 : symbol.width / 2;
    // In the middle of a symbol that is not higher than its sign.
    write(sign, {at.x + middle, top + std::min(0.32, symbol.height / 2)}, Label::Anchor::middle);
    if (is_pulse) draw_pulse(pen, at);
    const bool has_clock = row_of(cell.type).is_clocked;
    const double inset = 0.1;
    if (!form.first.empty()) {
        write(form.first, {at.x + inset, at.y + symbol.pins[0]}, Label::Anchor::start);
        write(form.second, {at.x + inset + (has_clock ? 0.18 : 0), at.y + symbol.pins[1]},
              Label::Anchor::start);
    }
    if (has_clock) {
        const double y = at.y + symbol.pins.back();
        pen.line({{at.x, y - 0.13}, {at.x + 0.22, y}, {at.x, y + 0.13}}, Line::Weight::thin);
    }
}

}  // namespace

double GateSymbol::output() const {
    return width + (is_negated ? 2 * circle_radius : 0);
}

bool is_symmetrical(CellType type) {
    return type >= CellType::and_gate && type <= CellType::xor_gate;
}

GateSymbol symbol_of(const Netlist& netlist, const Cell& cell, GateShapes shapes) {
    GateSymbol symbol;
    symbol.is_negated = form_of(cell.type).is_negated;
    symbol.is_distinctive = shapes == GateShapes::us && has_distinctive_shape(cell.type);
    const double inputs = std::max(1.0, static_cast<double>(cell.pin_count)) * pin_pitch;
    const bool is_small = cell.pin_count <= 1;
    double first = -(static_cast<double>(cell.pin_count) - 1) / 2 * pin_pitch;
    if (is_timer(cell.type)) {
        symbol.width = width_of(plain_text(delays_of(netlist, cell))) + 0.3;
        const double sign_room = cell.pin_count > 1 ? 0.4 : 0;
        symbol.height = std::max(0.66, inputs + sign_room);
        first += sign_room / 2;
    } else if (!form_of(cell.type).first.empty()) {
        symbol.width = 1.1;
        symbol.height = inputs + 0.2;
    } else if (symbol.is_distinctive) {
        symbol.width = is_small ? 0.66 : 1;
        if (cell.type == CellType::xor_gate) symbol.width += second_back;
        symbol.height = is_small ? 0.66 : std::max(0.8, inputs);
    } else {
        symbol.width = 0.8;
        symbol.height = std::max(0.66, inputs);
    }
    for (std::uint32_t pin = 0; pin < cell.pin_count; ++pin) {
        symbol.pins.push_back(first + pin * pin_pitch);
    }
    return symbol;
}

double end_of_input(const GateSymbol& symbol, CellType type, double height_of_pin) {
    if (!symbol.is_distinctive || !is_or(type)) return 0;
    const double part = height_of_pin / (symbol.height / 2);
    return depth_of_back * (1 - part * part);
}

void draw_symbol(Pen& pen, const Netlist& netlist, const Cell& cell, const GateSymbol& symbol,
                 Point at) {
    if (symbol.is_distinctive) {
        draw_distinctive(pen, cell.type, symbol, at);
    } else {
        draw_rectangle(pen, netlist, cell, symbol, at);
    }
    if (symbol.is_negated) pen.ring({at.x + symbol.width + circle_radius, at.y}, circle_radius);
}

}  // namespace grafwire
