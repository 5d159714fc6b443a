#include "draw/schematic_lines.h"

#include <algorithm>
#include <cmath>

namespace grafwire {

namespace {

/// Where lines are joined: four to five times as wide as a line, and wider than a heavy one.
constexpr double junction = 0.09;
constexpr double junction_of_heavy_lines = 0.12;

class PartDrawing {
  public:
    PartDrawing(SchematicPens& pens, const SchematicView& view, const LaidPart& part,
                const PartWidths& widths, Point at)
        : pens_(pens), view_(view), part_(part), top_(at.y), names_(at.x + widths.names) {
        columns_.resize(widths.columns.size());
        double x = names_;
        for (std::size_t c = widths.columns.size(); c-- > 0;) {
            const PartWidths::Column& width = widths.columns[c];
            columns_[c].branches = x + width.outputs;
            columns_[c].gates = x + width.outputs + width.branches + width.turns;
            x = columns_[c].gates + width.gates;
        }
        const double value = view.shows_values() ? room_for_value : 0;
        back_ = x + output_length + value + way_back / 2;
        labels_ = x + output_length + value + way_back + name_gap;
    }

    void draw() {
        for (std::uint32_t i = 0; i < part_.gates.size(); ++i) draw_gate(i);
        for (const LaidTree& tree : part_.trees) {
            if (tree.feedback_gate != none) draw_feedback(tree);
            if (tree.partner != none) {
                draw_crossed(tree, tree.root, tree.partner);
                draw_crossed(tree, tree.partner, tree.root);
            }
        }
    }

  private:
    double y(double height) const { return top_ + height; }
    double junction_radius() const {
        return view_.shows_values() ? junction_of_heavy_lines : junction;
    }
    const Cell& cell_of(const LaidGate& gate) const { return view_.nets.netlist.cells[gate.cell]; }
    double left_of(const LaidGate& gate) const { return columns_[gate.column].gates; }
    /// The end of its output pin.
    double right_of(const LaidGate& gate) const {
        return left_of(gate) + gate.symbol.output() + output_length;
    }
    /// Where the line of a gate branches, in the channel behind it.
    double branch_of(const LaidGate& gate) const {
        return columns_[gate.column - 1].branches + (gate.branch_track + 0.5) * track_width;
    }
    double height_of_pin(const LaidGate& gate, std::size_t place) const {
        return y(gate.middle + gate.symbol.pins[place]);
    }

    void draw_gate(std::uint32_t number) {
        const LaidGate& gate = part_.gates[number];
        const Cell& cell = cell_of(gate);
        const double left = left_of(gate);
        Pen pen = pens_.cell(gate.cell);
        draw_symbol(pen, view_.nets.netlist, cell, gate.symbol, {left, y(gate.middle)});
        for (std::size_t place = 0; place < gate.order.size(); ++place) {
            const double height = height_of_pin(gate, place);
            const double end = left + end_of_input(gate.symbol, cell.type, gate.symbol.pins[place]);
            pens_.pin(gate.cell, gate.order[place])
                .line({{left - pin_length, height}, {end, height}});
            draw_input(gate, gate.pins[gate.order[place]], {left - pin_length, height});
        }
        const double right = right_of(gate);
        Pen pin = pens_.pin(gate.cell, SchematicPens::output_pin);
        pin.line({{right - output_length, y(gate.middle)}, {right, y(gate.middle)}});
        draw_output(gate, right);
    }

    /// The line that ends at a pin.
    void draw_input(const LaidGate& gate, const LaidPin& pin, Point end) {
        Pen net = pens_.net(pin.net);
        switch (pin.kind) {
            case LaidPin::Kind::gate:
                draw_turn(net, right_of(part_.gates[pin.from]), pin, end);
                break;
            case LaidPin::Kind::branch:
                draw_turn(net, branch_of(part_.gates[pin.from]), pin, end);
                break;
            case LaidPin::Kind::name:
                net.label(view_.label(pin.net), {names_ - name_gap, y(pin.row)},
                          Label::Anchor::end);
                draw_turn(net, names_, pin, end);
                break;
            case LaidPin::Kind::own_name:
                net.label(view_.label(pin.net), {end.x - name_gap, end.y}, Label::Anchor::end);
                break;
            case LaidPin::Kind::feedback:
                draw_turn(net, feedback_of(gate), pin, end);
                break;
            case LaidPin::Kind::crossed:
                break;
        }
    }

    double feedback_of(const LaidGate& gate) const {
        const auto tree =
            std::find_if(part_.trees.begin(), part_.trees.end(), [&](const LaidTree& each) {
                return each.feedback_gate != none &&
                       part_.gates[each.feedback_gate].cell == gate.cell;
            });
        return columns_[gate.column].branches + (tree->feedback_track + 0.5) * track_width;
    }

