// A module is drawn as its equation is written: the root is what it makes, with what goes into it
// to its left. A gate that several others read hangs at one of them, and stands left of them all
// (its column is the longest way to a root), so that a line from left to right can join it to each.
// Where gates are on a loop, it is cut at the one that is known outside, the X of a step, or at
// both gates of a latch; else at a cell with a memory, or, where there is none, at the last one.

#include "draw/schematic_trees.h"

#include <algorithm>

#include "draw/gate_symbols.h"

namespace grafwire {

namespace {

/// What a sheet has room for.
constexpr std::uint32_t most_columns = 6;
constexpr std::uint32_t most_inputs = 36;

class TreeMaker {
  public:
    TreeMaker(const SchematicNets& nets, Range<CellId> cells)
        : nets_(nets),
          cells_(cells),
          column_(cells.count, 0),
          readers_(cells.count, 0),
          is_root_(cells.count, 0),
          is_placed_(cells.count, 0),
          partner_(cells.count, none) {}

    std::vector<GateTree> make() {
        find_roots();
        find_columns();
        for (const bool is_known : {true, false}) {
            for (std::uint32_t cell = 0; cell < cells_.count; ++cell) {
                const bool wanted = is_known_outside(cell) == is_known;
                if (wanted && is_root_[cell] != 0) make_tree(cell);
            }
        }
        // What trees that are full have left over.
        for (std::uint32_t cell = 0; cell < cells_.count; ++cell) make_tree(cell);
        return std::move(trees_);
    }

  private:
    const Cell& cell_at(std::uint32_t local) const {
        return nets_.netlist.cells[CellId{cells_.first + local}];
    }
    std::span<const NetId> pins_of(std::uint32_t local) const {
        return nets_.netlist.pins_of(cell_at(local));
    }
    /// The cell that drives a net, if it is one of these.
    std::uint32_t driver(NetId net) const {
        const CellId cell = nets_.drivers[net];
        if (cell == no_cell || !cells_.contains(cell)) return none;
        return static_cast<std::uint32_t>(index_of(cell)) - cells_.first;
    }
    bool is_known_outside(std::uint32_t local) const {
        return nets_.is_output[index_of(cell_at(local).output)] != 0 || partner_[local] != none;
    }

    void find_roots() {
        for (std::uint32_t cell = 0; cell < cells_.count; ++cell) {
            if (partner_[cell] == none) find_partner(cell);
            if (is_known_outside(cell)) is_root_[cell] = 1;
            for (const NetId pin : pins_of(cell)) {
                if (const std::uint32_t from = driver(pin); from != none) ++readers_[from];
            }
        }
    }

    /// The other gate of a latch.
    void find_partner(std::uint32_t cell) {
        const CellType type = cell_at(cell).type;
        if (type != CellType::nand_gate && type != CellType::nor_gate) return;
        for (const NetId pin : pins_of(cell)) {
            const std::uint32_t other = driver(pin);
            if (other == none || other == cell || partner_[other] != none) continue;
            if (cell_at(other).type != type) continue;
            const auto back = pins_of(other);
            if (std::find(back.begin(), back.end(), cell_at(cell).output) == back.end()) continue;
            partner_[cell] = other;
            partner_[other] = cell;
            is_root_[other] = 1;
            return;
        }
    }

    /// Readers first: a cell comes once all that read it have their columns.
    void find_columns() {
        std::vector<std::uint32_t> ready;
        std::vector<std::uint8_t> is_done(cells_.count, 0);
        for (std::uint32_t cell = 0; cell < cells_.count; ++cell) {
            if (readers_[cell] == 0) is_root_[cell] = 1;
            if (is_root_[cell] != 0) ready.push_back(cell);
        }
        LoopCuts cuts{cells_.count, cells_.count};
        for (std::size_t at = 0;;) {
            if (at == ready.size()) {
                const std::uint32_t cut = next_cut(cuts, is_done);
                if (cut == none) return;
                is_root_[cut] = 1;
                column_[cut] = 0;
                ready.push_back(cut);
            }
            const std::uint32_t cell = ready[at++];
            is_done[cell] = 1;
            for (const NetId pin : pins_of(cell)) {
                const std::uint32_t from = driver(pin);
                if (from == none || is_root_[from] != 0) continue;
                column_[from] = std::max(column_[from], column_[cell] + 1);
                if (--readers_[from] != 0) continue;
                if (column_[from] >= most_columns) {
                    is_root_[from] = 1;
                    column_[from] = 0;
                }
                ready.push_back(from);
            }
        }
    }

