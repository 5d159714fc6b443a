#include "netlist/styles/handshake_facts.h"

#include <algorithm>
#include <utility>

namespace grafwire {

HandshakeFacts::HandshakeFacts(const Grafcet& chart, const Equations& equations_of)
    : grafcet(chart),
      equations(equations_of),
      pool(equations.expressions),
      transitions(transitions_by_step(grafcet)),
      concurrent(grafcet) {
    for (const Assumption& assumption : grafcet.assumptions) {
        assumptions.push_back(translated(assumption.expression));
    }
}

bool HandshakeFacts::is_forced_on(const Order& order, StepId step) const {
    if (order.kind == OrderKind::initial) return grafcet.steps[step].initial;
    return std::find(order.steps.begin(), order.steps.end(), step) != order.steps.end();
}

std::optional<InputEdge> HandshakeFacts::edge_in(ExprId atom) const {
    const ExprKind kind = pool.kind(atom);
    if (kind != ExprKind::rise && kind != ExprKind::fall) return std::nullopt;
    ExprId operand = pool.operands(atom)[0];
    bool negated = kind == ExprKind::fall;
    while (pool.kind(operand) == ExprKind::negation) {
        operand = pool.operands(operand)[0];
        negated = !negated;
    }
    if (pool.kind(operand) != ExprKind::variable) return std::nullopt;
    const VariableKind of = pool.variable_of(operand).kind;
    if (of != VariableKind::input) return std::nullopt;
    return InputEdge{atom, {operand, negated}};
}

std::vector<StepId> HandshakeFacts::steps_in(ExprId id) const {
    if (pool.kind(id) == ExprKind::variable) {
        const Variable variable = pool.variable_of(id);
        if (variable.kind != VariableKind::step) return {};
        return {grafcet.steps.id_at(variable.index)};
    }
    if (pool.kind(id) == ExprKind::time_condition) {
        return steps_in(pool.time_condition_of(id).operand);
    }
    std::vector<StepId> steps;
    for (const ExprId operand : pool.operands(id)) {
        const std::vector<StepId> more = steps_in(operand);
        steps.insert(steps.end(), more.begin(), more.end());
    }
    return steps;
}

bool HandshakeFacts::waits_for(TransitionId id, StepId step) const {
    const auto is_its_time = [&](const Literal& literal) {
        if (literal.negated || pool.kind(literal.atom) != ExprKind::time_condition) return false;
        const ExprId operand = pool.time_condition_of(literal.atom).operand;
        return pool.kind(operand) == ExprKind::variable &&
               pool.variable_of(operand) ==
                   Variable{VariableKind::step, static_cast<std::uint32_t>(index_of(step))};
    };
    const auto& products = receptivities[index_of(id)];
    return std::all_of(products.begin(), products.end(), [&](const Product& product) {
        return std::any_of(product.begin(), product.end(), is_its_time);
    });
}

bool HandshakeFacts::needs_merge(StepId step) const {
    const auto with_any = [&](std::span<const StepId> steps) {
        return std::any_of(steps.begin(), steps.end(), [&](StepId other) {
            return other != step && concurrent.are_concurrent(step, other);
        });
    };
    for (const TransitionId into : transitions.into_step(step)) {
        if (with_any(grafcet.preceding(item(into)))) return true;
        if (grafcet.preceding(item(into)).empty()) return true;
    }
    for (const TransitionId out : transitions.out_of_step(step)) {
        if (with_any(grafcet.following(item(out)))) return true;
    }
    return false;
}

bool HandshakeFacts::is_written(Variable variable) const {
    const auto& stored = equations.stored;
    return std::any_of(stored.begin(), stored.end(), [&](const StoredEquation& equation) {
        return equation.target == variable && !equation.writes.empty();
    });
}

/// Whether a product can be 1 when a step is left, and 0 when it is entered again in the same
/// evolution. One of inputs alone cannot: the token would go round for ever.
bool HandshakeFacts::may_end(const Product& product) const {
    return std::any_of(product.begin(), product.end(), [&](const Literal& literal) {
        if (pool.kind(literal.atom) != ExprKind::variable) return true;
        const VariableKind kind = pool.variable_of(literal.atom).kind;
        return kind != VariableKind::input && kind != VariableKind::control;
    });
}

/// A search for ways back to the first step of `path`.
struct HandshakeFacts::Search {
    std::vector<StepId> path;
    std::size_t steps_left = 10'000;  ///< after which a way back is taken for granted
};

/// Whether a token can go on to the first step of the path within one evolution: the receptivities
/// on the way can all be true at once, and none waits for a step that has only just been entered.
bool HandshakeFacts::can_return(Search& search, StepId from, const Product& so_far) const {
    if (search.steps_left == 0) return true;
    --search.steps_left;
    std::vector<StepId>& path = search.path;
    for (const TransitionId out : transitions.out_of_step(from)) {
        if (path.size() > 1 && waits_for(out, from)) continue;
        for (const Product& product : receptivities[index_of(out)]) {
            if (path.size() == 1 && !may_end(product)) continue;
            if (!are_compatible(pool, so_far, product, assumptions)) continue;
            const auto both = product_of(so_far, product);
            for (const StepId next : grafcet.following(item(out))) {
                if (next == path.front()) return true;
                if (std::find(path.begin(), path.end(), next) != path.end()) continue;
                path.push_back(next);
                if (can_return(search, next, *both)) return true;
                path.pop_back();
            }
        }
    }
    return false;
}

/// What the X of a step is whenever the transition is enabled, where that is always the same.
std::optional<bool> HandshakeFacts::constant_for(TransitionId id, StepId read) const {
    for (const StepId step : grafcet.preceding(item(id))) {
        if (read == step) return true;
        for (const Action& action : grafcet.actions_of(grafcet.steps[step])) {
            if (action.kind != ActionKind::order) continue;
            const Order& order = grafcet.orders[action.order];
            const bool bears = order.graph == grafcet.steps[read].graph;
            if (order.kind == OrderKind::freeze || !bears) continue;
            return is_forced_on(order, read);
        }
        const bool same_graph = grafcet.steps[read].graph == item(id).graph;
        if (same_graph && concurrent.is_complete() && !concurrent.are_concurrent(read, step)) {
            return false;
        }
    }
    return std::nullopt;
}

std::vector<Product> HandshakeFacts::folded(TransitionId id,
                                            const std::vector<Product>& products) const {
    std::vector<Product> result;
    for (Product product : products) {
        bool is_zero = false;
        std::erase_if(product, [&](const Literal& literal) {
            if (pool.kind(literal.atom) != ExprKind::variable) return false;
            const Variable variable = pool.variable_of(literal.atom);
            if (variable.kind == VariableKind::var || variable.kind == VariableKind::output) {
                if (is_written(variable)) return false;
                is_zero |= !literal.negated;
                return true;
            }
            if (variable.kind != VariableKind::step) return false;
            const auto value = constant_for(id, grafcet.steps.id_at(variable.index));
            if (value) is_zero |= *value == literal.negated;
            return value.has_value();
        });
        if (!is_zero) add_product(result, std::move(product));
    }
    return result;
}

/// What a product says of the inputs, which stay what they are until the evolution ends; of an
/// edge, its level.
Product HandshakeFacts::of_inputs(const Product& product) const {
    Product result;
    for (const Literal& literal : product) {
        if (const auto edge = edge_in(literal.atom)) {
            if (!literal.negated) result.push_back(edge->level);
            continue;
        }
        if (pool.kind(literal.atom) != ExprKind::variable) continue;
        const VariableKind kind = pool.variable_of(literal.atom).kind;
        if (kind == VariableKind::input || kind == VariableKind::control) result.push_back(literal);
    }
    std::sort(result.begin(), result.end());
    return result;
}

bool HandshakeFacts::may_pass(StepId step) const {
    // What else activates or deactivates it is not looked into.
    const GraphId graph = grafcet.steps[step].graph;
    const bool is_forced = std::any_of(grafcet.orders.begin(), grafcet.orders.end(),
                                       [&](const Order& order) { return order.graph == graph; });
    const bool is_enclosed = grafcet.graphs[graph].enclosed_by != none;
    if (is_forced || is_enclosed || edge_of.count(step) != 0 || can_return_to(step)) return true;
    for (const TransitionId into : transitions.into_step(step)) {
        for (const Product& coming : receptivities[index_of(into)]) {
            for (const TransitionId out : transitions.out_of_step(step)) {
                if (waits_for(out, step)) continue;
                for (const Product& going : receptivities[index_of(out)]) {
                    if (are_compatible(pool, of_inputs(coming), of_inputs(going), assumptions)) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

bool HandshakeFacts::can_return_to(StepId step) const {
    Search search{{step}};
    return can_return(search, step, {});
}

}  // namespace grafwire
