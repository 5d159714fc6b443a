#include "draw/schematic_layout.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace grafwire {

namespace {

constexpr double gate_gap = 0.16;   ///< from gate to gate
constexpr double tree_gap = 0.25;   ///< from tree to tree
constexpr double latch_gap = 0.75;  ///< between the gates of a latch, for their crossed lines

/// A line may branch to gates that are not farther away; and only so often.
constexpr double longest_branch = 7;
constexpr std::uint32_t most_branches = 5;
constexpr std::uint32_t most_in_channel = 4;

class Layout {
  public:
    Layout(const SchematicView& view, const std::vector<GateTree>& trees) : view_(view) {
        for (const GateTree& tree : trees) add(tree);
    }

    LaidPart take() {
        find_branches();
        find_feedback();
        find_named();
        stack_trees();
        assign_tracks();
        measure();
        return std::move(part_);
    }

  private:
    LaidGate& gate(std::uint32_t number) { return part_.gates[number]; }
    const Cell& cell_of(const LaidGate& gate) const { return view_.nets.netlist.cells[gate.cell]; }
    NetId output_of(std::uint32_t number) { return cell_of(gate(number)).output; }

    std::uint32_t columns() const {
        std::uint32_t count = 1;
        for (const LaidGate& each : part_.gates) count = std::max(count, each.column + 1);
        return count;
    }

    // ---- Gates and rows

    void add(const GateTree& tree) {
        const auto first = static_cast<std::uint32_t>(part_.gates.size());
        const double top = part_.trees.empty() ? 0 : part_.trees.back().bottom + tree_gap;
        for (const TreeGate& from : tree.gates) add_gate(from, first);
        LaidTree laid;
        laid.root = first;
        laid.end = static_cast<std::uint32_t>(part_.gates.size());
        gate(first).is_root = true;
        if (tree.partner != none) {
            laid.partner = first + tree.partner;
            gate(laid.partner).is_root = true;
            LaidGate& upper = gate(first);
            LaidGate& lower = gate(laid.partner);
            upper.pins[upper.order.back()].kind = LaidPin::Kind::crossed;
            lower.pins[lower.order.front()].kind = LaidPin::Kind::crossed;
        }
        laid.bottom = place(first, top);
        if (laid.partner != none) place_partner(laid);
        part_.trees.push_back(laid);
    }

    void add_gate(const TreeGate& from, std::uint32_t first) {
        const Netlist& netlist = view_.nets.netlist;
        const Cell& cell = netlist.cells[from.cell];
        LaidGate gate;
        gate.cell = from.cell;
        gate.symbol = symbol_of(netlist, cell, view_.shapes);
        gate.column = from.column;
        gate.order = from.order;
        const auto pins = netlist.pins_of(cell);
        for (std::size_t pin = 0; pin < pins.size(); ++pin) {
            LaidPin laid;
            laid.net = pins[pin];
            if (from.inputs[pin] != none) {
                laid.kind = LaidPin::Kind::gate;
                laid.from = first + from.inputs[pin];
            } else if (row_of(cell.type).is_clocked && pin + 1 == pins.size()) {
                laid.kind = LaidPin::Kind::own_name;
            }
            gate.pins.push_back(laid);
        }
        part_.gates.push_back(std::move(gate));
    }

    static bool has_row(const LaidPin& pin) {
        return pin.kind != LaidPin::Kind::crossed && pin.kind != LaidPin::Kind::own_name;
    }

    /// Gives a gate and all that hangs there their heights, from `top` on; returns where they end.
    /// Recursive: as deep as there are columns.
    double place(std::uint32_t number, double top) {
        double bottom = top;
        for (const std::uint32_t pin : part_.gates[number].order) {
            LaidPin& laid = gate(number).pins[pin];
            if (!has_row(laid)) continue;
            if (laid.kind == LaidPin::Kind::gate) {
                bottom = place(laid.from, bottom);
                laid.row = gate(laid.from).middle;
            } else {
                laid.row = bottom + pin_pitch / 2;
                bottom += pin_pitch;
            }
        }
        const double half = (gate(number).symbol.height + gate_gap) / 2;
        gate(number).middle = middle_of(gate(number), top + half);
        if (const double too_high = top - (gate(number).middle - half); too_high > 0) {
            shift(number, too_high);
            bottom += too_high;
        }
        return std::max(bottom, gate(number).middle + half);
    }

