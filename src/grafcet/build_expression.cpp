#include <cassert>

#include "grafcet/names.h"

namespace grafwire {

namespace {

Sum sum_of(const Syntax& syntax, Range<> range) {
    Sum sum;
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
        const TermSyntax& term = syntax.terms[i];
        sum.push_back({term.negative, term.counter, term.value});
    }
    return sum;
}

Variable variable_of(const ExpressionNode& node, const std::vector<std::uint32_t>& node_ids,
                     const std::vector<std::uint32_t>& graph_ids) {
    switch (node.variable) {
        case VariableKind::step:
        case VariableKind::macro:
            return {node.variable, node_ids[node.value]};
        case VariableKind::graph:
            return {node.variable, graph_ids[node.value]};
        default:
            return {node.variable, node.value};
    }
}

// Replaces the topmost operands by the n-ary node over them.
void reduce(std::vector<ExprId>& stack, const ExpressionNode& node, Expressions& expressions) {
    assert(stack.size() >= node.value);
    const std::span<const ExprId> operands(stack.data() + stack.size() - node.value, node.value);
    ExprId id = no_expr;
    switch (node.kind) {
        case ExprKind::negation:
            id = expressions.negation(operands[0]);
            break;
        case ExprKind::rise:
            id = expressions.rise(operands[0]);
            break;
        case ExprKind::fall:
            id = expressions.fall(operands[0]);
            break;
        case ExprKind::conjunction:
            id = expressions.conjunction(operands);
            break;
        case ExprKind::disjunction:
            id = expressions.disjunction(operands);
            break;
        default:
            id = expressions.exclusive_or(operands);
            break;
    }
    stack.resize(stack.size() - node.value);
    stack.push_back(id);
}

}  // namespace

ExprId build_expression(const Syntax& syntax, const ExpressionSyntax& expression,
                        const std::vector<std::uint32_t>& node_ids,
                        const std::vector<std::uint32_t>& graph_ids, Expressions& expressions) {
    std::vector<ExprId> stack;
    for (std::uint32_t i = expression.first; i < expression.first + expression.count; ++i) {
        const ExpressionNode& node = syntax.expression_nodes[i];
        switch (node.kind) {
            case ExprKind::constant:
                stack.push_back(expressions.constant(node.value != 0));
                break;
            case ExprKind::variable:
                stack.push_back(expressions.variable(variable_of(node, node_ids, graph_ids)));
                break;
            case ExprKind::time_condition: {
                const TimeSyntax& time = syntax.times[node.value];
                stack.back() =
                    expressions.time_condition({time.on_delay, stack.back(), time.off_delay});
                break;
            }
            case ExprKind::comparison: {
                const ComparisonSyntax& item = syntax.comparisons[node.value];
                stack.push_back(expressions.comparison(
                    {sum_of(syntax, item.left), item.relation, sum_of(syntax, item.right)}));
                break;
            }
            default:
                reduce(stack, node, expressions);
                break;
        }
    }
    assert(stack.size() == 1);
    return stack.back();
}

}  // namespace grafwire
