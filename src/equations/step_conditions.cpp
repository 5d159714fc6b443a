// CAX and CDX (course "Mise en œuvre du GRAFCET", sections 1.2 to 1.5).
//
// A step is activated by the clearing of a transition into it. In the transition form the clearing
// of a transition out of it deactivates it, as rule 3 of IEC 60848 says; in the successor form it
// is the activity of all steps that follow, so that a wired step falls only once its followers are
// up. A sink transition has no follower to wait for and uses the transition form. A transition
// whose receptivity is constantly 0 contributes to neither.

#include "equations/derivation.h"

namespace grafwire {

void derive_transitions(const Grafcet& grafcet, Equations& equations) {
    Expressions& pool = equations.expressions;
    equations.transition_conditions =
        Table<TransitionId, ExprId>(grafcet.transitions.size(), no_expr);
    equations.clearing = Table<TransitionId, ExprId>(grafcet.transitions.size(), no_expr);

    std::vector<ExprId> factors;
    for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
        const TransitionId id = grafcet.transitions.id_at(i);
        const Transition& transition = grafcet.transitions[id];
        const ExprId frozen = equations.frozen[transition.graph];

        ExprId receptivity = translated(equations, transition.condition);
        if (frozen != no_expr) receptivity = and_of(pool, {receptivity, not_of(pool, frozen)});
        equations.transition_conditions[id] = receptivity;

        factors.clear();
        for (const StepId step : grafcet.preceding(transition)) {
            factors.push_back(step_variable(pool, step));
        }
        factors.push_back(receptivity);
        equations.clearing[id] = and_of(pool, factors);
    }
}

namespace {

/// Per transition, what its clearing adds to the CDX of the steps before it.
Table<TransitionId, ExprId> deactivations(const Grafcet& grafcet, Equations& equations) {
    if (equations.options.cdx == CdxForm::transition) return equations.clearing;

    Expressions& pool = equations.expressions;
    Table<TransitionId, ExprId> result = equations.clearing;
    std::vector<ExprId> factors;
    for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
        const TransitionId id = grafcet.transitions.id_at(i);
        const std::span<const StepId> following = grafcet.following(grafcet.transitions[id]);
        if (following.empty() || is_constant(pool, equations.clearing[id], false)) continue;
        factors.clear();
        for (const StepId step : following) factors.push_back(step_variable(pool, step));
        result[id] = and_of(pool, factors);
    }
    return result;
}

ExprId any_of(Expressions& pool, std::span<const TransitionId> transitions,
              const Table<TransitionId, ExprId>& terms) {
    std::vector<ExprId> operands;
    operands.reserve(transitions.size());
    for (const TransitionId id : transitions) operands.push_back(terms[id]);
    return or_of(pool, operands);
}

}  // namespace

void derive_step_conditions(const Grafcet& grafcet, Equations& equations) {
    Expressions& pool = equations.expressions;
    const StepTransitions transitions = transitions_by_step(grafcet);
    const Table<TransitionId, ExprId> deactivation = deactivations(grafcet, equations);

    equations.steps = Table<StepId, StepEquation>(grafcet.steps.size());
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const StepId id = grafcet.steps.id_at(i);
        StepEquation& step = equations.steps[id];
        step.initial = grafcet.steps[id].initial;
        step.cax = any_of(pool, transitions.into_step(id), equations.clearing);
        step.cdx = any_of(pool, transitions.out_of_step(id), deactivation);
    }
}

TableConditions table_conditions(const Equations& equations, StepId step, Expressions& pool) {
    const StepEquation& parts = equations.steps[step];
    if (!equations.options.modes) return {parts.cax, parts.cdx};
    const ExprId init = control_variable(pool, ControlInput::init);
    const ExprId not_init = not_of(pool, init);
    if (parts.initial) {
        return {or_of(pool, {parts.cax, init}), and_of(pool, {parts.cdx, not_init})};
    }
    return {and_of(pool, {parts.cax, not_init}), or_of(pool, {parts.cdx, init})};
}

}  // namespace grafwire