    /// In the middle of its rows, but so that no line has a small step.
    static double middle_of(const LaidGate& gate, double where_there_are_none) {
        constexpr double small = 0.25;
        double first = 0, last = 0;
        bool is_first = true;
        for (std::size_t i = 0; i < gate.order.size(); ++i) {
            if (!has_row(gate.pins[gate.order[i]])) continue;
            last = gate.pins[gate.order[i]].row - gate.symbol.pins[i];
            if (is_first) first = last;
            is_first = false;
        }
        if (is_first) return where_there_are_none;
        const double middle = (first + last) / 2;
        double step = small;
        for (std::size_t i = 0; i < gate.order.size(); ++i) {
            if (!has_row(gate.pins[gate.order[i]])) continue;
            const double away = gate.pins[gate.order[i]].row - gate.symbol.pins[i] - middle;
            if (std::abs(away) < std::abs(step)) step = away;
        }
        return std::abs(step) < small ? middle + step : middle;
    }

    void shift(std::uint32_t number, double by) {
        gate(number).middle += by;
        for (LaidPin& pin : gate(number).pins) {
            pin.row += by;
            if (pin.kind == LaidPin::Kind::gate) shift(pin.from, by);
        }
    }

    void place_partner(LaidTree& tree) {
        const LaidGate& upper = gate(tree.root);
        double bottom = place(tree.partner, tree.bottom);
        const LaidGate& lower = gate(tree.partner);
        const double gap =
            (lower.middle - lower.symbol.height / 2) - (upper.middle + upper.symbol.height / 2);
        if (gap < latch_gap) {
            shift(tree.partner, latch_gap - gap);
            bottom += latch_gap - gap;
        }
        tree.bottom = bottom;
    }

    // ---- What joins the pins

    /// A branch goes to the right: to a gate that stands nearer to the right edge.
    void find_branches() {
        std::unordered_map<std::uint32_t, std::uint32_t> number_of;
        for (std::uint32_t i = 0; i < part_.gates.size(); ++i) {
            number_of[static_cast<std::uint32_t>(index_of(gate(i).cell))] = i;
        }
        std::vector<std::uint32_t> branches(part_.gates.size());
        std::vector<std::uint32_t> in_channel(columns());
        for (LaidGate& reader : part_.gates) {
            for (LaidPin& pin : reader.pins) {
                const CellId driver = view_.nets.drivers[pin.net];
                if (pin.kind != LaidPin::Kind::name || driver == no_cell) continue;
                const auto found = number_of.find(static_cast<std::uint32_t>(index_of(driver)));
                if (found == number_of.end()) continue;
                LaidGate& from = gate(found->second);
                if (from.is_root || reader.column >= from.column) continue;
                if (std::abs(pin.row - from.middle) > longest_branch) continue;
                if (branches[found->second] == most_branches) continue;
                if (!from.branches && in_channel[from.column]++ >= most_in_channel) continue;
                ++branches[found->second];
                from.branches = true;
                pin.kind = LaidPin::Kind::branch;
                pin.from = found->second;
            }
        }
    }

    /// The lowest pin that reads the root.
    void find_feedback() {
        for (LaidTree& tree : part_.trees) {
            if (tree.partner != none) continue;
            for (std::uint32_t i = tree.root; i < tree.end; ++i) {
                for (std::uint32_t pin = 0; pin < gate(i).pins.size(); ++pin) {
                    const LaidPin& laid = gate(i).pins[pin];
                    if (laid.kind != LaidPin::Kind::name || laid.net != output_of(tree.root)) {
                        continue;
                    }
                    if (tree.feedback_gate != none &&
                        gate(tree.feedback_gate).pins[tree.feedback_pin].row > laid.row) {
                        continue;
                    }
                    tree.feedback_gate = i;
                    tree.feedback_pin = pin;
                }
            }
            if (tree.feedback_gate == none) continue;
            gate(tree.feedback_gate).pins[tree.feedback_pin].kind = LaidPin::Kind::feedback;
        }
    }

