// What a netlist, made here or elsewhere, has for a step or output, read off its gates.
//
// From a net one walks back through the gates until something is met that the GRAFCET has a name
// for. An X need not be the very net of its port: what drives that through buffers or two
// inverters is the same, and the other half of a latch of two gates is its complement. Time
// conditions are timer cells (by their number), edges are pulse cells or, in a clocked netlist, a
// flip-flop that remembers the cycle before. The walk from an X ends at the same X again: that is
// the feedback of its memory. Other loops (a latch whose X is taken behind a further gate) are cut
// where the walk comes back to a net it is on.
//
// For an X1 that is a latch of two NAND gates the walk goes
//
//     X1 = nand(X1$set1, X1$q)            X1 itself is what is asked for: on through its gate
//     X1$set1 = nand(X0, a)               X0 and a have names: leaves
//     X1$q = nand(X1$reset0, X1)          met through X1's own gate: on; X1 again: a leaf, the
//     X1$reset0 = nand(X2, X1$set1)       feedback
//
// and the function is /(/(X0.a) . /(/(X2./(X0.a)) . X1)) = X0.a + X1./X2.
//
// The functions are truth tables; they do not show whether a step was wired with NAND, NOR or AND
// and OR.

#include "explain/net_reader.h"

#include <algorithm>
#include <unordered_set>

#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

constexpr std::size_t most_edge_products = 8;  ///< of the operand of an edge

/// Whether the output is a function of the inputs alone.
bool is_gate_type(CellType type) {
    return type <= CellType::xor_gate;
}

bool inverts(CellType type) {
    return type == CellType::nand_gate || type == CellType::nor_gate;
}

}  // namespace

NetReader::NetReader(const Grafcet& grafcet, const Netlist& netlist)
    : grafcet_(grafcet),
      netlist_(netlist),
      ports_(map_ports(grafcet, netlist)),
      drivers_(drivers_of(netlist)) {
    for (const Port& port : netlist.inputs) {
        named_[port.net] = {port.name, port.net, false, false, false};
    }
    for (std::size_t i = 0; i < ports_.inputs.size(); ++i) {
        const bool is_control = i >= grafcet.inputs.size();
        const auto index = static_cast<std::uint32_t>(is_control ? i - grafcet.inputs.size() : i);
        name_port(ports_.inputs[i],
                  {is_control ? VariableKind::control : VariableKind::input, index});
    }
    for (std::size_t i = 0; i < ports_.steps.size(); ++i) name_step(i);
    name_complements();
    for (std::size_t i = 0; i < ports_.outputs.size(); ++i) {
        if (!grafcet.outputs[static_cast<OutputId>(i)].stored) continue;
        name_port(ports_.outputs[i], {VariableKind::output, static_cast<std::uint32_t>(i)});
    }
    for (std::size_t i = 0; i < grafcet.vars.size(); ++i) {
        const Variable variable{VariableKind::var, static_cast<std::uint32_t>(i)};
        for (const Observed& var : netlist.vars) {
            if (var.name != grafcet.vars.items()[i].name || var.bits.size() != 1) continue;
            named_[var.bits[0]] = {operand_name(grafcet_, variable), var.bits[0], false, false,
                                   true};
        }
    }
    const Equations equations = equations_from(grafcet, {});
    name_timers(equations.expressions);
    name_memories(equations.expressions);
}

void NetReader::locate(FunctionVariables& variables) const {
    for (std::size_t v = 0; v < variables.size(); ++v) {
        const auto port = ports_by_name_.find(variables[v].name);
        if (variables[v].net == no_net && port != ports_by_name_.end()) {
            variables[v].net = port->second;
        }
    }
}

/// What a port carries; no_net: the netlist does not have it.
void NetReader::name_port(NetId net, Variable variable) {
    if (net == no_net) return;
    const std::string name = operand_name(grafcet_, variable);
    named_[net] = {name, net, false, false, false};
    ports_by_name_[name] = net;
}

/// The net of an X, and those it only passes on.
void NetReader::name_step(std::size_t index) {
    NetId net = ports_.steps[index];
    const std::string name =
        operand_name(grafcet_, {VariableKind::step, static_cast<std::uint32_t>(index)});
    if (net != no_net) ports_by_name_[name] = net;
    bool is_inverted = false;
    while (net != no_net && !named_.contains(net)) {
        named_[net] = {name, net, is_inverted, false, false};
        const CellId driver = drivers_[net];
        if (driver == no_cell) return;
        const Cell& cell = netlist_.cells[driver];
        if (cell.type == CellType::inverter) {
            is_inverted = !is_inverted;
        } else if (cell.type != CellType::buffer) {
            return;
        }
        net = netlist_.pins_of(cell)[0];
    }
}

