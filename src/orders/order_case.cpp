// One case of a chart in every order.
//
// The reference clears all transitions that can be cleared at once (rule 4 of GRAFCET). Wiring that
// takes time clears them one after the other, in an order that nobody knows. Here every situation
// on the way is left in every way: by clearing any of the transitions that can be cleared, one or
// several; or none, where a time condition falls meanwhile. All other rules are those of the
// reference, whose scan does the work; it is only kept from clearing the others
// (EvolutionInputs::may_clear).
//
// The case is independent of order if all ends are the same and nothing that has begun is taken
// back. The latter counts even where the end is the same after all: a gate that has begun to clear
// a transition and is stopped gives a pulse of which nobody knows what it does. It is the
// persistence of D. E. Muller and W. S. Bartky, "A theory of asynchronous circuits" (1959), asked
// of the chart in place of its gates: small, and exact without any netlist. What is asked:
//
// - A product that is 1 while its steps are active does not become 0, nor lose a step, before its
//   transition is cleared. Each product of a receptivity counts for itself, as each has a gate. An
//   order that stops a graph does not count, unless the step that gives it is gone in the end: then
//   nothing waits for what it stops.
// - No transition activates a step that is active and about to be left.
// - Every order has an end, and the same. An order in which a transition that could be cleared all
//   the time never is is none.
//
// An edge is seen once by a scan, but wiring keeps it for each transition that was waiting for it
// when it came. So it lasts here until all these are cleared, for them and for no others.

#include "orders/order_case.h"

#include <algorithm>
#include <string>
#include <unordered_map>

#include "check/state_encoding.h"
#include "orders/order_graph.h"

namespace grafwire {

namespace {

constexpr std::size_t most_at_once = 10;
constexpr std::size_t most_nodes = 4000;

void add_products(const Expressions& pool, ExprId id, std::vector<ExprId>& products) {
    if (pool.kind(id) != ExprKind::disjunction) {
        products.push_back(id);
        return;
    }
    for (const ExprId operand : pool.operands(id)) add_products(pool, operand, products);
}

/// An edge outside of time conditions.
bool has_edge(const Expressions& pool, ExprId id) {
    if (pool.kind(id) == ExprKind::rise || pool.kind(id) == ExprKind::fall) return true;
    const auto operands = pool.operands(id);
    return std::any_of(operands.begin(), operands.end(),
                       [&](ExprId operand) { return has_edge(pool, operand); });
}

bool has_fallen(const BitTable& before, const BitTable& after) {
    bool any = false;
    for_each_bit(before, [&](std::size_t bit) { any = any || !after.test(bit); });
    return any;
}

class OrderSearch {
  public:
    OrderSearch(const Grafcet& grafcet, const Evolution& evolution, const OrderFacts& facts,
                const KeepGoing& keep_going, const InputValues& inputs)
        : grafcet_(grafcet),
          evolution_(evolution),
          facts_(facts),
          keep_going_(keep_going),
          inputs_(inputs) {
        outcome_.consulted.resize(inputs.size());
        outcome_.cleared.resize(grafcet.transitions.size());
    }

    OrderOutcome run(const EvolutionState& start);

  private:
    EvolutionInputs read() { return {inputs_, &outcome_.consulted}; }
    bool is_1(ExprId id, const EvolutionState& state) {
        return evolution_.value(id, state, read());
    }
    bool is_active(const EvolutionState& state, StepId step) const {
        return state.situation.test(index_of(step));
    }

    OrderNode node_of(EvolutionState state, const Transitions& by_edge);
    OrderNode first_node(const EvolutionState& start);
    OrderNode after(const OrderNode& node, const Transitions& chosen);
    std::string key_of(const OrderNode& node) const;
    bool expand(std::size_t index);
    bool take(std::size_t index, const Transitions& chosen);
    bool has_arrival(const OrderNode& node, const Transitions& chosen);
    bool has_withdrawal(const OrderNode& node, const OrderNode& next, const Transitions& chosen);
    bool is_withdrawn(const EvolutionState& before, const EvolutionState& after, TransitionId id);
    bool is_overruled(const EvolutionState& state, GraphId graph, bool by_passing_steps) const;
    void find_difference();
    void find_unrest();
    std::size_t end_from(std::size_t index) const;
    std::optional<BitTable> settled_from(OrderNode node);
    void set_race(RaceKind kind, TransitionId first, TransitionId second,
                  std::optional<BitTable> apart);
    void set_race_at(RaceKind kind, const OrderNode& node, const Transitions& chosen,
                     std::optional<BitTable> apart);

