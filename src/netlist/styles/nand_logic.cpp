// AND and OR by De Morgan: `a.b + c` is NAND(NAND(a, b), NAND(c)), where NAND of one net is an
// inverter. Exclusive OR of two takes its four NAND gates.

#include "netlist/styles/nand_logic.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace grafwire {

NandLogic::NandLogic(const Grafcet& grafcet, const Equations& equations, ChartNetlist& chart,
                     const VariableNets& nets)
    : grafcet_(grafcet),
      pool_(equations.expressions),
      chart_(chart),
      nets_(nets),
      made_{std::vector<NetId>(pool_.size(), no_net), std::vector<NetId>(pool_.size(), no_net)} {}

NetId NandLogic::made(ExprId id, bool negated, const GateMaker& gates) {
    if (made_[negated ? 1 : 0][index_of(id)] == no_net) {
        const NetId net = make(id, negated, gates);
        made_[negated ? 1 : 0][index_of(id)] = net;
    }
    return made_[negated ? 1 : 0][index_of(id)];
}

NetId NandLogic::make(ExprId id, bool negated, const GateMaker& gates) {
    switch (pool_.kind(id)) {
        case ExprKind::constant:
            return pool_.constant_value(id) != negated ? gates.high() : gates.low();
        case ExprKind::negation:
            return made(pool_.operands(id)[0], !negated, gates);
        case ExprKind::conjunction:
            if (!negated) return gates.inverted(made(id, true, gates));
            return nand_of(nets_of(pool_.operands(id), false, gates), gates);
        case ExprKind::disjunction:
            if (negated) return gates.inverted(made(id, false, gates));
            return nand_of(nets_of(pool_.operands(id), true, gates), gates);
        case ExprKind::exclusive_or:
            if (negated) return gates.inverted(made(id, false, gates));
            return exclusive(pool_.operands(id), gates);
        default:
            break;
    }
    if (negated) return gates.inverted(made(id, false, gates));
    if (pool_.kind(id) == ExprKind::time_condition) return timer(id, gates);
    assert(pool_.kind(id) == ExprKind::variable);
    return variable(pool_.variable_of(id), gates);
}

NetId NandLogic::variable(Variable variable, const GateMaker& gates) {
    switch (variable.kind) {
        case VariableKind::input:
            return nets_.inputs[variable.index];
        case VariableKind::control: {
            const NetId net = nets_.control(grafcet_, static_cast<ControlInput>(variable.index));
            return net == no_net ? gates.low() : net;
        }
        case VariableKind::step:
            return nets_.steps[variable.index];
        case VariableKind::output:
            return nets_.outputs[variable.index];
        case VariableKind::var:
            return nets_.vars[variable.index];
        default:
            break;
    }
    assert(false && "equations hold no such variable");
    return gates.low();
}

std::vector<NetId> NandLogic::nets_of(std::span<const ExprId> ids, bool negated,
                                      const GateMaker& gates) {
    std::vector<NetId> nets;
    for (const ExprId id : ids) nets.push_back(made(id, negated, gates));
    return nets;
}

std::uint32_t NandLogic::next_number(const GateMaker& gates) {
    for (auto& [owner, number] : role_numbers_) {
        if (owner == gates.owner()) return ++number;
    }
    role_numbers_.emplace_back(gates.owner(), 1);
    return 1;
}

NetId NandLogic::nand_of(std::span<const NetId> pins, const GateMaker& gates) {
    if (pins.size() == 1) return gates.inverted(pins[0]);
    return gates.gate(CellType::nand_gate, pins, std::to_string(next_number(gates)));
}

NetId NandLogic::exclusive(std::span<const ExprId> ids, const GateMaker& gates) {
    NetId sum = net(ids[0], gates);
    for (const ExprId id : ids.subspan(1)) {
        const NetId other = net(id, gates);
        const auto nand = [&](NetId a, NetId b) {
            const NetId pins[] = {a, b};
            return nand_of(pins, gates);
        };
        const NetId both = nand(sum, other);
        const NetId only_sum = nand(sum, both);
        const NetId only_other = nand(other, both);
        sum = nand(only_sum, only_other);
    }
    return sum;
}

void NandLogic::drive(NetId output, ExprId id, const GateMaker& gates) {
    if (pool_.kind(id) == ExprKind::constant) {
        gates.add_cell(pool_.constant_value(id) ? CellType::high : CellType::low, output, {});
    } else if (pool_.kind(id) == ExprKind::disjunction) {
        gates.drive(output, CellType::nand_gate, nets_of(pool_.operands(id), true, gates));
    } else {
        const NetId pins[] = {complement(id, gates)};
        gates.drive(output, CellType::nand_gate, pins);
    }
}

NetId NandLogic::timer(ExprId id, const GateMaker& gates) {
    NetId& made_before = made_[0][index_of(id)];
    if (made_before != no_net) return made_before;
    const TimeCondition& condition = pool_.time_condition_of(id);
    const NetId operand = net(condition.operand, gates);
    const Location where = chart_.builder().netlist().origins[gates.place().origin].where;
    const GateMaker own = gates.made_for(chart_.origin_of(pool_, id, where));
    const std::size_t ordinal = pool_.ordinal(id);
    const NetId output = chart_.builder().add_inner_net(operand, "timer" + std::to_string(ordinal));
    const Timing timing{condition.on_delay, condition.off_delay,
                        static_cast<std::uint32_t>(ordinal)};
    own.add_cell(CellType::timer, output, {&operand, 1}, {Logic::zero, timing});
    return made_[0][index_of(id)] = output;
}

}  // namespace grafwire
