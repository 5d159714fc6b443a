// The logic of a clocked netlist: expressions as gates, edges as flip-flops, time conditions as
// clocked timers.
//
// An expression is made once for every view in which it is read. An edge compares its operand with
// a flip-flop that holds what that was a scan ago; one more flip-flop, `running`, is 0 in the first
// scan alone, in which there are no edges. Time conditions end with the scan: what reads one in the
// next scan looks at its timer; where one stands in the operand of another it is a look-ahead,
// which shows what the timer will take at the coming rise of the clock.

#include "netlist/styles/clocked_logic.h"

#include <fmt/format.h>

#include <cassert>

namespace grafwire {

ClockedNetlist::ClockedNetlist(const Grafcet& chart_of, const Equations& equations_of)
    : grafcet(chart_of), equations(equations_of), chart(grafcet) {
    inputs = chart.add_inputs(equations.options.modes);
    clock = chart.builder().add_net("clk");
    chart.builder().add_input("clk", clock);
    init = inputs[grafcet.inputs.size()];
    if (init == no_net) return;
    not_init = chart.at_inputs().inverted(init);
    not_au_dur = chart.at_inputs().inverted(inputs[grafcet.inputs.size() + 1]);
}

ClockedLogic::ClockedLogic(ClockedNetlist& netlist)
    : netlist_(netlist), pool_(netlist.equations.expressions) {
    for (std::size_t i = 0; i < pool_.time_conditions().size(); ++i) {
        times_.push_back(netlist.chart.builder().add_inner_net("timer", std::to_string(i)));
    }
}

NetId ClockedLogic::variable_net(const View& view, Variable variable) const {
    switch (variable.kind) {
        case VariableKind::input:
            return netlist_.inputs[variable.index];
        case VariableKind::control:
            return netlist_.inputs[netlist_.grafcet.inputs.size() + variable.index];
        case VariableKind::step:
            return view.steps[variable.index];
        case VariableKind::output:
            return view.outputs[variable.index];
        case VariableKind::var:
            return view.vars[variable.index];
        case VariableKind::counter:
        case VariableKind::macro:
        case VariableKind::graph:
            break;
    }
    assert(false && "equations hold no such variable");
    return no_net;
}

NetId ClockedLogic::net(View& view, ExprId id, NumberedGates& at) {
    if (view.made.size() < pool_.size()) view.made.resize(pool_.size(), no_net);
    if (view.made[index_of(id)] == no_net) {
        const NetId made = make_net(view, id, at);
        view.made[index_of(id)] = made;
    }
    return view.made[index_of(id)];
}

NetId ClockedLogic::make_net(View& view, ExprId id, NumberedGates& at) {
    const GateMaker& gates = at.gates;
    const ExprKind kind = pool_.kind(id);
    switch (kind) {
        case ExprKind::constant:
            return pool_.constant_value(id) ? gates.high() : gates.low();
        case ExprKind::variable: {
            const NetId found = variable_net(view, pool_.variable_of(id));
            return found == no_net ? gates.low() : found;
        }
        case ExprKind::negation:
            return gates.inverted(net(view, pool_.operands(id)[0], at));
        case ExprKind::conjunction:
        case ExprKind::disjunction:
        case ExprKind::exclusive_or: {
            std::vector<NetId> pins;
            for (const ExprId operand : pool_.operands(id)) {
                pins.push_back(net(view, operand, at));
            }
            const CellType type = kind == ExprKind::conjunction   ? CellType::and_gate
                                  : kind == ExprKind::disjunction ? CellType::or_gate
                                                                  : CellType::xor_gate;
            return gates.gate(type, pins, at.next_role());
        }
        case ExprKind::rise:
        case ExprKind::fall:
            return edges_[pool_.ordinal(id)];
        case ExprKind::time_condition:
            return time_net(view, id, at);
        case ExprKind::comparison: {
            const Comparison& comparison = pool_.comparison_of(id);
            Arithmetic arithmetic(gates.named(fmt::format("{}${}", gates.owner(), at.next_role())));
            const Word left = arithmetic.sum(comparison.left, view.counters);
            const Word right = arithmetic.sum(comparison.right, view.counters);
            return arithmetic.compare(left, comparison.relation, right);
        }
    }
    return gates.low();
}

/// Within the operand of another time condition the value at the end of the scan counts, which the
/// timer itself shows only after it.
NetId ClockedLogic::time_net(View& view, ExprId id, NumberedGates& at) {
    const std::size_t ordinal = pool_.ordinal(id);
    const NetId held = times_[ordinal];
    if (!view.is_after) return held;
    const TimeCondition& condition = pool_.time_condition_of(id);
    const NetId operand = net(view, condition.operand, at);
    if (condition.on_delay == 0 && condition.off_delay == 0) return operand;
    const NetId next =
        netlist_.chart.builder().add_inner_net(fmt::format("timer${}", ordinal), "next");
    const NetId pins[] = {operand, held, netlist_.clock};
    const GateMaker own = at.gates.made_for(time_origin(ordinal));
    own.add_cell(CellType::scan_timer_next, next, pins, {Logic::unknown, timing_of(ordinal)});
    return next;
}

Timing ClockedLogic::timing_of(std::size_t ordinal) const {
    const TimeCondition& condition = pool_.time_condition_of(pool_.time_conditions()[ordinal]);
    return {condition.on_delay, condition.off_delay, static_cast<std::uint32_t>(ordinal)};
}

std::uint32_t ClockedLogic::time_origin(std::size_t ordinal) {
    return netlist_.chart.origin_of(pool_, pool_.time_conditions()[ordinal], {});
}

// Only the edges that something reads are needed: those of the GRAFCET, whose ordinals are the same
// here. Edges of steps that the equations add are X and X$next compared.
void ClockedLogic::make_edges(View& now) {
    NetlistBuilder& builder = netlist_.chart.builder();
    const std::size_t count = netlist_.grafcet.expressions.edges().size();
    if (count == 0) return;
    for (std::size_t i = 0; i < count; ++i) {
        edges_.push_back(builder.add_inner_net("edge", std::to_string(i)));
    }
    const GateMaker all =
        netlist_.chart.add_module("edges", builder.add_origin(Origin::Kind::edge, "edges", {}));
    const NetId running = all.add_net("running");
    netlist_.add_flip_flop(running, all.high(), false, all);
    for (std::size_t i = 0; i < count; ++i) {
        const ExprId id = pool_.edges()[i];
        NumberedGates at{
            all.made_for(netlist_.chart.origin_of(pool_, id, {})).named(fmt::format("edge${}", i))};
        const NetId operand = net(now, pool_.operands(id)[0], at);
        const NetId memory = at.gates.add_net("memory");
        netlist_.add_flip_flop(memory, operand, false, at.gates);
        const bool rising = pool_.kind(id) == ExprKind::rise;
        const NetId pins[] = {rising ? operand : at.gates.inverted(operand),
                              rising ? at.gates.inverted(memory) : memory, running};
        at.gates.add_cell(CellType::and_gate, edges_[i], pins);
    }
}

void ClockedLogic::make_time_conditions(View& after) {
    for (std::size_t i = 0; i < times_.size(); ++i) {
        const TimeCondition& condition = pool_.time_condition_of(pool_.time_conditions()[i]);
        NumberedGates at = netlist_.add_module(fmt::format("timer${}", i), time_origin(i));
        const NetId pins[] = {net(after, condition.operand, at), netlist_.clock};
        at.gates.add_cell(CellType::scan_timer, times_[i], pins, {Logic::zero, timing_of(i)});
    }
}

}  // namespace grafwire
