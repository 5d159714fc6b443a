// Gates of any finite delay: all orders in which they can fire (the general multiple-winner model:
// J. A. Brzozowski, C.-J. H. Seger, "Asynchronous Circuits", 1995, chapter 6).
//
// Three questions, the cheapest first. Where ternary simulation knows everything, there is one rest
// and no order matters. Else the orders are gone through that stubborn sets leave, which finds
// every rest. Only if these hold a loop in which some gate starves do all orders have to be looked
// at: a reduced graph may leave out the firings that would show another loop to be fair.
//
// Whether a net can change too often takes the reduced graph alone, with the number of changes in
// its states (firing_graph.cpp): where all comes to rest, every way on which the net changes too
// often goes on to a rest at which it has, and of these none is missed.

#include "settling/any_order.h"

#include "settling/joint_firings.h"
#include "settling/late_orders.h"
#include "settling/ternary.h"

namespace grafwire {

FiringGraph::End AnyOrder::build(const CircuitState& start, bool reduced, std::size_t most_states,
                                 const WatchedNet* watched) {
    const FiringGraph::Choice choice = [&](const CircuitState& state,
                                           std::vector<Firing>& firings) {
        return reduced ? sets_.choose(state, firings) : all_firings(circuit_, state, firings);
    };
    return graph_.build(start, choice, {most_states, &keep_going_}, watched);
}

void AnyOrder::append_settled(Rests& rests, bool with_firings) const {
    for (const std::uint32_t node : graph_.rests()) {
        Rest rest;
        rest.state = graph_.state(node);
        if (with_firings) rest.firings = graph_.way_to(node);
        rests.rests.push_back(std::move(rest));
    }
}

/// The loops that need never be left; false where it takes all orders to tell.
bool AnyOrder::append_endless(Rests& rests, bool with_firings) const {
    bool is_clear = true;
    for (const FiringGraph::Loop& loop : graph_.loops()) {
        if (!loop.is_fair) {
            is_clear = false;
            continue;
        }
        Rest rest;
        rest.kind = Rest::Kind::oscillates;
        rest.state = graph_.state(loop.nodes[0]);
        rest.changing = graph_.changing_in(loop);
        if (with_firings) {
            rest.firings = graph_.way_to(loop.nodes[0]);
            rest.turn = graph_.turn_of(loop);
        }
        rests.rests.push_back(std::move(rest));
    }
    return is_clear;
}

Rests AnyOrder::settle(const CircuitState& start, bool with_firings, std::size_t most_states) {
    if (!with_firings) {
        if (auto rest = rest_of_all_delays(circuit_, start)) return std::move(*rest);
    }
    Rests rests;
    for (const bool reduced : {true, false}) {
        const FiringGraph::End end = build(start, reduced, most_states);
        rests.rests.clear();
        rests.states += graph_.state_count();
        append_settled(rests, with_firings);
        if (end != FiringGraph::End::complete) {
            rests.broken_off = end == FiringGraph::End::broken_off;
            rests.is_too_large = end == FiringGraph::End::too_large;
            return rests;
        }
        if (append_endless(rests, with_firings)) break;
    }
    return rests;
}

Pulsing AnyOrder::pulsing(const CircuitState& start, const WatchedNet& watched,
                          std::size_t most_states) {
    Pulsing pulsing;
    const FiringGraph::End end = build(start, true, most_states, &watched);
    if (end == FiringGraph::End::complete) pulsing.answer = Pulsing::Answer::never;
    if (end != FiringGraph::End::exceeded) return pulsing;
    const auto last = static_cast<std::uint32_t>(graph_.state_count() - 1);
    const auto rest = firings_to_rest(circuit_, graph_.state(last));
    if (!rest) return pulsing;
    pulsing.answer = Pulsing::Answer::shown;
    pulsing.firings = graph_.way_to(last);
    pulsing.firings.insert(pulsing.firings.end(), rest->begin(), rest->end());
    return pulsing;
}

}  // namespace grafwire