    /// A net has a name at its gate where lines do not join it to all that it goes to.
    void find_named() {
        std::unordered_map<std::uint32_t, std::uint32_t> joined;
        for (const LaidGate& reader : part_.gates) {
            for (const LaidPin& pin : reader.pins) {
                const bool by_name =
                    pin.kind == LaidPin::Kind::name || pin.kind == LaidPin::Kind::own_name;
                if (!by_name) ++joined[static_cast<std::uint32_t>(index_of(pin.net))];
            }
        }
        for (LaidGate& gate : part_.gates) {
            const NetId net = cell_of(gate).output;
            const std::uint32_t uses = view_.nets.uses[index_of(net)];
            gate.is_named = uses == 0 || uses > joined[static_cast<std::uint32_t>(index_of(net))];
            if (gate.is_named && !gate.is_root) gate.branches = true;
        }
    }

    /// Now that it is known which of them have names above and a way back below.
    void stack_trees() {
        double top = 0;
        double old_top = 0;
        for (LaidTree& tree : part_.trees) {
            const double height = tree.bottom - old_top;
            double first_row = top;
            for (std::uint32_t i = tree.root; i < tree.end; ++i) {
                if (gate(i).is_root || !gate(i).is_named) continue;
                gate(i).name_row = first_row + pin_pitch / 2;
                first_row += pin_pitch;
            }
            shift(tree.root, first_row - old_top);
            if (tree.partner != none) shift(tree.partner, first_row - old_top);
            old_top = tree.bottom + tree_gap;
            tree.bottom = first_row + height;
            if (tree.feedback_gate != none) tree.bottom += pin_pitch;
            top = tree.bottom + tree_gap;
        }
        part_.height = top - tree_gap;
        for (LaidGate& reader : part_.gates) {
            for (LaidPin& pin : reader.pins) {
                if (pin.kind == LaidPin::Kind::gate) pin.row = gate(pin.from).middle;
            }
        }
    }

    // ---- Tracks

    struct Span {
        double from = 0, to = 0;
    };
    /// By track, what is taken of it.
    using Tracks = std::vector<std::vector<Span>>;

    static std::uint32_t free_track(Tracks& tracks, Span span) {
        constexpr double apart = 0.15;
        const auto is_free = [&](const std::vector<Span>& taken) {
            return std::all_of(taken.begin(), taken.end(), [&](const Span& other) {
                return other.to + apart < span.from || span.to + apart < other.from;
            });
        };
        const auto found = std::find_if(tracks.begin(), tracks.end(), is_free);
        const auto track = static_cast<std::uint32_t>(found - tracks.begin());
        if (found == tracks.end()) tracks.emplace_back();
        tracks[track].push_back(span);
        return track;
    }

    void assign_tracks() {
        const std::uint32_t count = columns();
        part_.widths.columns.resize(count);
        std::vector<Span> spans;
        for (const LaidGate& each : part_.gates) {
            spans.push_back({each.middle, each.middle});
            if (each.is_named && !each.is_root) spans.back().from = each.name_row;
        }
        for (const LaidGate& reader : part_.gates) {
            for (const LaidPin& pin : reader.pins) {
                if (pin.kind != LaidPin::Kind::branch) continue;
                spans[pin.from].from = std::min(spans[pin.from].from, pin.row);
                spans[pin.from].to = std::max(spans[pin.from].to, pin.row);
            }
        }
        std::vector<Tracks> tracks(count);
        for (std::uint32_t i = 0; i < part_.gates.size(); ++i) {
            if (!gate(i).branches) continue;
            gate(i).branch_track = free_track(tracks[gate(i).column - 1], spans[i]);
        }
        for (LaidTree& tree : part_.trees) {
            if (tree.feedback_gate == none) continue;
            const LaidGate& reader = gate(tree.feedback_gate);
            tree.feedback_track = free_track(tracks[reader.column],
                                             {reader.pins[tree.feedback_pin].row, tree.bottom});
        }
        for (std::uint32_t c = 0; c < count; ++c) {
            part_.widths.columns[c].branches = static_cast<double>(tracks[c].size()) * track_width;
        }
        for (LaidGate& each : part_.gates) assign_turns(each);
    }

