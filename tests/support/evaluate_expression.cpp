#include "support/evaluate_expression.h"

#include <algorithm>

namespace grafwire::testing {

std::int64_t value_of(const Sum& sum, const std::function<std::int64_t(std::uint32_t)>& counter) {
    std::int64_t total = 0;
    for (const SumTerm& term : sum) {
        const std::int64_t value =
            term.counter == SumTerm::no_counter ? term.value : counter(term.counter);
        total += term.negative ? -value : value;
    }
    return total;
}

bool value_of(const Comparison& comparison,
              const std::function<std::int64_t(std::uint32_t)>& counter) {
    const std::int64_t left = value_of(comparison.left, counter);
    const std::int64_t right = value_of(comparison.right, counter);
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

bool value_of(const Expressions& pool, ExprId id, const ExpressionValues& values) {
    const auto operands = pool.operands(id);
    const auto is_one = [&](ExprId operand) { return value_of(pool, operand, values); };
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool.constant_value(id);
        case ExprKind::variable:
            return values.variable(pool.variable_of(id));
        case ExprKind::negation:
            return !is_one(operands[0]);
        case ExprKind::conjunction:
            return std::all_of(operands.begin(), operands.end(), is_one);
        case ExprKind::disjunction:
            return std::any_of(operands.begin(), operands.end(), is_one);
        case ExprKind::exclusive_or:
            return std::count_if(operands.begin(), operands.end(), is_one) % 2 == 1;
        case ExprKind::rise:
        case ExprKind::fall:
            return values.edge(pool.ordinal(id));
        case ExprKind::time_condition:
            return values.time_condition(pool.ordinal(id));
        case ExprKind::comparison:
            return value_of(pool.comparison_of(id), values.counter);
    }
    return false;
}

}  // namespace grafwire::testing
