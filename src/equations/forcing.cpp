// Orders and enclosures. Freezing acts before the memory of a step, forcing and enclosing outside
// it, in the order of the reference evolution:
//
//   frozen graph     receptivity . /(OR of the X that freeze it)
//   forced graph     X . /(OR of the X that force it) + (OR of those whose order lists the step)
//   enclosed graph   X . (X of the enclosing step), + ↑(that X) for the activation links, unless an
//                    order bears on the graph
//
// (Ts = Ts./Tf0 + Tf1 in Cordier, "Méthode d'implémentation du GRAFCET", 1998.)

#include "equations/derivation.h"

namespace grafwire {

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
    const Table<GraphId, ExprId> bearing =
        ordering_steps(grafcet, equations, [](OrderKind) { return true; });

    for (const Enclosure& enclosure : grafcet.enclosures) {
        const ExprId enclosing = step_variable(pool, enclosure.step);
        for_each_step(grafcet, enclosure.graph,
                      [&](StepId step) { equations.steps[step].enclosing = enclosing; });
        if (enclosure.links.empty()) continue;

        ExprId link = pool.rise(enclosing);
        if (const ExprId orders = bearing[enclosure.graph]; orders != no_expr) {
            link = and_of(pool, {link, not_of(pool, orders)});
        }
        link = and_not_control(equations, link, ControlInput::init);
        for (const StepId step : enclosure.links) equations.steps[step].link = link;
    }
}

}  // namespace grafwire
