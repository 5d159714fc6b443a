#include <fmt/format.h>

#include "grafcet/names.h"

namespace grafwire {

namespace {

// The variable of a step, macro-step or graph: `X` and its name.
bool resolve_step_variable(const Checking& checking, std::string_view name, ExpressionNode& node) {
    if (name.size() < 2 || name[0] != 'X') return false;
    if (const auto* found = checking.names.nodes.find(name.substr(1))) {
        const bool is_macro = checking.syntax.nodes[*found].kind == NodeKind::macro;
        node.variable = is_macro ? VariableKind::macro : VariableKind::step;
        node.value = *found;
        return true;
    }
    if (const auto* found = checking.names.graphs.find(name.substr(1))) {
        node.variable = VariableKind::graph;
        node.value = *found;
        return true;
    }
    return false;
}

void report_unknown(const Checking& checking, const Word& word) {
    const std::string_view name = checking.syntax.text(word);
    std::string advice = checking.suggestions.did_you_mean(name, Meant::variable);
    if (const auto* node = checking.names.nodes.find(name))
        advice = fmt::format("; the variable of {} is X{}", checking.shown_node(*node), name);
    else if (const auto* graph = checking.names.graphs.find(name))
        advice = fmt::format("; the variable of {} is X{}", checking.shown_block(*graph), name);
    checking.error(Code::unknown_name, word.where,
                   fmt::format("unknown variable {}{}", checking.shown(word), advice));
}

void report_not_plant(const Checking& checking, Location where, const std::string& what) {
    checking.error(Code::not_a_plant_condition, where,
                   fmt::format("{} in 'assume'; an assumption is about the plant, so it is made of "
                               "inputs and control inputs, without edges, times and comparisons",
                               what));
}

void resolve_variable(const Checking& checking, ExpressionNode& node, ExpressionUse use) {
    const std::string_view name = checking.syntax.text(node.word);
    if (const auto* found = checking.names.variables.find(name)) {
        node.variable = found->variable.kind;
        node.value = found->variable.index;
    } else if (!resolve_step_variable(checking, name, node)) {
        report_unknown(checking, node.word);
        return;
    }
    const bool is_of_plant =
        node.variable == VariableKind::input || node.variable == VariableKind::control;
    if (use == ExpressionUse::assumption && !is_of_plant)
        report_not_plant(checking, node.word.where,
                         fmt::format("{} is no input", checking.shown(node.word)));
    else if (node.variable == VariableKind::counter)
        checking.error(Code::not_a_boolean, node.word.where,
                       fmt::format("{} is a counter, not a condition; compare it, as in [{} > 0]",
                                   checking.shown(node.word), name));
}

void check_edge(const Checking& checking, const ExpressionNode& node, ExpressionUse use) {
    if (use == ExpressionUse::assumption)
        report_not_plant(checking, node.word.where, "edge");
    else if (use == ExpressionUse::condition && !node.inside_time)
        checking.error(Code::edge_in_condition, node.word.where,
                       "edge in the condition of a continuous action: it would last one scan only; "
                       "use a stored action ('set … on ↑…'), or a time condition around the edge");
}

void resolve_node(const Checking& checking, ExpressionNode& node, ExpressionUse use) {
    switch (node.kind) {
        case ExprKind::variable:
            resolve_variable(checking, node, use);
            break;
        case ExprKind::rise:
        case ExprKind::fall:
            check_edge(checking, node, use);
            break;
        case ExprKind::time_condition:
            if (use == ExpressionUse::assumption)
                report_not_plant(checking, node.word.where, "time condition");
            break;
        case ExprKind::comparison: {
            const ComparisonSyntax& comparison = checking.syntax.comparisons[node.value];
            if (use == ExpressionUse::assumption) {
                report_not_plant(checking, node.word.where, "comparison");
                break;
            }
            resolve_sum(checking, comparison.left);
            resolve_sum(checking, comparison.right);
            break;
        }
        default:
            break;
    }
}

}  // namespace

void resolve_expression(const Checking& checking, const ExpressionSyntax& expression,
                        ExpressionUse use) {
    for (std::uint32_t i = expression.first; i < expression.first + expression.count; ++i)
        resolve_node(checking, checking.syntax.expression_nodes[i], use);
}

void resolve_sum(const Checking& checking, Range<> sum) {
    Syntax& syntax = checking.syntax;
    for (std::uint32_t i = sum.first; i < sum.first + sum.count; ++i) {
        TermSyntax& term = syntax.terms[i];
        if (!term.is_name) continue;
        const std::string_view name = syntax.text(term.word);
        ExpressionNode other;
        const auto* found = checking.names.variables.find(name);
        if (found != nullptr && found->variable.kind == VariableKind::counter)
            term.counter = found->variable.index;
        else if (found != nullptr || resolve_step_variable(checking, name, other))
            checking.error(Code::not_a_counter, term.word.where,
                           fmt::format("{} is not a counter; only counters and numbers are "
                                       "compared and added",
                                       checking.shown(term.word)));
        else
            checking.error(Code::unknown_name, term.word.where,
                           fmt::format("unknown counter {}{}", checking.shown(term.word),
                                       checking.suggestions.did_you_mean(name, Meant::counter)));
    }
}

}  // namespace grafwire
