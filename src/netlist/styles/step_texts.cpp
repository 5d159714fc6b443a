#include "netlist/styles/step_texts.h"

#include "grafcet/write_grafcet.h"

namespace grafwire {

/// Recursive: expressions are nested a few hundred levels deep at most.
ExprId StepTexts::copy(ExprId id) {
    if (id == no_expr || operands_ > most_operands_) return no_expr;
    const Expressions& pool = equations_.expressions;
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool_.constant(pool.constant_value(id));
        case ExprKind::variable:
            return pool_.variable(pool.variable_of(id));
        case ExprKind::comparison:
            return pool_.comparison(pool.comparison_of(id));
        case ExprKind::time_condition: {
            TimeCondition condition = pool.time_condition_of(id);
            condition.operand = copy(condition.operand);
            return pool_.time_condition(condition);
        }
        default:
            break;
    }
    operands_ += pool.operands(id).size();
    if (operands_ > most_operands_) return no_expr;
    std::vector<ExprId> operands;
    operands.reserve(pool.operands(id).size());
    for (const ExprId operand : pool.operands(id)) operands.push_back(copy(operand));
    switch (pool.kind(id)) {
        case ExprKind::negation:
            return pool_.negation(operands.front());
        case ExprKind::rise:
            return pool_.rise(operands.front());
        case ExprKind::fall:
            return pool_.fall(operands.front());
        case ExprKind::conjunction:
            return pool_.conjunction(operands);
        case ExprKind::disjunction:
            return pool_.disjunction(operands);
        default:
            return pool_.exclusive_or(operands);
    }
}

std::string StepTexts::equation(StepId step) {
    pool_.clear();
    operands_ = 0;
    StepEquation parts = equations_.steps[step];
    for (ExprId* part : {&parts.cax, &parts.cdx, &parts.forced_off, &parts.forced_on,
                         &parts.enclosing, &parts.link}) {
        *part = copy(*part);
    }
    if (operands_ > most_operands_) return {};
    const ExprId x = combined(pool_, parts, step, equations_.options.modes);
    return "X" + grafcet_.steps[step].name + " = " + write_expression(grafcet_, pool_, x);
}

}  // namespace grafwire
