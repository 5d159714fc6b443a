// What a transition waits for, as a condition.
//
// `2 -> 3 : a` is to wait for `11 -> 12 : X2.b`. That one can be cleared while X11.X2.b is 1, so
// the condition is /(X11.X2.b). Where `2 -> 3` is enabled X2 is 1 and X3 is 0, which leaves
// /(X11.b), written as its reasons not to wait: /X11 + /b. An edge lasts for a moment, and is
// waited for as if it were 1 all the time.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "orders/interlock.h"

namespace grafwire {

namespace {

class ConditionOfWaiting {
  public:
    ConditionOfWaiting(Grafcet& grafcet, TransitionId waiting)
        : grafcet_(grafcet), pool_(grafcet.expressions), known_(grafcet.steps.size(), Known::open) {
        const Transition& transition = grafcet.transitions[waiting];
        for (const StepId step : grafcet.following(transition)) known_[index_of(step)] = Known::off;
        for (const StepId step : grafcet.preceding(transition)) known_[index_of(step)] = Known::on;
    }

    /// A receptivity, or its complement where `is_plain` is false, with what is known put in and
    /// all negations moved to the variables.
    ExprId rewritten(ExprId id, bool is_plain);
    ExprId step(StepId step, bool is_plain);
    /// An AND or an OR, without what is constant or said twice.
    ExprId joined(const std::vector<ExprId>& operands, bool is_and);

  private:
    enum class Known : std::uint8_t { open, off, on };

    ExprId as_said(ExprId id, bool is_plain) { return is_plain ? id : pool_.negation(id); }

    Grafcet& grafcet_;
    Expressions& pool_;
    std::vector<Known> known_;  ///< per step, while the waiting transition is enabled
};

ExprId ConditionOfWaiting::step(StepId step, bool is_plain) {
    const Known known = known_[index_of(step)];
    if (known != Known::open) return pool_.constant((known == Known::on) == is_plain);
    return as_said(pool_.variable({VariableKind::step, static_cast<std::uint32_t>(index_of(step))}),
                   is_plain);
}

ExprId ConditionOfWaiting::joined(const std::vector<ExprId>& operands, bool is_and) {
    std::vector<ExprId> kept;
    const ExprKind same = is_and ? ExprKind::conjunction : ExprKind::disjunction;
    const auto keep = [&](ExprId id) {
        if (std::find(kept.begin(), kept.end(), id) == kept.end()) kept.push_back(id);
    };
    for (const ExprId id : operands) {
        if (pool_.kind(id) == ExprKind::constant) {
            if (pool_.constant_value(id) != is_and) return id;
        } else if (pool_.kind(id) == same) {
            for (const ExprId inner : pool_.operands(id)) keep(inner);
        } else {
            keep(id);
        }
    }
    if (kept.empty()) return pool_.constant(is_and);
    if (kept.size() == 1) return kept[0];
    return is_and ? pool_.conjunction(kept) : pool_.disjunction(kept);
}

ExprId ConditionOfWaiting::rewritten(ExprId id, bool is_plain) {
    switch (pool_.kind(id)) {
        case ExprKind::constant:
            return pool_.constant(pool_.constant_value(id) == is_plain);
        case ExprKind::variable: {
            const Variable variable = pool_.variable_of(id);
            if (variable.kind != VariableKind::step) return as_said(id, is_plain);
            return step(grafcet_.steps.id_at(variable.index), is_plain);
        }
        case ExprKind::negation:
            return rewritten(pool_.operands(id)[0], !is_plain);
        case ExprKind::conjunction:
        case ExprKind::disjunction: {
            const auto span = pool_.operands(id);
            const std::vector<ExprId> operands(span.begin(), span.end());
            std::vector<ExprId> parts;
            for (const ExprId operand : operands) parts.push_back(rewritten(operand, is_plain));
            return joined(parts, (pool_.kind(id) == ExprKind::conjunction) == is_plain);
        }
        case ExprKind::rise:
        case ExprKind::fall:
            return pool_.constant(is_plain);
        case ExprKind::exclusive_or:
        case ExprKind::time_condition:
        case ExprKind::comparison:
            break;
    }
    return as_said(id, is_plain);
}

}  // namespace

ExprId waiting_condition(Grafcet& grafcet, TransitionId waiting, TransitionId awaited) {
    ConditionOfWaiting conditions(grafcet, waiting);
    const Transition& other = grafcet.transitions[awaited];
    std::vector<ExprId> reasons;
    for (const StepId step : grafcet.preceding(other)) {
        reasons.push_back(conditions.step(step, false));
    }
    reasons.push_back(conditions.rewritten(other.condition, false));
    const ExprId condition = conditions.joined(reasons, false);
    return grafcet.expressions.kind(condition) == ExprKind::constant ? no_expr : condition;
}

}  // namespace grafwire