/// The net of the gate that is cross-coupled with the one that drives this net, if one is.
NetId NetReader::cross_coupled(NetId net) const {
    const CellId driver = drivers_[net];
    if (driver == no_cell || !inverts(netlist_.cells[driver].type)) return no_net;
    for (const NetId pin : netlist_.pins_of(netlist_.cells[driver])) {
        const CellId other = drivers_[pin];
        if (other == no_cell || netlist_.cells[other].type != netlist_.cells[driver].type) continue;
        const auto pins = netlist_.pins_of(netlist_.cells[other]);
        if (std::find(pins.begin(), pins.end(), net) != pins.end()) return pin;
    }
    return no_net;
}

/// The other halves of latches of two gates.
void NetReader::name_complements() {
    std::vector<std::pair<NetId, FunctionVariable>> found;
    for (const auto& [net, variable] : named_) {
        const NetId other = cross_coupled(net);
        if (other == no_net || named_.contains(other)) continue;
        found.emplace_back(
            other, FunctionVariable{variable.name, other, !variable.is_inverted, false, false});
    }
    for (auto& [net, variable] : found) named_.try_emplace(net, std::move(variable));
}

NetId NetReader::other_half(StepId step) const {
    NetId net = ports_.steps[index_of(step)];
    while (net != no_net && drivers_[net] != no_cell) {
        const Cell& cell = netlist_.cells[drivers_[net]];
        const NetId other = cross_coupled(net);
        if (other != no_net) return other;
        if (cell.type != CellType::buffer) break;
        net = netlist_.pins_of(cell)[0];
    }
    return no_net;
}

void NetReader::name_timers(const Expressions& pool) {
    const std::vector<ExprId>& named = pool.time_conditions();
    for (const Cell& cell : netlist_.cells) {
        if (cell.type != CellType::timer && cell.type != CellType::scan_timer) continue;
        const std::uint32_t ordinal = netlist_.timings[cell.timing].ordinal;
        if (ordinal >= named.size()) continue;
        named_[cell.output] = {write_expression(grafcet_, pool, named[ordinal]), cell.output, false,
                               false, true};
    }
}

/// Edges, and memories that the GRAFCET has no name for.
void NetReader::name_memories(const Expressions& pool) {
    std::unordered_set<std::string> remembered;  // what edges compare with
    for (const ExprId edge : pool.edges()) {
        remembered.insert(write_expression(grafcet_, pool, pool.operands(edge)[0]));
    }
    std::vector<std::pair<NetId, FunctionVariable>> found;
    for (const Cell& cell : netlist_.cells) {
        const CellTypeRow& row = row_of(cell.type);
        if (is_gate_type(cell.type) || cell.type == CellType::latch ||
            cell.type == CellType::hold_latch || named_.contains(cell.output)) {
            continue;
        }
        FunctionVariable variable{std::string(netlist_.names[cell.output]), cell.output, false,
                                  true, true};
        const NetId pin = netlist_.pins_of(cell)[0];
        const std::string operand = row.has_timing && is_timer(cell.type) ? "" : text_of(pin);
        if (!operand.empty()) {
            const bool is_word = operand.find_first_of(" .+/") == std::string::npos;
            const std::string shown = is_word ? operand : "(" + operand + ")";
            const bool is_pulse =
                cell.type == CellType::rise_pulse || cell.type == CellType::fall_pulse;
            variable.is_own = !is_pulse && !remembered.contains(operand);
            if (cell.type == CellType::rise_pulse) {
                variable.name = "↑" + shown;
            } else if (cell.type == CellType::fall_pulse) {
                variable.name = "↓" + shown;
            } else if (!variable.is_own) {
                variable.name = name_before(operand);
            }
        }
        found.emplace_back(cell.output, std::move(variable));
    }
    for (auto& [net, variable] : found) named_.try_emplace(net, std::move(variable));
}

/// What a net makes of named things, or nothing where it needs others.
std::string NetReader::text_of(NetId net) const {
    const Cone cone = cone_of(net, false);
    FunctionVariables variables;
    for (const NetId leaf : cone.leaf_order) {
        const FunctionVariable& variable = cone.leaves.at(leaf);
        if (variable.is_own) return {};
        variables.add(variable);
    }
    if (variables.size() > 8 || !cone.loops.empty()) return {};
    const TruthTable table = function(cone, variables);
    const auto sum = irredundant_sum(table, table, variables.size(), most_edge_products);
    return sum ? sum_text(*sum, variables) : std::string();
}

std::optional<FunctionVariable> NetReader::leaf(NetId net) const {
    const auto named = named_.find(net);
    if (named != named_.end()) return named->second;
    const CellId driver = drivers_[net];
    const bool goes_on = driver != no_cell && (is_gate_type(netlist_.cells[driver].type) ||
                                               netlist_.cells[driver].type == CellType::latch ||
                                               netlist_.cells[driver].type == CellType::hold_latch);
    if (goes_on) return std::nullopt;
    return FunctionVariable{std::string(netlist_.names[net]), net, false, true, true};
}

/// The walk back from a net. On the way from the port of an X to where it is made, and into the
/// other half of its own latch, it goes on; it ends where it comes back.
class NetReader::Walk {
  public:
    Walk(const NetReader& reader, std::string own) : reader_(reader), own_(std::move(own)) {}

