// What a scan does once the transitions have been cleared (SBR 4): forcing and enclosures, stored
// actions, time conditions. The order is that of the method, and part of its meaning: an order of a
// step is given by the situation that the transitions have left, a stored action sees the steps as
// forcing has left them, and a time condition the variables as the stored actions have written
// them.
//
// Each part below opens with its own rule.

#include "evolution/subroutines.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

#include "evolution/bit_table.h"

namespace grafwire {

// Forcing and enclosures (SBR 5).
//
// The method collects `Tf0` and `Tf1` and computes `Ts = Ts . /Tf0 + Tf1` over the whole tables.
// The same result is had without the two tables by first clearing all that is forced to 0 and only
// then setting all that is forced to 1, which touches the forced graphs alone. For that the orders
// have to be listed beforehand: they are those of the steps in `Ts` as SBR 4 left it, even where
// forcing then deactivates the step, and never those of a step that forcing activates (one pass a
// scan). IEC 60848 would go on until nothing changes; Cordier's method does not, nor do the
// netlists.

namespace {

using OrderList = SmallList<OrderId, 32>;

void list_orders(const ScanContext& scan, OrderList& orders) {
    for_each_common_bit(scan.state.situation, scan.tables.giving_orders, [&](std::size_t s) {
        const Step& step = scan.grafcet.steps[scan.grafcet.steps.id_at(s)];
        for (const Action& action : scan.grafcet.actions_of(step)) {
            if (action.kind == ActionKind::order) orders.push_back(action.order);
        }
    });
}

void force_to_0(const ScanContext& scan, const OrderList& orders) {
    SmallList<GraphId, 32> forced;
    for (const OrderId o : orders) {
        const Order& order = scan.grafcet.orders[o];
        if (order.kind != OrderKind::freeze) forced.push_back(order.graph);
    }
    std::sort(forced.begin(), forced.end());
    GraphId* const end = std::unique(forced.begin(), forced.end());
    for (const GraphId* graph = forced.begin(); graph != end; ++graph) {
        const Graph& g = scan.grafcet.graphs[*graph];
        clear_range(scan.state.situation, g.steps.first, g.steps.count);
    }
}

void force_to_1(const ScanContext& scan, const OrderList& orders) {
    for (const OrderId o : orders) {
        const Order& order = scan.grafcet.orders[o];
        if (order.kind == OrderKind::initial) {
            const Graph& graph = scan.grafcet.graphs[order.graph];
            add_range(scan.state.situation, scan.tables.initial, graph.steps.first,
                      graph.steps.count);
        } else if (order.kind == OrderKind::listed) {
            for (const StepId step : order.steps) scan.state.situation.set(index_of(step));
        }
    }
}

/// `orders` is in ascending order.
bool some_order_bears_on(const ScanContext& scan, const OrderList& orders, GraphId graph) {
    if (orders.empty()) return false;
    const auto on_graph = scan.tables.orders_on(graph);
    return std::any_of(on_graph.begin(), on_graph.end(), [&](OrderId order) {
        return std::binary_search(orders.begin(), orders.end(), order);
    });
}

void apply_enclosures(const ScanContext& scan, const OrderList& orders, bool init) {
    BitTable& situation = scan.state.situation;
    for (const EnclosureId e : scan.tables.enclosures_inwards) {
        const Enclosure& enclosure = scan.grafcet.enclosures[e];
        const std::size_t step = index_of(enclosure.step);
        if (!situation.test(step)) {
            const Graph& graph = scan.grafcet.graphs[enclosure.graph];
            clear_range(situation, graph.steps.first, graph.steps.count);
        } else if (!init && !scan.state.previous.test(step) &&
                   !some_order_bears_on(scan, orders, enclosure.graph)) {
            for (const StepId link : enclosure.links) situation.set(index_of(link));
            if (scan.record != nullptr) scan.record->opened.push_back(e);
        }
    }
}

}  // namespace

void apply_forcing(const ScanContext& scan, bool init) {
    OrderList orders;
    if (!scan.grafcet.orders.empty()) list_orders(scan, orders);
    assert(std::is_sorted(orders.begin(), orders.end()));  // orders stand in the order of steps
    if (!orders.empty()) {
        force_to_0(scan, orders);
        force_to_1(scan, orders);
    }
    if (scan.record != nullptr) {
        scan.record->orders.assign(orders.begin(), orders.end());
        scan.record->after_forcing = scan.state.situation;
    }
    apply_enclosures(scan, orders, init);
}

// Stored actions (the end of SBR 5).
//
// All that is to be written is read first, with variables as they were, and put in a list in the
// order of writing: on deactivation, on clearing, on activation, on another event, each kind in
// table order. Then the list is written from front to back, so that the last write to a variable
// wins. Two `c := c + 1` in one scan therefore count one.

namespace {

struct PendingWrite {
    Variable target;
    std::int64_t value = 0;
};
using PendingWrites = SmallList<PendingWrite, 32>;

std::int64_t value_of(const ScanContext& scan, const Write& write) {
    if (write.operation == WriteOperation::set) return 1;
    if (write.operation == WriteOperation::reset) return 0;
    if (write.target.kind == VariableKind::counter) {
        const Counter& counter = scan.grafcet.counters[CounterId{write.target.index}];
        return scan.read.sum(scan.grafcet.sums[write.sum]).held_within(counter.low, counter.high);
    }
    return scan.read.value(write.value) ? 1 : 0;
}

/// Puts a write in the list. `actions`: the list of the GRAFCET that holds its action.
template <typename Actions>
void list_write(const ScanContext& scan, const Actions& actions,
                const typename Actions::value_type& action, PendingWrites& writes) {
    const std::int64_t value = value_of(scan, action.write);
    writes.push_back({action.write.target, value});
    if (scan.record == nullptr) return;
    constexpr bool on_clearing = std::is_same_v<typename Actions::value_type, ClearingAction>;
    scan.record->writes.push_back(
        {on_clearing, static_cast<std::size_t>(&action - actions.data()), value});
}

void list_actions_of(const ScanContext& scan, std::size_t s, Trigger trigger,
                     PendingWrites& writes) {
    const Step& step = scan.grafcet.steps[scan.grafcet.steps.id_at(s)];
    for (const Action& action : scan.grafcet.actions_of(step)) {
        if (action.kind != ActionKind::stored || action.trigger != trigger) continue;
        if (trigger == Trigger::event && !scan.read.value(action.expression)) continue;
        list_write(scan, scan.grafcet.actions, action, writes);
    }
}

/// The actions of the steps in `candidates` that are in `now` and not in `before`.
void list_changed(const ScanContext& scan, const BitTable& candidates, const BitTable& now,
                  const BitTable& before, Trigger trigger, PendingWrites& writes) {
    for (std::size_t w = 0; w < candidates.words().size(); ++w) {
        const std::uint64_t changed = candidates.words()[w] & now.words()[w] & ~before.words()[w];
        for_each_bit_of_word(
            changed, w, [&](std::size_t step) { list_actions_of(scan, step, trigger, writes); });
    }
}

void list_clearing(const ScanContext& scan, const ClearedList& cleared, PendingWrites& writes) {
    ClearedList with_actions;
    for (const TransitionId id : cleared) {
        if (scan.grafcet.transitions[id].clearing.count != 0) with_actions.push_back(id);
    }
    std::sort(with_actions.begin(), with_actions.end());
    for (const TransitionId id : with_actions) {
        for (const ClearingAction& action :
             scan.grafcet.clearing_actions_of(scan.grafcet.transitions[id])) {
            list_write(scan, scan.grafcet.clearing_actions, action, writes);
        }
    }
}

void write_all(const PendingWrites& writes, EvolutionState& state) {
    for (const PendingWrite& write : writes) {
        switch (write.target.kind) {
            case VariableKind::output:
                state.stored_outputs.assign(write.target.index, write.value != 0);
                break;
            case VariableKind::var:
                state.vars.assign(write.target.index, write.value != 0);
                break;
            case VariableKind::counter:
                state.counters[write.target.index] = write.value;
                break;
            default:
                assert(false);  // nothing else can be written
        }
    }
}

}  // namespace

void run_stored_actions(const ScanContext& scan, const ClearedList& cleared) {
    const EvolutionTables& tables = scan.tables;
    const BitTable& after = scan.state.situation;
    const BitTable& before = scan.state.previous;
    PendingWrites writes;
    if (tables.any_stored_step_action) {
        list_changed(scan, tables.on_deactivation, before, after, Trigger::deactivation, writes);
    }
    list_clearing(scan, cleared, writes);
    if (tables.any_stored_step_action) {
        list_changed(scan, tables.on_activation, after, before, Trigger::activation, writes);
        for_each_common_bit(after, tables.on_event, [&](std::size_t step) {
            list_actions_of(scan, step, Trigger::event, writes);
        });
    }
    write_all(writes, scan.state);
}

// Time conditions (SBR 6).
//
// `t1/e/t2` has a value and at most one running delay, kept as the time `due` at which the value
// changes if e stays as it is. While e differs from the value a delay runs (t1 upwards, t2
// downwards); when e is back at the value the delay is dropped, and the next one starts from 0:
//
//   e = value              no delay
//   e ≠ value, none runs   due = now + (e ? t1 : t2)
//   e ≠ value, due <= now  value = e, no delay
//
// A delay of 0 is due at once. Conditions are taken from the inside outwards, so that an outer one
// reads the inner ones as they are after this scan. Scan by scan a delay counts from the scan that
// first saw e, and ends in the first scan that is not before `due` and still sees e. Until stable,
// a delay that ends exactly at an instant takes effect at its beginning, before SBR 1, so that the
// receptivities of the first repetition see it beside the inputs that changed with it; again only
// if e still asks for it, under the new inputs. So both ways of running agree on a delay whose
// operand changes at the very time at which it would have ended.

void update_time_conditions(const ScanContext& scan) {
    const Expressions& expressions = scan.grafcet.expressions;
    EvolutionState& state = scan.state;
    for (std::size_t i = 0; i < expressions.time_conditions().size(); ++i) {
        const TimeCondition& condition =
            expressions.time_condition_of(expressions.time_conditions()[i]);
        const bool operand = scan.read.value(condition.operand);
        Time& due = state.due[i];
        if (operand == state.time_values.test(i)) {
            due = never;
            continue;
        }
        if (due == never) {
            due = add_times(scan.now, operand ? condition.on_delay : condition.off_delay);
        }
        if (due <= scan.now) {
            state.time_values.assign(i, operand);
            due = never;
        }
    }
}

}  // namespace grafwire
