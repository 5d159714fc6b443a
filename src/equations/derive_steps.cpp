// The equation of a step: CAX and CDX (course "Mise en œuvre du GRAFCET", sections 1.2 to 1.5), and
// what orders and enclosures add.
//
// A step is activated by the clearing of a transition into it. In the transition form the clearing
// of a transition out of it deactivates it, as rule 3 of IEC 60848 says; in the successor form it
// is the activity of all steps that follow, so that a wired step falls only once its followers are
// up. A sink transition has no follower to wait for and uses the transition form. A transition
// whose transition condition is constantly 0 contributes to neither.
//
// Freezing acts before the memory of a step, forcing and enclosing outside it, in the order of the
// reference evolution:
//
//   frozen graph     transition condition . /(OR of the X that freeze it)
//   forced graph     X . /(OR of the X that force it) + (OR of those whose order lists the step)
//   enclosed graph   X . (X of the enclosing step), + ↑(that X) for the activation links, unless an
//                    order applies to the graph
//
// (Ts = Ts./Tf0 + Tf1 in Cordier, "Méthode d'implémentation du GRAFCET", 1998.)

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

        ExprId condition = translated(equations, transition.condition);
        if (frozen != no_expr) condition = and_of(pool, {condition, not_of(pool, frozen)});
        equations.transition_conditions[id] = condition;

        factors.clear();
        for (const StepId step : grafcet.preceding(transition)) {
            factors.push_back(step_variable(pool, step));
        }
        factors.push_back(condition);
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

/// The OR of the terms of some transitions.
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

// Orders and enclosures.

namespace {

/// Per graph the OR of the X that give it an order of the chosen kinds; no_expr where none does.
template <typename Chosen>
Table<GraphId, ExprId> ordering_steps(const Grafcet& grafcet, Equations& equations, Chosen chosen) {
    Expressions& pool = equations.expressions;
    TermsByKey<GraphId> terms;
    for (const Order& order : grafcet.orders) {
        if (chosen(order.kind)) terms.add(order.graph, step_variable(pool, order.step));
    }

    Table<GraphId, ExprId> result(grafcet.graphs.size(), no_expr);
    terms.consume([&](GraphId graph, const std::vector<ExprId>& steps) {
        result[graph] = or_of(pool, steps);
    });
    return result;
}

/// Calls `use(step id)` for every step of a graph, those of its expansions included.
template <typename Use>
void for_each_step(const Grafcet& grafcet, GraphId graph, Use use) {
    for (const StepId step : grafcet.graphs[graph].steps) use(step);
}

}  // namespace

void derive_frozen(const Grafcet& grafcet, Equations& equations) {
    equations.frozen = ordering_steps(grafcet, equations,
                                      [](OrderKind kind) { return kind == OrderKind::freeze; });
}

void derive_forcing(const Grafcet& grafcet, Equations& equations) {
    Expressions& pool = equations.expressions;
    const Table<GraphId, ExprId> forcing = ordering_steps(
        grafcet, equations, [](OrderKind kind) { return kind != OrderKind::freeze; });
    const Table<GraphId, ExprId> to_initial = ordering_steps(
        grafcet, equations, [](OrderKind kind) { return kind == OrderKind::initial; });

    // Orders to the initial situation enter as one shared sum per graph.
    TermsByKey<StepId> forced_on;
    for (std::size_t i = 0; i < grafcet.graphs.size(); ++i) {
        const GraphId graph = grafcet.graphs.id_at(i);
        if (forcing[graph] == no_expr) continue;
        for_each_step(grafcet, graph, [&](StepId step) {
            equations.steps[step].forced_off = forcing[graph];
            if (to_initial[graph] != no_expr && grafcet.steps[step].initial) {
                forced_on.add(step, to_initial[graph]);
            }
        });
    }
    for (const Order& order : grafcet.orders) {
        for (const StepId step : order.steps) forced_on.add(step, step_variable(pool, order.step));
    }

    forced_on.consume([&](StepId step, const std::vector<ExprId>& orders) {
        equations.steps[step].forced_on = or_of(pool, orders);
    });
}

void derive_enclosures(const Grafcet& grafcet, Equations& equations) {
    Expressions& pool = equations.expressions;
    const Table<GraphId, ExprId> ordering =
        ordering_steps(grafcet, equations, [](OrderKind) { return true; });

    for (const Enclosure& enclosure : grafcet.enclosures) {
        const ExprId enclosing = step_variable(pool, enclosure.step);
        for_each_step(grafcet, enclosure.graph,
                      [&](StepId step) { equations.steps[step].enclosing = enclosing; });
        if (enclosure.links.empty()) continue;

        ExprId link = pool.rise(enclosing);
        if (const ExprId orders = ordering[enclosure.graph]; orders != no_expr) {
            link = and_of(pool, {link, not_of(pool, orders)});
        }
        link = and_not_control(equations, link, ControlInput::init);
        for (const StepId step : enclosure.links) equations.steps[step].link = link;
    }
}

}  // namespace grafwire
