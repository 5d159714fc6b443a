// What has no gates in the handshake style, construct by construct. Where a netlist would be right
// for some charts and wrong for others, and nothing here can tell them apart, it is refused as
// well.

#include "netlist/styles/handshake_limits.h"

#include <algorithm>

#include "grafcet/write_grafcet.h"
#include "netlist/styles/messages.h"

namespace grafwire {

namespace {

void refuse(Diagnostics& diagnostics, Location where, Localized message) {
    diagnostics.error(code::unsupported_by_style, where, std::move(message));
}

/// A transition that writes needs a place to stop at, where nothing else is going on.
void check_writes(const HandshakeFacts& facts, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < facts.grafcet.transitions.size(); ++i) {
        const TransitionId id = facts.grafcet.transitions.id_at(i);
        if (facts.writes[id].empty()) continue;
        const auto preceding = facts.grafcet.preceding(facts.item(id));
        const auto following = facts.grafcet.following(facts.item(id));
        const bool merges = std::any_of(following.begin(), following.end(),
                                        [&](StepId step) { return facts.needs_merge(step); });
        const bool stays = std::any_of(following.begin(), following.end(), [&](StepId step) {
            return std::find(preceding.begin(), preceding.end(), step) != preceding.end();
        });
        if (merges || stays || preceding.empty()) {
            refuse(diagnostics, facts.item(id).where,
                   messages::netlist_styles::write_while_active(facts.item(id).name));
        }
    }
}

void check_enclosure(const HandshakeFacts& facts, const Enclosure& enclosure,
                     Diagnostics& diagnostics) {
    const Step& step = facts.grafcet.steps[enclosure.step];
    const bool is_nested = facts.grafcet.graphs[step.graph].enclosed_by != none;
    const auto bears_on = [&](GraphId graph) {
        return std::any_of(facts.grafcet.orders.begin(), facts.grafcet.orders.end(),
                           [&](const Order& order) {
                               return order.graph == graph &&
                                      (graph == enclosure.graph || order.kind != OrderKind::freeze);
                           });
    };
    bool has_source = false;
    for (const TransitionId id : facts.grafcet.graphs[enclosure.graph].transitions) {
        has_source |= facts.grafcet.preceding(facts.item(id)).empty();
    }
    if (is_nested || has_source || bears_on(step.graph) || bears_on(enclosure.graph) ||
        facts.needs_merge(enclosure.step) || facts.edge_of.contains(enclosure.step)) {
        refuse(diagnostics, enclosure.where, messages::netlist_styles::enclosure(step.name));
    } else if (facts.can_return_to(enclosure.step)) {
        refuse(diagnostics, enclosure.where,
               messages::netlist_styles::enclosure_entered_again(step.name));
    }
}

void check_exclusive(const HandshakeFacts& facts, TransitionId a, TransitionId b,
                     Diagnostics& diagnostics) {
    for (const Product& one : facts.receptivities[index_of(a)]) {
        for (const Product& other : facts.receptivities[index_of(b)]) {
            if (!are_compatible(facts.pool, one, other, facts.assumptions)) continue;
            refuse(diagnostics, facts.item(b).where,
                   messages::netlist_styles::not_exclusive(facts.item(a).name, facts.item(b).name));
            return;
        }
    }
}

/// Both ways of a selection at once: the one that is faster would keep the other from its token.
void check_selections(const HandshakeFacts& facts, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < facts.grafcet.steps.size(); ++i) {
        const StepId step = facts.grafcet.steps.id_at(i);
        const auto out = facts.transitions.out_of_step(step);
        for (std::size_t a = 0; a < out.size(); ++a) {
            for (std::size_t b = a + 1; b < out.size(); ++b) {
                const bool is_frozen =
                    facts.equations.frozen[facts.grafcet.steps[step].graph] != no_expr;
                const bool by_time =
                    !is_frozen && facts.waits_for(out[a], step) != facts.waits_for(out[b], step);
                if (!by_time) check_exclusive(facts, out[a], out[b], diagnostics);
            }
        }
    }
}

