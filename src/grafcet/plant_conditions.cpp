// Every node of an expression gets a variable that is true where the node is (G. S. Tseitin, "On
// the complexity of derivation in propositional calculus", 1968), so that the clauses grow with the
// expressions and not with their normal forms. Which assumptions exclude each other is what the
// solver needed to find that out, less what it turns out not to need.

#include "grafcet/plant_conditions.h"

#include <algorithm>

namespace grafwire {

PlantConditions::PlantConditions(const Grafcet& grafcet) : literals_(grafcet.expressions.size()) {
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) solver_.new_variable();
    for (const Assumption& assumption : grafcet.assumptions) {
        assumptions_.push_back(literal(grafcet, assumption.expression));
    }
}

/// A variable that is true where all the literals are.
int PlantConditions::all_of(std::span<const int> literals) {
    const int all = solver_.new_variable();
    std::vector<int> some_is_false{all};
    for (const int literal : literals) {
        solver_.add_clause(std::vector{-all, literal});
        some_is_false.push_back(-literal);
    }
    solver_.add_clause(some_is_false);
    return all;
}

/// A variable that is true where the two differ.
int PlantConditions::exclusive_or(int a, int b) {
    const int differ = solver_.new_variable();
    for (const int sign : {1, -1}) {
        solver_.add_clause(std::vector{-differ, sign * a, sign * b});
        solver_.add_clause(std::vector{differ, sign * a, -sign * b});
    }
    return differ;
}

/// The literal that stands for an expression, made with its clauses when first asked for.
int PlantConditions::literal(const Grafcet& grafcet, ExprId id) {
    int& known = literals_[static_cast<std::size_t>(id)];
    if (known != 0) return known;
    const Expressions& pool = grafcet.expressions;
    std::vector<int> operands;
    for (const ExprId operand : pool.operands(id)) operands.push_back(literal(grafcet, operand));
    int made = 0;
    switch (pool.kind(id)) {
        case ExprKind::variable: {
            const Variable variable = pool.variable_of(id);
            const bool is_control = variable.kind == VariableKind::control;
            made = input((is_control ? grafcet.inputs.size() : 0) + variable.index);
            break;
        }
        case ExprKind::constant:
            made = pool.constant_value(id) ? all_of({}) : -all_of({});
            break;
        case ExprKind::negation:
            made = -operands.front();
            break;
        case ExprKind::conjunction:
            made = all_of(operands);
            break;
        case ExprKind::disjunction:
            for (int& operand : operands) operand = -operand;
            made = -all_of(operands);
            break;
        case ExprKind::exclusive_or:
            made = operands.front();
            for (std::size_t i = 1; i < operands.size(); ++i) {
                made = exclusive_or(made, operands[i]);
            }
            break;
        default:  // the parser lets no other kind into an assumption
            made = solver_.new_variable();
            break;
    }
    return literals_[static_cast<std::size_t>(id)] = made;
}

std::vector<std::size_t> contradicting_assumptions(const Grafcet& grafcet) {
    if (grafcet.assumptions.empty()) return {};
    PlantConditions plant(grafcet);
    std::vector<int> literals = plant.assumptions();
    if (plant.solver().can_hold(literals)) return {};
    std::vector<std::size_t> needed;
    for (std::size_t i = 0; i < literals.size(); ++i) {
        if (plant.solver().is_to_blame(literals[i])) needed.push_back(i);
    }
    for (std::size_t next = needed.size(); next-- > 0;) {
        literals.clear();
        for (std::size_t i = 0; i < needed.size(); ++i) {
            if (i != next) literals.push_back(plant.assumptions()[needed[i]]);
        }
        if (!plant.solver().can_hold(literals)) {
            needed.erase(needed.begin() + static_cast<std::ptrdiff_t>(next));
        }
    }
    return needed;
}

}  // namespace grafwire
