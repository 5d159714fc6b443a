// The inputs at one moment after the other, and the assumptions of the chart under them.
//
// An assumption speaks of inputs and control inputs alone (others are refused when the GRAFCET is
// read), so that two values and plain recursion are enough. Whether inputs that are partly open can
// satisfy it is the business of the check.

#include "trace/input_values.h"

#include <algorithm>
#include <cassert>

namespace grafwire {

std::vector<Logic> known_inputs(const InputValues& values) {
    std::vector<Logic> inputs(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) inputs[i] = logic_of(values[i] != 0);
    return inputs;
}

bool StimuliPlayer::advance(Time now) {
    const std::size_t first = next_;
    for (; next_change() <= now && next_ < stimuli_.changes.size(); ++next_) {
        for (const Stimuli::Assignment& set : stimuli_.changes[next_].assignments) {
            inputs_[set.input] = set.value ? 1 : 0;
        }
    }
    return next_ != first;
}

Time StimuliPlayer::next_change() const {
    return next_ < stimuli_.changes.size() ? stimuli_.changes[next_].at : never;
}

namespace {

/// An expression over inputs and control inputs alone.
bool value_of(const Grafcet& grafcet, ExprId id, const InputValues& inputs) {
    const Expressions& expressions = grafcet.expressions;
    const auto value = [&](ExprId operand) { return value_of(grafcet, operand, inputs); };
    const auto operands = expressions.operands(id);
    switch (expressions.kind(id)) {
        case ExprKind::constant:
            return expressions.constant_value(id);
        case ExprKind::variable: {
            const Variable variable = expressions.variable_of(id);
            const bool is_control = variable.kind == VariableKind::control;
            assert(is_control || variable.kind == VariableKind::input);
            return inputs[variable.index + (is_control ? grafcet.inputs.size() : 0)] != 0;
        }
        case ExprKind::negation:
            return !value(operands.front());
        case ExprKind::conjunction:
            return std::all_of(operands.begin(), operands.end(), value);
        case ExprKind::disjunction:
            return std::any_of(operands.begin(), operands.end(), value);
        case ExprKind::exclusive_or:
            return std::count_if(operands.begin(), operands.end(), value) % 2 != 0;
        default:
            assert(false);  // refused when the assumption was read
            return true;
    }
}

}  // namespace

bool assumption_holds(const Grafcet& grafcet, std::size_t assumption, const InputValues& inputs) {
    return value_of(grafcet, grafcet.assumptions[assumption].expression, inputs);
}

std::size_t broken_assumption(const Grafcet& grafcet, const InputValues& inputs) {
    std::size_t i = 0;
    while (i < grafcet.assumptions.size() && assumption_holds(grafcet, i, inputs)) ++i;
    return i;
}

}  // namespace grafwire