    Cone from(NetId root) {
        visit(root);
        while (!stack_.empty()) {
            const NetId net = stack_.back().net;
            const std::size_t next = stack_.back().next_pin++;
            const Cell& cell = reader_.netlist_.cells[reader_.drivers_[net]];
            const auto pins = reader_.netlist_.pins_of(cell);
            if (next < pins_read(cell)) {
                visit(next < pins.size() ? pins[next] : net);
                continue;
            }
            is_on_path_[net] = false;
            cone_.inner.push_back(net);
            stack_.pop_back();
        }
        return std::move(cone_);
    }

  private:
    /// Of a flip-flop the data alone; of a latch what it holds as well.
    static std::size_t pins_read(const Cell& cell) {
        if (cell.type == CellType::flip_flop) return 1;
        const bool holds = cell.type == CellType::latch || cell.type == CellType::hold_latch;
        return holds ? 3 : cell.pin_count;
    }
    void visit(NetId net) {
        const auto known = is_on_path_.find(net);
        if (known != is_on_path_.end()) {
            if (known->second) cut(net);
            return;
        }
        const auto variable = reader_.leaf(net);
        const bool is_own = variable && !own_.empty() && variable->name == own_;
        if (variable && (!is_own || reader_.drivers_[net] == no_cell)) {
            return add_leaf(net, *variable);
        }
        is_on_path_[net] = true;
        stack_.push_back({net, 0});
    }
    /// A net the walk is on: what it was before.
    void cut(NetId net) {
        const auto named = reader_.named_.find(net);
        if (named != reader_.named_.end()) return add_leaf(net, named->second);
        add_leaf(net, {std::string(reader_.netlist_.names[net]), net, false, true, true});
        cone_.loops.push_back(net);
    }
    void add_leaf(NetId net, const FunctionVariable& variable) {
        if (cone_.leaves.emplace(net, variable).second) cone_.leaf_order.push_back(net);
    }

    struct Frame {
        NetId net;
        std::size_t next_pin;
    };
    const NetReader& reader_;
    std::string own_;  ///< the name of the X whose memory is read, or empty
    std::vector<Frame> stack_;
    std::unordered_map<NetId, bool> is_on_path_;  ///< of the gates met: whether the walk is on them
    Cone cone_;
};

Cone NetReader::cone_of(NetId net, bool as_memory) const {
    const auto own = named_.find(net);
    return Walk(*this, as_memory && own != named_.end() ? own->second.name : "").from(net);
}

/// The function of one cell, given those of its pins. A latch reads what it held at its own output.
TruthTable NetReader::value_of(const Cell& cell, const std::unordered_map<NetId, TruthTable>& known,
                               std::size_t variables) const {
    const auto pins = netlist_.pins_of(cell);
    const auto pin = [&](std::size_t index) { return known.at(pins[index]); };
    const auto all = [&](bool start, auto&& join) {
        TruthTable table(variables, start);
        for (const NetId net : pins) join(table, known.at(net));
        return table;
    };
    const auto conjunction = [](TruthTable& a, const TruthTable& b) { a &= b; };
    const auto disjunction = [](TruthTable& a, const TruthTable& b) { a |= b; };
    switch (cell.type) {
        case CellType::low:
            return {variables, false};
        case CellType::high:
            return {variables, true};
        case CellType::inverter:
            return ~pin(0);
        case CellType::and_gate:
            return all(true, conjunction);
        case CellType::nand_gate:
            return ~all(true, conjunction);
        case CellType::or_gate:
            return all(false, disjunction);
        case CellType::nor_gate:
            return ~all(false, disjunction);
        case CellType::xor_gate:
            return all(false, [](TruthTable& a, const TruthTable& b) { a ^= b; });
        case CellType::latch:
            return pin(0) | (~pin(1) & known.at(cell.output));
        case CellType::hold_latch:
            return (pin(1) & pin(0)) | (~pin(1) & known.at(cell.output));
        default:
            return pin(0);
    }
}

// `inner` has every net after those it reads, so one pass is enough.
TruthTable NetReader::function(const Cone& cone, const FunctionVariables& variables) const {
    std::unordered_map<NetId, TruthTable> known;
    for (const auto& [net, variable] : cone.leaves) {
        const auto index = variables.find(variable.name);
        TruthTable table = TruthTable::variable(variables.size(), index.value_or(0));
        known.emplace(net, variable.is_inverted ? ~table : table);
    }
    TruthTable last(variables.size(), false);
    if (cone.inner.empty() && !cone.leaf_order.empty()) return known.at(cone.leaf_order[0]);
    for (const NetId net : cone.inner) {
        last = value_of(netlist_.cells[drivers_[net]], known, variables.size());
        // Where a loop was cut, what stands in it has read what the net was, the rest what it is.
        known.insert_or_assign(net, last);
    }
    return last;
}

}  // namespace grafwire
