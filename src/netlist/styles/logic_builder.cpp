// Expressions as gates, with buffers where operands come at different times.
//
// An example, with every gate of 1 ns: `a . /b` has an operand straight from an input (0 ns) and
// one behind an inverter (1 ns). So `a` gets one buffer, and the AND sees both inputs 1 ns after
// they changed; the product itself has come 2 ns. Buffers are shared (GateMaker::delayed), as most
// products of a chart read the same few inputs.
//
// Pulse cells and timers keep or forget the time: a pulse comes one delay after its operand like
// any gate; the end of a delay is an event of its own, as an input is, from which time counts anew.

#include "netlist/styles/logic_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

/// From an X to the stored variable that it writes.
constexpr CellType path_of_write[] = {CellType::rise_pulse, CellType::and_gate, CellType::or_gate,
                                      CellType::latch};

CellType gate_for(ExprKind kind) {
    switch (kind) {
        case ExprKind::conjunction:
            return CellType::and_gate;
        case ExprKind::disjunction:
            return CellType::or_gate;
        default:
            return CellType::xor_gate;
    }
}

}  // namespace

LogicBuilder::LogicBuilder(const Grafcet& grafcet, const Equations& equations, ChartNetlist& chart,
                           const VariableNets& nets, const DelayModel& delays, Time pulse_width)
    : grafcet_(grafcet),
      pool_(equations.expressions),
      chart_(chart),
      nets_(nets),
      delays_(delays),
      pulse_width_(pulse_width),
      write_latency_(delays.of_path(path_of_write)),
      made_(equations.expressions.size()) {}

LogicBuilder::Signal LogicBuilder::signal(ExprId id, const GateMaker& gates) {
    if (made_[index_of(id)].net == no_net) {
        const Signal made = make(id, gates);
        made_[index_of(id)] = made;
    }
    return made_[index_of(id)];
}

LogicBuilder::Signal LogicBuilder::make(ExprId id, const GateMaker& gates) {
    switch (pool_.kind(id)) {
        case ExprKind::constant:
            return {pool_.constant_value(id) ? gates.high() : gates.low()};
        case ExprKind::variable:
            return make_variable(pool_.variable_of(id), gates);
        case ExprKind::negation: {
            const Signal operand = signal(pool_.operands(id)[0], gates);
            return operand.through(gates.inverted(operand.net), delays_.of(CellType::inverter));
        }
        case ExprKind::conjunction:
        case ExprKind::disjunction:
        case ExprKind::exclusive_or: {
            std::vector<Signal> operands;
            for (const ExprId operand : pool_.operands(id))
                operands.push_back(signal(operand, gates));
            return make_gate(gate_for(pool_.kind(id)), std::move(operands), gates);
        }
        case ExprKind::rise:
        case ExprKind::fall:
            return make_edge(id, gates);
        case ExprKind::time_condition:
            return make_time_condition(id, gates);
        case ExprKind::comparison:
            break;
    }
    assert(false && "asynchronous netlists have no counters");
    return {gates.low()};
}

/// Inputs change by themselves, and X variables as their consequence: each is latency 0 of its
/// kind. A stored output or var has come as far since an X as it takes to be written.
LogicBuilder::Signal LogicBuilder::make_variable(Variable variable, const GateMaker& gates) {
    switch (variable.kind) {
        case VariableKind::input:
            return {nets_.inputs[variable.index], 0, Signal::independent};
        case VariableKind::control: {
            const NetId net = nets_.control(grafcet_, static_cast<ControlInput>(variable.index));
            return net == no_net ? Signal{gates.low()} : Signal{net, 0, Signal::independent};
        }
        case VariableKind::step:
            return {nets_.steps[variable.index], Signal::independent, 0};
        case VariableKind::output:
            return {nets_.outputs[variable.index], Signal::independent, write_latency_};
        case VariableKind::var:
            return {nets_.vars[variable.index], Signal::independent, write_latency_};
        case VariableKind::counter:
        case VariableKind::macro:
        case VariableKind::graph:
            break;
    }
    assert(false && "equations hold no such variable");
    return {gates.low()};
}

/// Returns what the operands have in common then: their latencies (and no net).
LogicBuilder::Signal LogicBuilder::align(std::vector<Signal>& operands,
                                         const GateMaker& gates) const {
    Time input = Signal::independent;
    Time step = Signal::independent;
    bool mixed = false;
    for (const Signal& operand : operands) {
        input = std::max(input, operand.since_input);
        step = std::max(step, operand.since_step);
        mixed |= operand.since_input >= 0 && operand.since_step >= 0;
    }
    if (mixed) input = step = std::max(input, step);
    for (Signal& operand : operands) {
        const Time latency = std::max(operand.since_input, operand.since_step);
        if (latency < 0) continue;
        const Time wanted = operand.since_input >= 0 ? input : step;
        operand.net = delayed(operand.net, wanted - latency, gates);
    }
    return {no_net, input, step};
}

LogicBuilder::Signal LogicBuilder::make_gate(CellType type, std::vector<Signal> operands,
                                             const GateMaker& gates) {
    const Signal aligned = align(operands, gates);
    std::vector<NetId> nets;
    for (const Signal& operand : operands) nets.push_back(operand.net);
    const std::string role = fmt::format("{}", ++role_numbers_[gates.owner()]);
    return aligned.through(gates.gate(type, nets, role), delays_.of(type));
}

