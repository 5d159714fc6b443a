// The functions that the equations give, as truth tables over named variables: what is read off the
// gates (net_reader.cpp) is compared with these, variable by variable, by name.
//
// In a clocked netlist an edge is not a variable of its own but a function of its operand now and
// one clock cycle before: `↑a` is `a . /a[-1]`. Everything else that is no operator (a time
// condition, a comparison, an edge elsewhere) is one variable, however much stands in it, under the
// name that the equations write for it. That the gates may spell it otherwise is net_reader.cpp's
// concern.

#include "explain/equation_functions.h"

#include <fmt/format.h>

#include "grafcet/write_grafcet.h"

namespace grafwire {

std::string operand_name(const Grafcet& grafcet, Variable variable) {
    Expressions pool;
    const ExprId id = pool.variable(variable);
    return write_expression(grafcet, pool, id);
}

// A name that comes from an equation has no net yet; the same name met at the gates gives it one.
std::size_t FunctionVariables::add(const FunctionVariable& variable) {
    if (const auto known = find(variable.name)) {
        FunctionVariable& kept = list_[*known];
        if (kept.net == no_net) kept = variable;
        return *known;
    }
    list_.push_back(variable);
    return list_.size() - 1;
}

std::optional<std::size_t> FunctionVariables::find(std::string_view name) const {
    for (std::size_t i = 0; i < list_.size(); ++i) {
        if (list_[i].name == name) return i;
    }
    return std::nullopt;
}

std::string name_before(std::string_view name) {
    return fmt::format("{}[-1]", name);
}

namespace {

bool is_operator(ExprKind kind) {
    return kind == ExprKind::negation || kind == ExprKind::conjunction ||
           kind == ExprKind::disjunction || kind == ExprKind::exclusive_or;
}

bool is_edge(ExprKind kind) {
    return kind == ExprKind::rise || kind == ExprKind::fall;
}

/// Walks an expression; `variable(name, is_made)` gives the table of a variable.
template <typename VariableTable>
TruthTable evaluate(const Grafcet& grafcet, const Expressions& pool, ExprId id, bool as_clocked,
                    std::size_t variables, const VariableTable& variable) {
    const ExprKind kind = pool.kind(id);
    const auto operand = [&](ExprId part) {
        return evaluate(grafcet, pool, part, as_clocked, variables, variable);
    };
    if (kind == ExprKind::constant) return {variables, pool.constant_value(id)};
    if (is_edge(kind) && as_clocked) {
        const ExprId inside = pool.operands(id)[0];
        const TruthTable now = operand(inside);
        const TruthTable before =
            variable(name_before(write_expression(grafcet, pool, inside)), true);
        return kind == ExprKind::rise ? now & ~before : ~now & before;
    }
    if (!is_operator(kind)) {
        const bool is_made = kind != ExprKind::variable ||
                             pool.variable_of(id).kind == VariableKind::var ||
                             pool.variable_of(id).kind == VariableKind::counter;
        return variable(write_expression(grafcet, pool, id), is_made);
    }
    TruthTable table = operand(pool.operands(id)[0]);
    for (std::size_t i = 1; i < pool.operands(id).size(); ++i) {
        const TruthTable next = operand(pool.operands(id)[i]);
        if (kind == ExprKind::conjunction) table &= next;
        if (kind == ExprKind::disjunction) table |= next;
        if (kind == ExprKind::exclusive_or) table ^= next;
    }
    return kind == ExprKind::negation ? ~table : table;
}

}  // namespace

void add_variables(const Grafcet& grafcet, const Expressions& pool, ExprId id, bool as_clocked,
                   FunctionVariables& variables) {
    evaluate(grafcet, pool, id, as_clocked, 0, [&](const std::string& name, bool is_made) {
        variables.add({name, no_net, false, false, is_made});
        return TruthTable(0, false);
    });
}

std::optional<TruthTable> function_of(const Grafcet& grafcet, const Expressions& pool, ExprId id,
                                      bool as_clocked, const FunctionVariables& variables) {
    if (variables.size() > TruthTable::most_variables) return std::nullopt;
    return evaluate(
        grafcet, pool, id, as_clocked, variables.size(), [&](const std::string& name, bool) {
            return TruthTable::variable(variables.size(), variables.find(name).value_or(0));
        });
}

std::string sum_text(const std::vector<Product>& sum, const FunctionVariables& variables) {
    if (sum.empty()) return "0";
    if (sum[0].plain == 0 && sum[0].negated == 0) return "1";
    std::string text;
    for (const Product& product : sum) {
        if (!text.empty()) text += " + ";
        bool is_first = true;
        for (std::size_t v = 0; v < variables.size(); ++v) {
            const bool is_negated = (product.negated >> v & 1U) != 0;
            if (!is_negated && (product.plain >> v & 1U) == 0) continue;
            if (!is_first) text += '.';
            is_first = false;
            if (is_negated) text += '/';
            text += variables[v].name;
        }
    }
    return text;
}

}  // namespace grafwire