    const Grafcet& grafcet_;
    const Evolution& evolution_;
    const OrderFacts& facts_;
    const KeepGoing& keep_going_;
    const InputValues& inputs_;
    OrderOutcome outcome_;
    BitTable memory_before_;  ///< of edges, before the inputs changed
    BitTable edges_;          ///< those that have come
    std::vector<OrderNode> nodes_;
    std::unordered_map<std::string, std::size_t> known_;
};

/// What has become of a state: `by_edge` are those that still wait for their turn.
OrderNode OrderSearch::node_of(EvolutionState state, const Transitions& by_edge) {
    OrderNode node{std::move(state), {}, {}, 0, {}, {}, false};
    node.clearable = evolution_.cleared_by_scan(node.state, read(), 0);
    if (by_edge.empty()) return node;
    EvolutionState with_edges = node.state;
    for_each_bit(edges_, [&](std::size_t edge) {
        with_edges.edge_memory.assign(edge, memory_before_.test(edge));
    });
    for (const TransitionId id : evolution_.cleared_by_scan(with_edges, read(), 0)) {
        if (contains(by_edge, id)) node.by_edge.push_back(id);
    }
    if (node.by_edge.empty()) return node;
    node.state = std::move(with_edges);
    node.state.edges = edges_;
    for (const TransitionId id : node.by_edge) {
        if (!contains(node.clearable, id)) node.clearable.push_back(id);
    }
    std::sort(node.clearable.begin(), node.clearable.end());
    return node;
}

OrderNode OrderSearch::first_node(const EvolutionState& start) {
    EvolutionState scanned = start;
    evolution_.scan(scanned, read(), 0);
    edges_ = scanned.edges;
    memory_before_ = start.edge_memory;
    Transitions by_edge;
    for (const TransitionId id : evolution_.cleared_by_scan(start, read(), 0)) {
        if (facts_.reads_edge[index_of(id)] != 0) by_edge.push_back(id);
    }
    return node_of(start, by_edge);
}

OrderNode OrderSearch::after(const OrderNode& node, const Transitions& chosen) {
    std::vector<std::uint8_t> may_clear(grafcet_.transitions.size());
    for (const TransitionId id : chosen) may_clear[index_of(id)] = 1;
    EvolutionState state = node.state;
    EvolutionInputs inputs = read();
    inputs.may_clear = &may_clear;
    evolution_.scan(state, inputs, 0);
    Transitions waiting;
    for (const TransitionId id : node.by_edge) {
        if (!contains(chosen, id)) waiting.push_back(id);
    }
    return node_of(std::move(state), waiting);
}

/// All that counts in an end, and on the way what is still to come by an edge. When a delay began
/// does not count, only that it runs.
std::string OrderSearch::key_of(const OrderNode& node) const {
    std::string key;
    const EvolutionState& state = node.state;
    for (const BitTable* table : {&state.situation, &state.may_evolve, &state.stored_outputs,
                                  &state.vars, &state.edge_memory, &state.time_values}) {
        encode(key, *table);
    }
    for (const std::int64_t counter : state.counters) key += std::to_string(counter) + ' ';
    for (const Time due : state.due) key += due == never ? '-' : 'r';
    for (const TransitionId id : node.by_edge) key += std::to_string(index_of(id)) + ' ';
    return key;
}

/// Whether an order bears on the graph, or its enclosing step is inactive: what they stop need not
/// go on. `by_passing_steps`: whether only those count that are gone in the end.
bool OrderSearch::is_overruled(const EvolutionState& state, GraphId graph,
                               bool by_passing_steps) const {
    const EnclosureId enclosure = grafcet_.graphs[graph].enclosed_by;
    if (!by_passing_steps && enclosure != none &&
        !is_active(state, grafcet_.enclosures[enclosure].step)) {
        return true;
    }
    return std::any_of(grafcet_.orders.begin(), grafcet_.orders.end(), [&](const Order& order) {
        return order.graph == graph && order.kind != OrderKind::freeze &&
               is_active(state, order.step) &&
               !(by_passing_steps && is_active(outcome_.state, order.step));
    });
}

bool OrderSearch::is_withdrawn(const EvolutionState& before, const EvolutionState& after,
                               TransitionId id) {
    const Transition& transition = grafcet_.transitions[id];
    if (is_overruled(after, transition.graph, false)) {
        return is_overruled(after, transition.graph, true);
    }
    const auto steps = grafcet_.preceding(transition);
    if (!std::all_of(steps.begin(), steps.end(),
                     [&](StepId step) { return is_active(after, step); })) {
        return true;
    }
    if (!after.may_evolve.test(index_of(transition.graph))) return true;
    const std::vector<ExprId>& products = facts_.products[index_of(id)];
    return std::any_of(products.begin(), products.end(), [&](ExprId product) {
        return is_1(product, before) && !is_1(product, after);
    });
}

bool OrderSearch::has_withdrawal(const OrderNode& node, const OrderNode& next,
                                 const Transitions& chosen) {
    for (const TransitionId id : node.clearable) {
        if (contains(chosen, id) || !is_withdrawn(node.state, next.state, id)) continue;
        const TransitionId first = chosen.empty() ? TransitionId{none} : chosen.front();
        set_race(RaceKind::withdrawn, first, id, settled_from(next));
        return true;
    }
    return false;
}

bool OrderSearch::has_arrival(const OrderNode& node, const Transitions& chosen) {
    for (const TransitionId id : chosen) {
        for (const StepId step : grafcet_.following(grafcet_.transitions[id])) {
            if (!is_active(node.state, step)) continue;
            for (const TransitionId exit : node.clearable) {
                const auto left = grafcet_.preceding(grafcet_.transitions[exit]);
                if (std::find(left.begin(), left.end(), step) == left.end()) continue;
                if (exit == id && contains(node.by_edge, id)) continue;  // it is cleared once
                set_race(RaceKind::arrival, id, exit, settled_from(after(node, {id})));
                return true;
            }
        }
    }
    return false;
}

/// Goes on with what is chosen; false where a race shows.
bool OrderSearch::take(std::size_t index, const Transitions& chosen) {
    const OrderNode& node = nodes_[index];
    OrderNode next = after(node, chosen);
    const bool falls = has_fallen(node.state.time_values, next.state.time_values);
    if (chosen.empty() && !node.clearable.empty() && !falls) return true;
    if (has_withdrawal(node, next, chosen) || has_arrival(node, chosen)) return false;
    if (chosen.size() == node.clearable.size() && Evolution::is_settled(node.state, next.state)) {
        nodes_[index].is_end = true;
    }
    const auto [known, is_new] = known_.try_emplace(key_of(next), nodes_.size());
    nodes_[index].ways.push_back({chosen, known->second});
    if (is_new) {
        next.parent = index;
        next.chosen = chosen;
        nodes_.push_back(std::move(next));
    }
    return true;
}

/// Every way to leave a state; false where there is no need to go on.
bool OrderSearch::expand(std::size_t index) {
    const Transitions clearable = nodes_[index].clearable;
    if (clearable.size() > most_at_once || nodes_.size() > most_nodes) {
        outcome_.kind = OrderOutcome::Kind::too_large;
        return false;
    }
    for (std::size_t bits = 0; bits < std::size_t{1} << clearable.size(); ++bits) {
        Transitions chosen;
        for (std::size_t i = 0; i < clearable.size(); ++i) {
            if ((bits >> i & 1U) != 0) chosen.push_back(clearable[i]);
        }
        if (!take(index, chosen)) return false;
    }
    return true;
}

void OrderSearch::set_race(RaceKind kind, TransitionId first, TransitionId second,
                           std::optional<BitTable> apart) {
    outcome_.kind = OrderOutcome::Kind::dependent;
    outcome_.race = OrderRace{kind, first, second, outcome_.state.situation, std::move(apart)};
}

/// The race is between what was chosen in a state and what was not.
void OrderSearch::set_race_at(RaceKind kind, const OrderNode& node, const Transitions& chosen,
                              std::optional<BitTable> apart) {
    const TransitionId first = chosen.empty() ? TransitionId{none} : chosen.front();
    for (const TransitionId id : node.clearable) {
        if (contains(chosen, id)) continue;
        set_race(kind, first, id, std::move(apart));
        return;
    }
}

/// The situation in the end if all go on at once.
std::optional<BitTable> OrderSearch::settled_from(OrderNode node) {
    for (std::size_t scans = 0; scans < most_nodes; ++scans) {
        OrderNode next = after(node, node.clearable);
        if (Evolution::is_settled(node.state, next.state)) return std::move(next.state.situation);
        node = std::move(next);
    }
    return std::nullopt;
}

/// The end that all at once come to from a state; the number of nodes where they come to none.
std::size_t OrderSearch::end_from(std::size_t index) const {
    for (std::size_t steps = 0; steps <= nodes_.size(); ++steps) {
        if (nodes_[index].is_end) return index;
        index = nodes_[index].ways.back().to;
    }
    return nodes_.size();
}

/// Ends that are not the same. The race is at the last state on the way to the other end from which
/// all at once would still have come to the right one.
void OrderSearch::find_difference() {
    const std::size_t right = end_from(0);
    const std::string key = right == nodes_.size() ? std::string() : key_of(nodes_[right]);
    for (const OrderNode& end : nodes_) {
        if (!end.is_end || key_of(end) == key) continue;
        std::size_t later = static_cast<std::size_t>(&end - nodes_.data());
        while (later != 0) {
            const std::size_t at = nodes_[later].parent;
            const std::size_t comes_to = end_from(at);
            if (comes_to != nodes_.size() && key_of(nodes_[comes_to]) == key) {
                set_race_at(RaceKind::difference, nodes_[at], nodes_[later].chosen,
                            end.state.situation);
                return;
            }
            later = at;
        }
    }
}

/// An order without an end. The race is among the states in which one can go round, or on the way
/// to them.
void OrderSearch::find_unrest() {
    const std::vector<std::size_t> part = endless_part(nodes_);
    for (const std::size_t index : part) {
        for (const Way& way : nodes_[index].ways) {
            const bool goes_round = std::find(part.begin(), part.end(), way.to) != part.end();
            if (goes_round) set_race_at(RaceKind::unrest, nodes_[index], way.chosen, {});
            if (outcome_.race) return;
        }
    }
    if (part.empty()) return;
    for (std::size_t at = part[0]; at != 0 && !outcome_.race; at = nodes_[at].parent) {
        set_race_at(RaceKind::unrest, nodes_[nodes_[at].parent], nodes_[at].chosen, {});
    }
}

OrderOutcome OrderSearch::run(const EvolutionState& start) {
    outcome_.state = start;
    EvolutionInputs inputs = read();
    inputs.cleared = &outcome_.cleared;
    const SettleResult settled = evolution_.settle(outcome_.state, inputs, 0, keep_going_);
    if (!settled.stable || settled.broken_off) {
        outcome_.kind =
            settled.stable ? OrderOutcome::Kind::broken_off : OrderOutcome::Kind::unstable;
        return std::move(outcome_);
    }
    nodes_.push_back(first_node(start));
    known_.emplace(key_of(nodes_[0]), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (i % 64 == 63 && keep_going_ && !keep_going_()) {
            outcome_.kind = OrderOutcome::Kind::broken_off;
            return std::move(outcome_);
        }
        if (!expand(i)) return std::move(outcome_);
    }
    find_difference();
    if (!outcome_.race) find_unrest();
    return std::move(outcome_);
}

}  // namespace

OrderFacts::OrderFacts(const Grafcet& grafcet) {
    for (const Transition& transition : grafcet.transitions) {
        add_products(grafcet.expressions, transition.condition, products.emplace_back());
        reads_edge.push_back(has_edge(grafcet.expressions, transition.condition) ? 1 : 0);
    }
}

OrderOutcome OrderCases::outcome(const EvolutionState& state, const InputValues& inputs) const {
    return OrderSearch(grafcet_, evolution_, facts_, keep_going_, inputs).run(state);
}

}  // namespace grafwire
