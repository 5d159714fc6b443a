// Whether two transitions exclude each other is undecidable in reasonable time in general (it asks
// what situations can be reached), so only two sufficient reasons are looked for: conditions whose
// conjunctions contain a factor and its negation, and steps of one sequence that hold one token.

#include "sfc/exclusion.h"

#include <algorithm>

#include "grafcet/expression.h"

namespace grafwire::sfc {

namespace {

/// What must hold for an expression to hold: the operands of its conjunctions.
void collect_conjuncts(const Expressions& pool, ExprId id, std::vector<ExprId>& conjuncts) {
    if (pool.kind(id) != ExprKind::conjunction) return conjuncts.push_back(id);
    for (const ExprId operand : pool.operands(id)) collect_conjuncts(pool, operand, conjuncts);
}

bool is_negation_of(const Expressions& pool, ExprId a, ExprId b) {
    return pool.kind(a) == ExprKind::negation && pool.operands(a).front() == b;
}

bool contradict(const Expressions& pool, ExprId a, ExprId b) {
    if (is_negation_of(pool, a, b) || is_negation_of(pool, b, a)) return true;
    if (pool.kind(a) != ExprKind::comparison || pool.kind(b) != ExprKind::comparison) return false;
    const Comparison& left = pool.comparison_of(a);
    const Comparison& right = pool.comparison_of(b);
    return left.left == right.left && left.right == right.right &&
           left.relation == complement(right.relation);
}

bool is_never(const Expressions& pool, ExprId id) {
    return pool.kind(id) == ExprKind::constant && !pool.constant_value(id);
}

}  // namespace

Exclusion::Exclusion(const Grafcet& grafcet) : grafcet_(grafcet) {
    for (const Graph& graph : grafcet.graphs) {
        std::size_t initial = 0;
        for (const StepId step : graph.steps) {
            if (grafcet.steps[step].initial) ++initial;
        }
        bool is_sequence = initial == 1 && graph.enclosed_by == none;
        for (const TransitionId id : graph.transitions) {
            const Transition& transition = grafcet.transitions[id];
            if (transition.preceding.count != 1 || transition.following.count != 1) {
                is_sequence = false;
            }
        }
        sequences_.push_back(is_sequence);
    }
    for (const Order& order : grafcet.orders) sequences_[index_of(order.graph)] = false;
    for (const Transition& transition : grafcet.transitions) {
        for (const StepId from : grafcet.preceding(transition)) {
            for (const StepId to : grafcet.following(transition)) links_.emplace(from, to);
        }
    }
}

bool Exclusion::never_meet(const Action& a, const Action& b) const {
    const bool a_leaves = a.trigger == Trigger::deactivation;
    const bool b_leaves = b.trigger == Trigger::deactivation;
    if (a.step == b.step) return a_leaves != b_leaves;
    const GraphId graph = grafcet_.steps[a.step].graph;
    if (graph != grafcet_.steps[b.step].graph || !is_sequence(graph)) return false;
    if (a_leaves == b_leaves) return true;
    return a_leaves ? !leads_to(a.step, b.step) : !leads_to(b.step, a.step);
}

bool Exclusion::never_both(const Transition& a, const Transition& b) const {
    const Expressions& pool = grafcet_.expressions;
    std::vector<ExprId> of_a;
    std::vector<ExprId> of_b;
    collect_conjuncts(pool, a.condition, of_a);
    collect_conjuncts(pool, b.condition, of_b);
    const auto never = [&](ExprId id) { return is_never(pool, id); };
    if (std::any_of(of_a.begin(), of_a.end(), never)) return true;
    if (std::any_of(of_b.begin(), of_b.end(), never)) return true;
    return std::any_of(of_a.begin(), of_a.end(), [&](ExprId left) {
        return std::any_of(of_b.begin(), of_b.end(),
                           [&](ExprId right) { return contradict(pool, left, right); });
    });
}

}  // namespace grafwire::sfc
