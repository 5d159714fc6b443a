// What the scans look up, worked out once per GRAFCET: transitions by the step that answers for
// them, steps by the actions they have, orders by the graph they apply to. So a scan looks at the
// active steps, and at no others.

#include "evolution/tables.h"

#include <cassert>

namespace grafwire {

namespace {

/// Groups items by key in a counting sort: `begin[k]` … `begin[k + 1]` are the places of the items
/// of key k, in their order. `key_of` gives `none` for an item to be left out.
template <typename Item, typename KeyOf>
void group_by(std::size_t key_count, std::size_t item_count, KeyOf&& key_of,
              std::vector<std::uint32_t>& begin, std::vector<Item>& grouped) {
    begin.assign(key_count + 1, 0);
    for (std::size_t i = 0; i < item_count; ++i) {
        const std::uint32_t key = key_of(i);
        if (key != none) ++begin[key + 1];
    }
    for (std::size_t k = 0; k < key_count; ++k) begin[k + 1] += begin[k];
    grouped.resize(begin[key_count]);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t i = 0; i < item_count; ++i) {
        const std::uint32_t key = key_of(i);
        if (key != none) grouped[next[key]++] = static_cast<Item>(i);
    }
}

void sort_steps(const Grafcet& grafcet, EvolutionTables& tables) {
    for (std::size_t s = 0; s < grafcet.steps.size(); ++s) {
        const Step& step = grafcet.steps[grafcet.steps.id_at(s)];
        if (step.initial) tables.initial.set(s);
        for (const Action& action : grafcet.actions_of(step)) {
            if (action.kind == ActionKind::continuous) {
                tables.continuous.set(s);
            } else if (action.kind == ActionKind::order) {
                tables.giving_orders.set(s);
                if (grafcet.orders[action.order].kind == OrderKind::freeze) tables.freezing.set(s);
            } else {
                tables.any_stored_step_action = true;
                if (action.trigger == Trigger::activation) tables.on_activation.set(s);
                if (action.trigger == Trigger::deactivation) tables.on_deactivation.set(s);
                if (action.trigger == Trigger::event) tables.on_event.set(s);
            }
        }
    }
}

/// Breadth first from the graphs that nothing encloses: an enclosure comes after the one around it.
std::vector<EnclosureId> inwards(const Grafcet& grafcet) {
    const auto around = [&](std::size_t e) {
        const StepId step = grafcet.enclosures[grafcet.enclosures.id_at(e)].step;
        return static_cast<std::uint32_t>(grafcet.graphs[grafcet.steps[step].graph].enclosed_by);
    };
    std::vector<std::uint32_t> begin;
    std::vector<EnclosureId> inside;
    group_by(grafcet.enclosures.size(), grafcet.enclosures.size(), around, begin, inside);

    std::vector<EnclosureId> order;
    for (std::size_t e = 0; e < grafcet.enclosures.size(); ++e) {
        if (around(e) == none) order.push_back(grafcet.enclosures.id_at(e));
    }
    for (std::size_t done = 0; done < order.size(); ++done) {
        const std::size_t e = index_of(order[done]);
        order.insert(order.end(), inside.begin() + begin[e], inside.begin() + begin[e + 1]);
    }
    assert(order.size() == grafcet.enclosures.size());  // a circle of enclosures is refused
    return order;
}

std::vector<std::uint32_t> number_edges_and_times(const Expressions& expressions) {
    std::vector<std::uint32_t> ordinals(expressions.size(), none);
    for (const auto* list : {&expressions.edges(), &expressions.time_conditions()}) {
        for (std::size_t i = 0; i < list->size(); ++i) {
            ordinals[static_cast<std::size_t>((*list)[i])] = static_cast<std::uint32_t>(i);
        }
    }
    return ordinals;
}

}  // namespace

EvolutionTables::EvolutionTables(const Grafcet& grafcet)
    : initial(grafcet.steps.size()),
      all_graphs(grafcet.graphs.size()),
      giving_orders(grafcet.steps.size()),
      freezing(grafcet.steps.size()),
      continuous(grafcet.steps.size()),
      on_activation(grafcet.steps.size()),
      on_deactivation(grafcet.steps.size()),
      on_event(grafcet.steps.size()),
      enclosures_inwards(inwards(grafcet)),
      ordinals(number_edges_and_times(grafcet.expressions)) {
    for (std::size_t g = 0; g < grafcet.graphs.size(); ++g) all_graphs.set(g);
    sort_steps(grafcet, *this);

    const auto first_preceding = [&](std::size_t t) {
        const auto steps = grafcet.preceding(grafcet.transitions[grafcet.transitions.id_at(t)]);
        return static_cast<std::uint32_t>(steps.empty() ? StepId(none) : steps.front());
    };
    group_by(grafcet.steps.size(), grafcet.transitions.size(), first_preceding, answered_begin,
             answered);
    for (std::size_t t = 0; t < grafcet.transitions.size(); ++t) {
        if (first_preceding(t) == none) sources.push_back(grafcet.transitions.id_at(t));
    }
    const auto bears_on = [&](std::size_t o) {
        return static_cast<std::uint32_t>(index_of(grafcet.orders[grafcet.orders.id_at(o)].graph));
    };
    group_by(grafcet.graphs.size(), grafcet.orders.size(), bears_on, orders_begin, orders_by_graph);

    init = grafcet.inputs.size() + static_cast<std::size_t>(ControlInput::init);
    au_dur = grafcet.inputs.size() + static_cast<std::size_t>(ControlInput::au_dur);
    au_doux = grafcet.inputs.size() + static_cast<std::size_t>(ControlInput::au_doux);
}

}  // namespace grafwire
