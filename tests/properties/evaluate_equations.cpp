#include "properties/evaluate_equations.h"

namespace grafwire::testing {

namespace {

std::int64_t sum_of(const Sum& terms, const std::vector<std::int64_t>& counters) {
    std::int64_t total = 0;
    for (const SumTerm& term : terms) {
        const std::int64_t value =
            term.counter == SumTerm::no_counter ? term.value : counters[term.counter];
        total += term.negative ? -value : value;
    }
    return total;
}

bool holds(const Comparison& comparison, const std::vector<std::int64_t>& counters) {
    const std::int64_t left = sum_of(comparison.left, counters);
    const std::int64_t right = sum_of(comparison.right, counters);
    switch (comparison.relation) {
        case Relation::equal:
            return left == right;
        case Relation::not_equal:
            return left != right;
        case Relation::less:
            return left < right;
        case Relation::less_equal:
            return left <= right;
        case Relation::greater:
            return left > right;
        case Relation::greater_equal:
            return left >= right;
    }
    return false;
}

bool variable_value(Variable variable, const EquationValues& values) {
    switch (variable.kind) {
        case VariableKind::input:
            return (*values.inputs)[variable.index] != 0;
        case VariableKind::control:
            return (*values.inputs)[values.inputs->size() - control_input_count + variable.index] !=
                   0;
        case VariableKind::output:
            return values.state->stored_outputs.test(variable.index);
        case VariableKind::var:
            return values.state->vars.test(variable.index);
        case VariableKind::step:
            return values.steps[variable.index];
        default:
            return false;  // equations hold no counter, macro-step or graph as a variable
    }
}

}  // namespace

bool equation_value(const Equations& equations, ExprId id, const EquationValues& values) {
    const Expressions& pool = equations.expressions;
    const auto value = [&](ExprId operand) { return equation_value(equations, operand, values); };
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool.constant_value(id);
        case ExprKind::variable:
            return variable_value(pool.variable_of(id), values);
        case ExprKind::negation:
            return !value(pool.operands(id)[0]);
        case ExprKind::conjunction:
            for (const ExprId operand : pool.operands(id)) {
                if (!value(operand)) return false;
            }
            return true;
        case ExprKind::disjunction:
            for (const ExprId operand : pool.operands(id)) {
                if (value(operand)) return true;
            }
            return false;
        case ExprKind::exclusive_or: {
            bool odd = false;
            for (const ExprId operand : pool.operands(id)) odd = odd != value(operand);
            return odd;
        }
        case ExprKind::rise:
        case ExprKind::fall:
            return values.state->edges.test(pool.ordinal(id));
        case ExprKind::time_condition:
            return values.state->time_values.test(pool.ordinal(id));
        case ExprKind::comparison:
            return holds(pool.comparison_of(id), values.state->counters);
    }
    return false;
}

}  // namespace grafwire::testing