    /// Of lines that come from above, the uppermost turns nearest to the gate; of those from below,
    /// the lowest: so none crosses another.
    void assign_turns(LaidGate& gate) {
        // The crossed line of a latch is nearer to the gate than all others.
        const std::uint32_t first =
            std::any_of(gate.pins.begin(), gate.pins.end(),
                        [](const LaidPin& pin) { return pin.kind == LaidPin::Kind::crossed; });
        std::uint32_t down = first;
        std::uint32_t up = first;
        double own_name = 0;
        const auto height = [&](std::size_t i) { return gate.middle + gate.symbol.pins[i]; };
        for (std::size_t i = 0; i < gate.order.size(); ++i) {
            LaidPin& pin = gate.pins[gate.order[i]];
            if (has_row(pin) && pin.row < height(i) - 1e-6) pin.track = down++;
            if (pin.kind == LaidPin::Kind::own_name) {
                own_name = width_of(view_.label(pin.net)) + 2 * name_gap;
            }
        }
        for (std::size_t i = gate.order.size(); i-- > 0;) {
            LaidPin& pin = gate.pins[gate.order[i]];
            if (has_row(pin) && pin.row > height(i) + 1e-6) pin.track = up++;
        }
        double& turns = part_.widths.columns[gate.column].turns;
        turns = std::max({turns, std::max(down, up) * track_width, own_name});
    }

    // ---- Widths

    void measure() {
        PartWidths& widths = part_.widths;
        const double value = view_.shows_values() ? room_for_value : 0;
        for (std::size_t c = 0; c < widths.columns.size(); ++c) {
            widths.columns[c].turns += pin_length;
            if (c + 1 < widths.columns.size()) widths.columns[c].outputs = output_length + value;
        }
        for (const LaidGate& gate : part_.gates) {
            PartWidths::Column& column = widths.columns[gate.column];
            column.gates = std::max(column.gates, gate.symbol.output());
            if (gate.is_named) {
                widths.roots = std::max(widths.roots, width_of(view_.label(cell_of(gate).output)));
            }
            for (const LaidPin& pin : gate.pins) {
                if (pin.kind != LaidPin::Kind::name) continue;
                widths.names = std::max(widths.names, width_of(view_.label(pin.net)) + name_gap);
            }
        }
        widths.roots += output_length + value + way_back + 2 * name_gap;
    }

    const SchematicView& view_;
    LaidPart part_;
};

double height_of(const SchematicView& view, const GateTree& tree, std::uint32_t number) {
    const TreeGate& gate = tree.gates[number];
    const Netlist& netlist = view.nets.netlist;
    double rows = 0;
    for (const std::uint32_t input : gate.inputs) {
        rows += input == none ? pin_pitch : height_of(view, tree, input);
    }
    const GateSymbol symbol = symbol_of(netlist, netlist.cells[gate.cell], view.shapes);
    return std::max(rows, symbol.height + gate_gap);
}

}  // namespace

LaidPart lay_out(const SchematicView& view, const std::vector<GateTree>& trees) {
    return Layout(view, trees).take();
}

double height_of(const SchematicView& view, const GateTree& tree) {
    double height = height_of(view, tree, 0) + tree_gap + pin_pitch;
    if (tree.partner != none) height += latch_gap + height_of(view, tree, tree.partner);
    return height;
}

void PartWidths::include(const PartWidths& other) {
    names = std::max(names, other.names);
    roots = std::max(roots, other.roots);
    columns.resize(std::max(columns.size(), other.columns.size()));
    for (std::size_t c = 0; c < other.columns.size(); ++c) {
        columns[c].outputs = std::max(columns[c].outputs, other.columns[c].outputs);
        columns[c].branches = std::max(columns[c].branches, other.columns[c].branches);
        columns[c].turns = std::max(columns[c].turns, other.columns[c].turns);
        columns[c].gates = std::max(columns[c].gates, other.columns[c].gates);
    }
}

double PartWidths::total() const {
    double total = names + roots;
    for (const Column& column : columns) {
        total += column.outputs + column.branches + column.turns + column.gates;
    }
    return total;
}

}  // namespace grafwire