    /// How far the cells have been looked through for places where loops may be cut.
    struct LoopCuts {
        std::uint32_t memories = 0;
        std::uint32_t others = 0;
    };
    /// Where only loops are left: a cell with a memory, else any, the last one first, since what
    /// comes last in a module is what it makes. None where nothing is left.
    std::uint32_t next_cut(LoopCuts& cuts, const std::vector<std::uint8_t>& is_done) const {
        while (cuts.memories-- > 0) {
            const bool has_memory = row_of(cell_at(cuts.memories).type).has_memory;
            if (has_memory && is_done[cuts.memories] == 0) return cuts.memories;
        }
        cuts.memories = 0;
        while (cuts.others-- > 0) {
            if (is_done[cuts.others] == 0) return cuts.others;
        }
        cuts.others = 0;
        return none;
    }

    void make_tree(std::uint32_t root) {
        if (is_placed_[root] != 0) return;
        std::uint32_t other = partner_[root];
        // The gate that the chart knows is the upper one.
        const auto is_port = [&](std::uint32_t cell) {
            return nets_.is_output[index_of(cell_at(cell).output)] != 0;
        };
        if (other != none && is_port(other) && !is_port(root)) std::swap(root, other);
        GateTree tree;
        inputs_ = 0;
        add(tree, root);
        if (other != none) {
            tree.partner = add(tree, other);
            face(tree.gates[0], cell_at(other).output, true);
            face(tree.gates[tree.partner], cell_at(root).output, false);
        } else {
            put_feedback_last(tree, 0);
        }
        trees_.push_back(std::move(tree));
    }

    /// Recursive: as deep as there are columns.
    std::uint32_t add(GateTree& tree, std::uint32_t cell) {
        is_placed_[cell] = 1;
        const auto pins = pins_of(cell);
        const auto number = static_cast<std::uint32_t>(tree.gates.size());
        tree.gates.push_back({CellId{cells_.first + cell}, column_[cell], {}, {}});
        tree.gates[number].inputs.assign(pins.size(), none);
        inputs_ += std::max<std::uint32_t>(1, static_cast<std::uint32_t>(pins.size()));
        for (std::uint32_t pin = 0; pin < pins.size(); ++pin) {
            tree.gates[number].order.push_back(pin);
            const std::uint32_t from = driver(pins[pin]);
            if (from == none || is_root_[from] != 0 || is_placed_[from] != 0) continue;
            if (inputs_ + pins_of(from).size() > most_inputs) continue;
            const std::uint32_t input = add(tree, from);
            tree.gates[number].inputs[pin] = input;
        }
        return number;
    }

    /// Puts the pin that reads a net last, or first.
    void face(TreeGate& gate, NetId net, bool last) const {
        const auto pins = nets_.netlist.pins_of(nets_.netlist.cells[gate.cell]);
        const auto pin = std::find_if(gate.order.begin(), gate.order.end(),
                                      [&](std::uint32_t at) { return pins[at] == net; });
        if (last) {
            std::rotate(pin, pin + 1, gate.order.end());
        } else {
            std::rotate(gate.order.begin(), pin, pin + 1);
        }
    }

    /// Whether the root is read below a gate; where it is, that comes last.
    bool put_feedback_last(GateTree& tree, std::uint32_t number) const {
        const Cell& cell = nets_.netlist.cells[tree.gates[number].cell];
        const auto pins = nets_.netlist.pins_of(cell);
        const NetId root = nets_.netlist.cells[tree.gates[0].cell].output;
        std::uint32_t back = none;
        for (std::uint32_t pin = 0; pin < pins.size(); ++pin) {
            const std::uint32_t input = tree.gates[number].inputs[pin];
            if (input == none ? pins[pin] == root : put_feedback_last(tree, input)) back = pin;
        }
        if (back == none) return false;
        if (is_symmetrical(cell.type)) face(tree.gates[number], pins[back], true);
        return true;
    }

    const SchematicNets& nets_;
    Range<CellId> cells_;
    std::vector<std::uint32_t> column_;
    std::vector<std::uint32_t> readers_;  ///< how many of the cells still to come read it
    std::vector<std::uint8_t> is_root_;
    std::vector<std::uint8_t> is_placed_;
    std::vector<std::uint32_t> partner_;
    std::uint32_t inputs_ = 0;  ///< of the tree that is being made
    std::vector<GateTree> trees_;
};

}  // namespace

std::vector<GateTree> trees_of(const SchematicNets& nets, Range<CellId> cells) {
    return TreeMaker(nets, cells).make();
}

}  // namespace grafwire
