// The receptivities of a chart, read for the handshake style: as sums of products of what a gate
// can wait for. Whatever has no gate that could is refused, each with the transition and the
// reason.

#include <algorithm>
#include <utility>

#include "grafcet/write_grafcet.h"
#include "netlist/styles/handshake_facts.h"
#include "netlist/styles/messages.h"

namespace grafwire {

namespace {

class Reader {
  public:
    Reader(HandshakeFacts& facts, Diagnostics& diagnostics)
        : facts_(facts), diagnostics_(diagnostics) {}

    void read_receptivities();

  private:
    void refuse(Location where, Localized message) {
        diagnostics_.error(code::unsupported_by_style, where, std::move(message));
    }
    void read_edges(TransitionId id);
    void check_literals(TransitionId id);
    void check_read_step(TransitionId id, const Literal& literal);
    void check_condition(TransitionId id, ExprId time);
    void check_after_time(TransitionId id, ExprId time, const Product& product);
    void check_timed_steps(TransitionId id, ExprId time);

    HandshakeFacts& facts_;
    Diagnostics& diagnostics_;
};

void Reader::read_receptivities() {
    for (std::size_t i = 0; i < facts_.grafcet.transitions.size(); ++i) {
        const TransitionId id = facts_.grafcet.transitions.id_at(i);
        auto products = products_of(facts_.pool, facts_.translated(facts_.item(id).condition));
        if (!products) {
            refuse(facts_.item(id).where,
                   messages::netlist_styles::too_many_products(facts_.item(id).name));
        }
        facts_.receptivities.push_back(
            facts_.folded(id, products.value_or(std::vector<Product>())));
        read_edges(id);
    }
    for (std::size_t i = 0; i < facts_.grafcet.transitions.size(); ++i) {
        const TransitionId id = facts_.grafcet.transitions.id_at(i);
        check_literals(id);
    }
}

/// Notes the edge on which a step is left, or says why it cannot be had.
void Reader::read_edges(TransitionId id) {
    const auto text = [&](ExprId atom) {
        return write_expression(facts_.grafcet, facts_.pool, atom);
    };
    for (const Product& product : facts_.receptivities[index_of(id)]) {
        for (const Literal& literal : product) {
            const ExprKind kind = facts_.pool.kind(literal.atom);
            if (kind != ExprKind::rise && kind != ExprKind::fall) continue;
            const auto edge = facts_.edge_in(literal.atom);
            const auto preceding = facts_.grafcet.preceding(facts_.item(id));
            if (!edge || literal.negated) {
                refuse(facts_.item(id).where,
                       messages::netlist_styles::edge_of_expression(text(literal.atom)));
            } else if (preceding.size() > 1) {
                refuse(facts_.item(id).where,
                       messages::netlist_styles::edge_after_several_steps(text(literal.atom)));
            } else if (facts_.equations.frozen[facts_.item(id).graph] != no_expr) {
                refuse(facts_.item(id).where,
                       messages::netlist_styles::edge_in_frozen_graph(text(literal.atom)));
            } else if (!preceding.empty()) {
                const auto [at, is_new] = facts_.edge_of.emplace(preceding[0], *edge);
                if (!is_new && at->second.atom != edge->atom) {
                    refuse(facts_.item(id).where, messages::netlist_styles::two_edges(
                                                      facts_.grafcet.steps[preceding[0]].name,
                                                      text(at->second.atom), text(edge->atom)));
                }
            }
        }
    }
}

/// The arrival of a second token in a step hides its X for a moment.
void Reader::check_read_step(TransitionId id, const Literal& literal) {
    if (literal.negated) return;
    const auto preceding = facts_.grafcet.preceding(facts_.item(id));
    for (const StepId step : facts_.steps_in(literal.atom)) {
        if (std::find(preceding.begin(), preceding.end(), step) != preceding.end()) continue;
        if (!facts_.needs_merge(step)) continue;
        refuse(facts_.item(id).where,
               messages::netlist_styles::reads_merging_step(facts_.grafcet.steps[step].name));
    }
}

/// That a receptivity reads nothing that cannot be read.
void Reader::check_literals(TransitionId id) {
    for (const Product& product : facts_.receptivities[index_of(id)]) {
        for (const Literal& literal : product) {
            const ExprKind kind = facts_.pool.kind(literal.atom);
            if (kind == ExprKind::time_condition) {
                if (!literal.negated) check_after_time(id, literal.atom, product);
                check_condition(id, literal.atom);
                check_timed_steps(id, literal.atom);
            }
            check_read_step(id, literal);
            const auto following = facts_.grafcet.following(facts_.item(id));
            for (const StepId step : facts_.steps_in(literal.atom)) {
                if (std::find(following.begin(), following.end(), step) == following.end())
                    continue;
                refuse(facts_.item(id).where,
                       messages::netlist_styles::reads_follower(facts_.grafcet.steps[step].name));
            }
        }
    }
}

/// A time condition is read together with what it is a condition of, which has to be a product.
void Reader::check_condition(TransitionId id, ExprId time) {
    const TimeCondition& condition = facts_.pool.time_condition_of(time);
    const auto products = products_of(facts_.pool, condition.operand);
    bool is_plain =
        condition.on_delay != 0 && condition.off_delay == 0 && products && products->size() == 1;
    if (is_plain) {
        for (const Literal& literal : (*products)[0]) {
            if (facts_.pool.kind(literal.atom) != ExprKind::variable) {
                is_plain = false;
                continue;
            }
            const Variable variable = facts_.pool.variable_of(literal.atom);
            is_plain &= variable.kind == VariableKind::input ||
                        variable.kind == VariableKind::control ||
                        (variable.kind == VariableKind::step &&
                         !facts_.edge_of.contains(facts_.grafcet.steps.id_at(variable.index)));
        }
    }
    if (!is_plain) {
        refuse(facts_.item(id).where, messages::netlist_styles::time_of_sum(
                                          write_expression(facts_.grafcet, facts_.pool, time)));
    }
}

/// `1s/a . /a` is 1 for the one repetition after a has fallen, in which the time condition is
/// still 1.
void Reader::check_after_time(TransitionId id, ExprId time, const Product& product) {
    const auto condition = products_of(facts_.pool, facts_.pool.time_condition_of(time).operand);
    if (!condition || condition->size() != 1) return;
    // While Init or AUdur is 1, nothing is cleared.
    const auto is_mode = [&](const Literal& literal) {
        if (literal.negated || facts_.pool.kind(literal.atom) != ExprKind::variable) return false;
        const Variable variable = facts_.pool.variable_of(literal.atom);
        return variable.kind == VariableKind::control &&
               variable.index != static_cast<std::uint32_t>(ControlInput::au_doux);
    };
    const bool ends = std::any_of((*condition)[0].begin(), (*condition)[0].end(), is_mode);
    if (!ends && product_of((*condition)[0], product)) return;
    refuse(facts_.item(id).where, messages::netlist_styles::true_after_time(
                                      write_expression(facts_.grafcet, facts_.pool, time)));
}

/// A step that is left and entered again in one evolution finds its timer still at 1, unless the
/// timer itself says that the step has been left (find_timer).
void Reader::check_timed_steps(TransitionId id, ExprId time) {
    const auto preceding = facts_.grafcet.preceding(facts_.item(id));
    for (const StepId step : facts_.steps_in(time)) {
        if (std::find(preceding.begin(), preceding.end(), step) == preceding.end()) continue;
        const auto ways_out = facts_.transitions.out_of_step(step);
        const bool all_wait = std::all_of(ways_out.begin(), ways_out.end(), [&](TransitionId out) {
            return facts_.waits_for(out, step);
        });
        if (all_wait || !facts_.can_return_to(step)) continue;
        refuse(facts_.item(id).where, messages::netlist_styles::timed_step_entered_again(
                                          write_expression(facts_.grafcet, facts_.pool, time),
                                          facts_.grafcet.steps[step].name));
    }
}

}  // namespace

HandshakeFacts read_for_handshake(const Grafcet& grafcet, const Equations& equations,
                                  Diagnostics& diagnostics) {
    HandshakeFacts facts(grafcet, equations);
    facts.writes = writes_of_transitions(grafcet, equations, diagnostics);
    Reader(facts, diagnostics).read_receptivities();
    return facts;
}

}  // namespace grafwire
