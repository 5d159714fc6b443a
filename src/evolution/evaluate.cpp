// Reading expressions.
//
// Plain recursion over the shared nodes, with short-circuit evaluation. It is not compiled to code
// for a stack machine: few expressions are read per scan (those of enabled transitions), most have
// two or three operands, and the depth is bounded by the nesting that the language allows.

#include "evolution/evaluate.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "evolution/bit_table.h"
#include "grafcet/expression.h"

namespace grafwire {

ExactSum ExactSum::carried() const {
    ExactSum sum;
    sum.high_ = high_ + (low_ >> 32);  // the shift rounds down, also below 0
    sum.low_ = low_ & 0xffffffff;
    return sum;
}

int ExactSum::compare(const ExactSum& other) const {
    const ExactSum a = carried();
    const ExactSum b = other.carried();
    if (a.high_ != b.high_) return a.high_ < b.high_ ? -1 : 1;
    if (a.low_ != b.low_) return a.low_ < b.low_ ? -1 : 1;
    return 0;
}

std::int64_t ExactSum::held_within(std::int64_t low, std::int64_t high) const {
    const ExactSum sum = carried();
    if (sum.high_ < std::numeric_limits<std::int32_t>::min()) return low;
    if (sum.high_ > std::numeric_limits<std::int32_t>::max()) return high;
    return std::clamp(sum.high_ * (std::int64_t{1} << 32) + sum.low_, low, high);
}

bool Evaluator::value(ExprId id) const {
    const Expressions& expressions = grafcet_.expressions;
    switch (expressions.kind(id)) {
        case ExprKind::constant:
            return expressions.constant_value(id);
        case ExprKind::variable:
            return variable(expressions.variable_of(id));
        case ExprKind::negation:
            return !value(expressions.operands(id).front());
        case ExprKind::conjunction:
            for (const ExprId operand : expressions.operands(id)) {
                if (!value(operand)) return false;
            }
            return true;
        case ExprKind::disjunction:
            for (const ExprId operand : expressions.operands(id)) {
                if (value(operand)) return true;
            }
            return false;
        case ExprKind::exclusive_or: {
            bool odd = false;
            for (const ExprId operand : expressions.operands(id)) odd = odd != value(operand);
            return odd;
        }
        case ExprKind::rise:
        case ExprKind::fall:
            return state_.edges.test(tables_.ordinals[static_cast<std::size_t>(id)]);
        case ExprKind::time_condition:
            return state_.time_values.test(tables_.ordinals[static_cast<std::size_t>(id)]);
        case ExprKind::comparison:
            return comparison(expressions.comparison_of(id));
    }
    assert(false);
    return false;
}

bool Evaluator::variable(Variable variable) const {
    switch (variable.kind) {
        case VariableKind::input:
            return input(variable.index);
        case VariableKind::control:
            return input(grafcet_.inputs.size() + variable.index);
        case VariableKind::output:
            return state_.stored_outputs.test(variable.index);
        case VariableKind::var:
            return state_.vars.test(variable.index);
        case VariableKind::step:
            return state_.situation.test(variable.index);
        case VariableKind::macro: {
            const Macro& macro = grafcet_.macros[MacroId{variable.index}];
            return any_in_range(state_.situation, macro.steps.first, macro.steps.count);
        }
        case VariableKind::graph: {
            const Graph& graph = grafcet_.graphs[GraphId{variable.index}];
            return any_in_range(state_.situation, graph.steps.first, graph.steps.count);
        }
        case VariableKind::counter:
            break;
    }
    assert(false);  // a counter is no Boolean operand
    return false;
}

ExactSum Evaluator::sum(const Sum& terms) const {
    ExactSum sum;
    for (const SumTerm& term : terms) {
        const bool is_counter = term.counter != SumTerm::no_counter;
        sum.add(is_counter ? state_.counters[term.counter] : term.value, term.negative);
    }
    return sum;
}

bool Evaluator::comparison(const Comparison& comparison) const {
    return holds(sum(comparison.left).compare(sum(comparison.right)), comparison.relation, 0);
}

}  // namespace grafwire