    /// From `x` at the height of the row to a pin.
    void draw_turn(Pen& net, double x, const LaidPin& pin, Point end) {
        if (std::abs(y(pin.row) - end.y) < 1e-6) {
            // Between gates that stand close together the pins meet.
            if (end.x - x > 1e-6) net.line({{x, end.y}, end});
            return;
        }
        const double turn = end.x - (pin.track + 0.5) * track_width;
        net.line({{x, y(pin.row)}, {turn, y(pin.row)}, {turn, end.y}, end});
    }

    /// What goes out of a gate besides the line to the gate where it hangs.
    void draw_output(const LaidGate& gate, double right) {
        const NetId output = cell_of(gate).output;
        Pen net = pens_.net(output);
        if (view_.shows_values()) {
            net.label(plain_text(view_.value_of(output)),
                      {right + room_for_value / 2, y(gate.middle) - 0.22}, Label::Anchor::middle,
                      Label::Role::remark);
        }
        if (gate.is_root && gate.is_named) {
            net.line({{right, y(gate.middle)}, {labels_ - name_gap, y(gate.middle)}});
            name_output(net, output, gate.middle);
        }
        if (gate.branches) draw_branches(net, gate);
    }

    void name_output(Pen& net, NetId output, double row) {
        net.label(view_.label(output), {labels_, y(row)}, Label::Anchor::start);
    }

    /// The line up and down at which the line of a gate branches; a dot where three lines meet.
    void draw_branches(Pen& net, const LaidGate& gate) {
        const double x = branch_of(gate);
        std::vector<double> rows{gate.middle};
        for (const LaidGate& reader : part_.gates) {
            for (const LaidPin& pin : reader.pins) {
                if (pin.kind == LaidPin::Kind::branch && part_.gates[pin.from].cell == gate.cell) {
                    rows.push_back(pin.row);
                }
            }
        }
        if (gate.is_named) {
            rows.push_back(gate.name_row);
            net.line({{x, y(gate.name_row)}, {labels_ - name_gap, y(gate.name_row)}});
            name_output(net, cell_of(gate).output, gate.name_row);
        }
        std::sort(rows.begin(), rows.end());
        net.line({{x, y(rows.front())}, {x, y(rows.back())}});
        for (const double row : rows) {
            const bool is_end = row == rows.front() || row == rows.back();
            if (!is_end || row == gate.middle) net.dot({x, y(row)}, junction_radius());
        }
    }

    /// From a root without a name to where its way back begins.
    void draw_to_back(Pen& net, const LaidGate& root) {
        net.line({{right_of(root), y(root.middle)}, {back_, y(root.middle)}});
    }

    /// Below all that hangs at the root, and up to the pin.
    void draw_feedback(const LaidTree& tree) {
        const LaidGate& root = part_.gates[tree.root];
        const LaidGate& reader = part_.gates[tree.feedback_gate];
        const double x = feedback_of(reader);
        const double lane = y(tree.bottom - pin_pitch / 2);
        Pen net = pens_.net(cell_of(root).output);
        if (!root.is_named) draw_to_back(net, root);
        net.line({{back_, y(root.middle)},
                  {back_, lane},
                  {x, lane},
                  {x, y(reader.pins[tree.feedback_pin].row)}});
        if (root.is_named) net.dot({back_, y(root.middle)}, junction_radius());
    }

    /// From one gate of a latch to the other: the lines of both cross once, between the gates.
    void draw_crossed(const LaidTree& tree, std::uint32_t from, std::uint32_t to) {
        constexpr double clear = 0.12;
        const LaidGate& upper = part_.gates[tree.root];
        const LaidGate& lower = part_.gates[tree.partner];
        const LaidGate& driver = part_.gates[from];
        const LaidGate& reader = part_.gates[to];
        const double above = y(upper.middle + upper.symbol.height / 2 + clear);
        const double below = y(lower.middle - lower.symbol.height / 2 - clear);
        const bool goes_down = from == tree.root;
        const std::size_t place = goes_down ? 0 : reader.order.size() - 1;
        const Point pin{left_of(reader) - pin_length, height_of_pin(reader, place)};
        const double left = pin.x - track_width / 2;
        Pen net = pens_.net(cell_of(driver).output);
        if (!driver.is_named) draw_to_back(net, driver);
        net.line({{back_, y(driver.middle)},
                  {back_, goes_down ? above : below},
                  {left, goes_down ? below : above},
                  {left, pin.y},
                  pin});
        if (driver.is_named) net.dot({back_, y(driver.middle)}, junction_radius());
    }

    struct Column {
        double branches = 0;  ///< where the tracks of the channel on its left begin
        double gates = 0;     ///< where its gates begin
    };

    SchematicPens& pens_;
    const SchematicView& view_;
    const LaidPart& part_;
    double top_;
    double names_;
    std::vector<Column> columns_;
    double back_ = 0;
    double labels_ = 0;
};

}  // namespace

void draw_part(SchematicPens& pens, const SchematicView& view, const LaidPart& part,
               const PartWidths& widths, Point at) {
    PartDrawing(pens, view, part, widths, at).draw();
}

}  // namespace grafwire