/// Two steps that give orders at once: which of them is obeyed last would depend on the delays.
void refuse_rival_orders(const HandshakeFacts& facts, Diagnostics& diagnostics) {
    const Grafcet& grafcet = facts.grafcet;
    for (std::size_t i = 0; i < grafcet.orders.size(); ++i) {
        const Order& order = grafcet.orders[grafcet.orders.id_at(i)];
        for (std::size_t j = 0; j < i; ++j) {
            const Order& other = grafcet.orders[grafcet.orders.id_at(j)];
            if (order.kind == OrderKind::freeze || other.kind == OrderKind::freeze ||
                order.graph != other.graph) {
                continue;
            }
            const Step& a = grafcet.steps[other.step];
            const Step& b = grafcet.steps[order.step];
            if (a.graph == b.graph && other.step != order.step &&
                !facts.concurrent.are_concurrent(other.step, order.step)) {
                continue;
            }
            refuse(diagnostics, order.where,
                   messages::netlist_styles::rival_orders(a.name, b.name,
                                                          grafcet.graphs[order.graph].name));
        }
    }
}

/// A step that forces a graph, and that Init activates while another order switches it off.
void refuse_forced_orders(const Grafcet& grafcet, Diagnostics& diagnostics) {
    for (const Order& order : grafcet.orders) {
        if (order.kind == OrderKind::freeze || !grafcet.steps[order.step].initial) continue;
        for (const Order& inner : grafcet.orders) {
            if (grafcet.steps[inner.step].graph != order.graph) continue;
            refuse(diagnostics, inner.where,
                   messages::netlist_styles::forced_at_start(grafcet.steps[inner.step].name,
                                                             grafcet.steps[order.step].name));
        }
    }
}

/// A second token would come to the part of the step that waits for the edge anew.
void refuse_merged_edges(const HandshakeFacts& facts, Diagnostics& diagnostics) {
    for (const auto& [id, edge] : facts.edge_of) {
        if (!facts.needs_merge(id)) continue;
        const Step& step = facts.grafcet.steps[id];
        refuse(diagnostics, step.where,
               messages::netlist_styles::edge_after_merge(
                   write_expression(facts.grafcet, facts.pool, edge.atom), step.name));
    }
}

bool holds_edge(const Expressions& pool, ExprId id) {
    const ExprKind kind = pool.kind(id);
    if (kind == ExprKind::rise || kind == ExprKind::fall) return true;
    if (kind == ExprKind::time_condition) {
        return holds_edge(pool, pool.time_condition_of(id).operand);
    }
    const auto operands = pool.operands(id);
    return std::any_of(operands.begin(), operands.end(),
                       [&](ExprId operand) { return holds_edge(pool, operand); });
}

void refuse_edges_of_outputs(const Grafcet& grafcet, const Equations& equations,
                             Diagnostics& diagnostics) {
    for (const OutputEquation& equation : equations.outputs) {
        if (!holds_edge(equations.expressions, equation.value)) continue;
        const Output& output = grafcet.outputs[equation.output];
        refuse(diagnostics, output.where, messages::netlist_styles::edge_in_output(output.name));
    }
    for (const HeldEquation& equation : equations.held) {
        if (!holds_edge(equations.expressions, equation.value)) continue;
        const Var& var = grafcet.vars[equation.var];
        refuse(diagnostics, var.where, messages::netlist_styles::edge_in_output(var.name));
    }
}

}  // namespace

void refuse_constructs(const HandshakeFacts& facts, Diagnostics& diagnostics) {
    check_selections(facts, diagnostics);
    check_writes(facts, diagnostics);
    for (const Enclosure& enclosure : facts.grafcet.enclosures) {
        check_enclosure(facts, enclosure, diagnostics);
    }
    refuse_merged_edges(facts, diagnostics);
    refuse_rival_orders(facts, diagnostics);
    refuse_forced_orders(facts.grafcet, diagnostics);
    refuse_edges_of_outputs(facts.grafcet, facts.equations, diagnostics);
}

}  // namespace grafwire
