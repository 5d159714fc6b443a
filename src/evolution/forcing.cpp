// Forcing and enclosures (SBR 5).
//
// The method collects `Tf0` and `Tf1` and computes `Ts = Ts . /Tf0 + Tf1` over the whole tables.
// The same result is had without the two tables by first clearing all that is forced to 0 and only
// then setting all that is forced to 1, which touches the forced graphs alone. For that the orders
// have to be listed beforehand: they are those of the steps in `Ts` as SBR 4 left it, even where
// forcing then deactivates the step, and never those of a step that forcing activates (one pass a
// scan). IEC 60848 would go on until nothing changes; Cordier's method does not, nor do the
// netlists.

#include <algorithm>
#include <cassert>

#include "evolution/bits.h"
#include "evolution/scan_parts.h"

namespace grafwire {

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
    apply_enclosures(scan, orders, init);
}

}  // namespace grafwire
