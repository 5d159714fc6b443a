#include "netlist/styles/logic_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "equations/equation_text.h"

namespace grafwire {

LogicBuilder::LogicBuilder(const Equations& equations, ChartNetlist& builder)
    : equations_(equations),
      pool_(equations.expressions),
      builder_(builder),
      made_(equations.expressions.size()) {}

namespace {

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

std::string LogicBuilder::next_role() {
    return fmt::format("{}", ++role_numbers_[owner]);
}

LogicBuilder::Signal LogicBuilder::signal(ExprId id) {
    if (made_.size() <= index_of(id)) made_.resize(pool_.size());
    if (made_[index_of(id)].net == no_net) {
        const Signal made = make(id);
        made_[index_of(id)] = made;
    }
    return made_[index_of(id)];
}

LogicBuilder::Signal LogicBuilder::make(ExprId id) {
    switch (pool_.kind(id)) {
        case ExprKind::constant:
            return {pool_.constant_value(id) ? builder_.high() : builder_.low()};
        case ExprKind::variable:
            return make_variable(pool_.variable_of(id));
        case ExprKind::negation: {
            const Signal operand = signal(pool_.operands(id)[0]);
            return operand.through(builder_.inverted(operand.net));
        }
        case ExprKind::conjunction:
        case ExprKind::disjunction:
        case ExprKind::exclusive_or: {
            std::vector<Signal> operands;
            for (const ExprId operand : pool_.operands(id)) operands.push_back(signal(operand));
            return make_gate(gate_for(pool_.kind(id)), std::move(operands));
        }
        case ExprKind::rise:
        case ExprKind::fall:
            return make_edge(id);
        case ExprKind::time_condition:
            return make_time_condition(id);
        case ExprKind::comparison:
            break;
    }
    assert(false && "asynchronous netlists have no counters");
    return {builder_.low()};
}

LogicBuilder::Signal LogicBuilder::make_variable(Variable variable) {
    switch (variable.kind) {
        case VariableKind::input:
            return {inputs[variable.index], 0, Signal::independent};
        case VariableKind::control: {
            const NetId net = inputs[equations_.grafcet->inputs.size() + variable.index];
            return net == no_net ? Signal{builder_.low()} : Signal{net, 0, Signal::independent};
        }
        case VariableKind::step:
            return {steps[variable.index], Signal::independent, 0};
        case VariableKind::output:
            return {outputs[variable.index], Signal::independent, write_latency};
        case VariableKind::var:
            return {vars[variable.index], Signal::independent, write_latency};
        case VariableKind::counter:
        case VariableKind::macro:
        case VariableKind::graph:
            break;
    }
    assert(false && "equations hold no such variable");
    return {builder_.low()};
}

/// Returns what the operands have in common then: their latencies (and no net).
LogicBuilder::Signal LogicBuilder::align(std::vector<Signal>& operands) {
    int input = Signal::independent;
    int step = Signal::independent;
    bool mixed = false;
    for (const Signal& operand : operands) {
        input = std::max(input, operand.since_input);
        step = std::max(step, operand.since_step);
        mixed |= operand.since_input >= 0 && operand.since_step >= 0;
    }
    if (mixed) input = step = std::max(input, step);
    for (Signal& operand : operands) {
        const int latency = std::max(operand.since_input, operand.since_step);
        if (latency < 0) continue;
        const int wanted = operand.since_input >= 0 ? input : step;
        operand.net = builder_.delayed(operand.net, static_cast<std::uint32_t>(wanted - latency));
    }
    return {no_net, input, step};
}

LogicBuilder::Signal LogicBuilder::make_gate(CellType type, std::vector<Signal> operands) {
    const Signal aligned = align(operands);
    std::vector<NetId> nets;
    for (const Signal& operand : operands) nets.push_back(operand.net);
    return aligned.through(builder_.gate(type, nets, owner, next_role()));
}

LogicBuilder::Signal LogicBuilder::make_edge(ExprId id) {
    const Signal operand = signal(pool_.operands(id)[0]);
    const std::string text = equation_text(equations_, id);
    const std::uint32_t before = builder_.origin();
    builder_.work_on(
        builder_.module(),
        builder_.add_origin(Origin::Kind::edge, text, builder_.netlist().origins[before].where));
    const bool rising = pool_.kind(id) == ExprKind::rise;
    const NetId output =
        builder_.add_net(builder_.netlist().names[operand.net],
                         fmt::format("{}{}", rising ? "rise" : "fall", pool_.ordinal(id)));
    const Timing timing{0, pulse_width, Timing::no_ordinal};
    builder_.add_cell(rising ? CellType::rise_pulse : CellType::fall_pulse, output,
                      {&operand.net, 1}, {Logic::unknown, timing});
    builder_.work_on(builder_.module(), before);
    return operand.through(output);
}

LogicBuilder::Signal LogicBuilder::make_time_condition(ExprId id) {
    const TimeCondition& condition = pool_.time_condition_of(id);
    const Signal operand = signal(condition.operand);
    const std::size_t ordinal = pool_.ordinal(id);
    const std::uint32_t before = builder_.origin();
    builder_.work_on(
        builder_.module(),
        builder_.add_origin(Origin::Kind::time_condition, equation_text(equations_, id),
                            builder_.netlist().origins[before].where));
    const NetId output =
        builder_.add_net(builder_.netlist().names[operand.net], fmt::format("timer{}", ordinal));
    const Timing timing{condition.on_delay, condition.off_delay,
                        static_cast<std::uint32_t>(ordinal)};
    builder_.add_cell(CellType::timer, output, {&operand.net, 1}, {Logic::zero, timing});
    builder_.work_on(builder_.module(), before);
    return {output, 0, Signal::independent};
}

std::vector<LogicBuilder::Signal> LogicBuilder::factor_signals(ExprId id) {
    if (pool_.kind(id) == ExprKind::constant && pool_.constant_value(id)) return {};
    if (pool_.kind(id) != ExprKind::conjunction) return {signal(id)};
    std::vector<Signal> operands;
    for (const ExprId operand : pool_.operands(id)) operands.push_back(signal(operand));
    return operands;
}

std::vector<NetId> LogicBuilder::aligned_nets(std::vector<Signal> signals) {
    align(signals);
    std::vector<NetId> nets;
    for (const Signal& signal : signals) nets.push_back(signal.net);
    return nets;
}

std::vector<NetId> LogicBuilder::factors(ExprId id) {
    return aligned_nets(factor_signals(id));
}

std::vector<NetId> LogicBuilder::clearing_factors(ExprId id, const std::vector<std::uint8_t>& slow,
                                                  ExprId late) {
    std::vector<Signal> signals = factor_signals(id);
    const bool is_product = pool_.kind(id) == ExprKind::conjunction;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        const ExprId factor = is_product ? pool_.operands(id)[i] : id;
        bool waits = factor == late;
        if (pool_.kind(factor) == ExprKind::variable) {
            const Variable variable = pool_.variable_of(factor);
            waits |= variable.kind == VariableKind::step && slow[variable.index] != 0;
        }
        if (!waits) continue;
        signals[i].net = builder_.delayed(signals[i].net, write_latency);
        signals[i].since_step += write_latency;
    }
    return aligned_nets(std::move(signals));
}

unsigned LogicBuilder::input_latency(ExprId product) {
    int latency = 0;
    for (const Signal& factor : factor_signals(product)) {
        latency = std::max(latency, factor.since_input);
    }
    return static_cast<unsigned>(latency);
}

LogicBuilder::Signal LogicBuilder::held_signal(ExprId id, const std::vector<NetId>& held_outputs,
                                               const std::vector<NetId>& held_vars) {
    const ExprKind kind = pool_.kind(id);
    if (kind == ExprKind::variable) {
        const Variable variable = pool_.variable_of(id);
        const bool is_output = variable.kind == VariableKind::output;
        if (!is_output && variable.kind != VariableKind::var) return signal(id);
        const NetId held = (is_output ? held_outputs : held_vars)[variable.index];
        return held == no_net ? signal(id) : Signal{held, Signal::independent, 0};
    }
    const bool is_operator = kind == ExprKind::negation || kind == ExprKind::conjunction ||
                             kind == ExprKind::disjunction || kind == ExprKind::exclusive_or;
    if (!is_operator) return signal(id);
    std::vector<Signal> operands;
    bool any_held = false;
    for (const ExprId operand : pool_.operands(id)) {
        operands.push_back(held_signal(operand, held_outputs, held_vars));
        any_held |= operands.back().net != net(operand);
    }
    if (!any_held) return signal(id);
    if (kind == ExprKind::negation) {
        return operands[0].through(builder_.inverted(operands[0].net));
    }
    return make_gate(gate_for(kind), std::move(operands));
}

}  // namespace grafwire
