// Conditions: the expressions of the chart with their variables replaced by bits.
//
// They are folded a little, because a network `LD SM0.0 . X3` is of no use; beyond that they stay
// as they were written, so that readers of the program find the transition condition of the chart
// in it.

#include <utility>

#include "program/program_parts.h"

namespace grafwire {

namespace {

/// AND and OR: drops the neutral constant, gives the other one if it occurs, merges nested operands
/// of the same kind.
Condition folded(Condition::Kind kind, bool neutral, std::vector<Condition> operands) {
    Condition result;
    result.kind = kind;
    for (Condition& operand : operands) {
        if (operand.is_constant(neutral)) continue;
        if (operand.is_constant(!neutral)) return constant_condition(!neutral);
        if (operand.kind != kind) {
            result.operands.push_back(std::move(operand));
            continue;
        }
        for (Condition& inner : operand.operands) result.operands.push_back(std::move(inner));
    }
    if (result.operands.empty()) return constant_condition(neutral);
    if (result.operands.size() > 1) return result;
    Condition only = std::move(result.operands.front());
    return only;
}

}  // namespace

Condition constant_condition(bool value) {
    Condition condition;
    condition.value = value;
    return condition;
}

Condition bit_condition(Bit bit) {
    Condition condition;
    condition.kind = Condition::Kind::bit;
    condition.bit = bit;
    return condition;
}

Condition not_condition(Condition operand) {
    if (operand.kind == Condition::Kind::constant) return constant_condition(!operand.value);
    if (operand.kind == Condition::Kind::negation) {
        Condition inner = std::move(operand.operands.front());
        return inner;
    }
    Condition condition;
    condition.kind = Condition::Kind::negation;
    condition.operands.push_back(std::move(operand));
    return condition;
}

Condition and_condition(std::vector<Condition> operands) {
    return folded(Condition::Kind::conjunction, true, std::move(operands));
}

Condition or_condition(std::vector<Condition> operands) {
    return folded(Condition::Kind::disjunction, false, std::move(operands));
}

Condition ChartConditions::any_step(Range<StepId> steps) {
    std::vector<Condition> active;
    for (const StepId step : steps) active.push_back(bit_condition(step_bit(BitKind::step, step)));
    return or_condition(std::move(active));
}

Condition ChartConditions::control(ControlInput control) const {
    if (!has_modes_) return constant_condition(false);
    return bit_condition({BitKind::control, static_cast<std::uint32_t>(control)});
}

Condition ChartConditions::of(Variable variable) const {
    switch (variable.kind) {
        case VariableKind::input:
            return bit_condition({BitKind::input, variable.index});
        case VariableKind::control:
            return control(static_cast<ControlInput>(variable.index));
        case VariableKind::output:
            return bit_condition({BitKind::output, variable.index});
        case VariableKind::var:
            return bit_condition({BitKind::var, variable.index});
        case VariableKind::step:
            return bit_condition({BitKind::step, variable.index});
        case VariableKind::macro: {
            const Macro& macro = grafcet_.macros[MacroId{variable.index}];
            return any_step(macro.steps);
        }
        case VariableKind::graph: {
            const Graph& graph = grafcet_.graphs[GraphId{variable.index}];
            return any_step(graph.steps);
        }
        case VariableKind::counter:
            break;  // never a Boolean operand
    }
    return constant_condition(false);
}

Condition ChartConditions::of(ExprId id) const {
    const Expressions& pool = grafcet_.expressions;
    std::vector<Condition> operands;
    const ExprKind kind = pool.kind(id);
    if (kind == ExprKind::conjunction || kind == ExprKind::disjunction ||
        kind == ExprKind::exclusive_or || kind == ExprKind::negation) {
        for (const ExprId operand : pool.operands(id)) operands.push_back(of(operand));
    }
    Condition condition;
    switch (kind) {
        case ExprKind::constant:
            return constant_condition(pool.constant_value(id));
        case ExprKind::variable:
            return of(pool.variable_of(id));
        case ExprKind::negation:
            return not_condition(std::move(operands.front()));
        case ExprKind::conjunction:
            return and_condition(std::move(operands));
        case ExprKind::disjunction:
            return or_condition(std::move(operands));
        case ExprKind::exclusive_or:
            condition.kind = Condition::Kind::exclusive_or;
            condition.operands = std::move(operands);
            return condition;
        case ExprKind::rise:
        case ExprKind::fall:
            return bit_condition({BitKind::edge, static_cast<std::uint32_t>(pool.ordinal(id))});
        case ExprKind::time_condition:
            return bit_condition(
                {BitKind::time_value, static_cast<std::uint32_t>(pool.ordinal(id))});
        case ExprKind::comparison:
            condition.kind = Condition::Kind::comparison;
            condition.comparison = pool.comparison_of(id);
            return condition;
    }
    return condition;
}

}  // namespace grafwire