/// An edge or time condition is an origin of its own, at the place of what reads it first.
GateMaker LogicBuilder::made_for(ExprId id, const GateMaker& gates) {
    const Location where = chart_.builder().netlist().origins[gates.place().origin].where;
    return gates.made_for(chart_.origin_of(pool_, id, where));
}

LogicBuilder::Signal LogicBuilder::make_edge(ExprId id, const GateMaker& gates) {
    const Signal operand = signal(pool_.operands(id)[0], gates);
    const GateMaker own = made_for(id, gates);
    const bool rising = pool_.kind(id) == ExprKind::rise;
    const NetId output = chart_.builder().add_inner_net(
        operand.net, fmt::format("{}{}", rising ? "rise" : "fall", pool_.ordinal(id)));
    const Timing timing{0, pulse_width_, Timing::no_ordinal};
    const CellType type = rising ? CellType::rise_pulse : CellType::fall_pulse;
    own.add_cell(type, output, {&operand.net, 1}, {Logic::unknown, timing});
    return operand.through(output, delays_.of(type));
}

LogicBuilder::Signal LogicBuilder::make_time_condition(ExprId id, const GateMaker& gates) {
    const TimeCondition& condition = pool_.time_condition_of(id);
    const Signal operand = signal(condition.operand, gates);
    const GateMaker own = made_for(id, gates);
    const std::size_t ordinal = pool_.ordinal(id);
    const NetId output =
        chart_.builder().add_inner_net(operand.net, fmt::format("timer{}", ordinal));
    const Timing timing{condition.on_delay, condition.off_delay,
                        static_cast<std::uint32_t>(ordinal)};
    own.add_cell(CellType::timer, output, {&operand.net, 1}, {Logic::zero, timing});
    return {output, 0, Signal::independent};
}

std::vector<LogicBuilder::Signal> LogicBuilder::factor_signals(ExprId id, const GateMaker& gates) {
    if (pool_.kind(id) == ExprKind::constant && pool_.constant_value(id)) return {};
    if (pool_.kind(id) != ExprKind::conjunction) return {signal(id, gates)};
    std::vector<Signal> operands;
    for (const ExprId operand : pool_.operands(id)) operands.push_back(signal(operand, gates));
    return operands;
}

std::vector<NetId> LogicBuilder::aligned_nets(std::vector<Signal> signals,
                                              const GateMaker& gates) const {
    align(signals, gates);
    std::vector<NetId> nets;
    for (const Signal& signal : signals) nets.push_back(signal.net);
    return nets;
}

std::vector<NetId> LogicBuilder::factors(ExprId id, const GateMaker& gates) {
    return aligned_nets(factor_signals(id, gates), gates);
}

std::vector<NetId> LogicBuilder::clearing_factors(ExprId id, const std::vector<std::uint8_t>& slow,
                                                  ExprId frozen, const GateMaker& gates) {
    std::vector<Signal> signals = factor_signals(id, gates);
    const bool is_product = pool_.kind(id) == ExprKind::conjunction;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        const ExprId factor = is_product ? pool_.operands(id)[i] : id;
        bool waits = frozen != no_expr && pool_.kind(factor) == ExprKind::negation &&
                     pool_.operands(factor)[0] == frozen;
        if (pool_.kind(factor) == ExprKind::variable) {
            const Variable variable = pool_.variable_of(factor);
            waits |= variable.kind == VariableKind::step && slow[variable.index] != 0;
        }
        if (!waits) continue;
        signals[i].net = delayed(signals[i].net, write_latency_, gates);
        signals[i].since_step += write_latency_;
    }
    return aligned_nets(std::move(signals), gates);
}

Time LogicBuilder::input_latency(ExprId product, const GateMaker& gates) {
    Time latency = 0;
    for (const Signal& factor : factor_signals(product, gates)) {
        latency = std::max(latency, factor.since_input);
    }
    return latency;
}

// Only what lies above a held variable is made once more; everything else is shared.
LogicBuilder::Signal LogicBuilder::held_signal(ExprId id, const HeldNets& held,
                                               const GateMaker& gates) {
    const ExprKind kind = pool_.kind(id);
    if (kind == ExprKind::variable) {
        const Variable variable = pool_.variable_of(id);
        const bool is_output = variable.kind == VariableKind::output;
        if (!is_output && variable.kind != VariableKind::var) return signal(id, gates);
        const NetId net = (is_output ? held.outputs : held.vars)[variable.index];
        return net == no_net ? signal(id, gates) : Signal{net, Signal::independent, 0};
    }
    const bool is_operator = kind == ExprKind::negation || kind == ExprKind::conjunction ||
                             kind == ExprKind::disjunction || kind == ExprKind::exclusive_or;
    if (!is_operator) return signal(id, gates);
    std::vector<Signal> operands;
    bool any_held = false;
    for (const ExprId operand : pool_.operands(id)) {
        operands.push_back(held_signal(operand, held, gates));
        any_held |= operands.back().net != net(operand, gates);
    }
    if (!any_held) return signal(id, gates);
    if (kind == ExprKind::negation) {
        return operands[0].through(gates.inverted(operands[0].net), delays_.of(CellType::inverter));
    }
    return make_gate(gate_for(kind), std::move(operands), gates);
}

}  // namespace grafwire
