#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "evolution/bit_table.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"

namespace grafwire {

/// What a scan looks up, worked out once from the GRAFCET. Nothing here changes afterwards.
struct EvolutionTables {
    explicit EvolutionTables(const Grafcet& grafcet);

    /// The transitions that a step answers for: those of which it is the first preceding step.
    /// Every transition but a source is answered for by exactly one step, so that looking at the
    /// active steps alone finds each enabled transition once.
    std::span<const TransitionId> answered_by(std::size_t step) const {
        return {answered.data() + answered_begin[step],
                answered_begin[step + 1] - answered_begin[step]};
    }
    /// The orders (indices into Grafcet::orders, ascending) that bear on a graph.
    std::span<const OrderId> orders_on(GraphId graph) const {
        const std::size_t g = index_of(graph);
        return {orders_by_graph.data() + orders_begin[g], orders_begin[g + 1] - orders_begin[g]};
    }

    BitTable initial;     ///< the initial situation
    BitTable all_graphs;  ///< Tfig with nothing frozen

    std::vector<std::uint32_t> answered_begin;
    std::vector<TransitionId> answered;
    std::vector<TransitionId> sources;  ///< the transitions without preceding steps

    // Steps that have at least one such action.
    BitTable giving_orders;
    BitTable freezing;
    BitTable continuous;
    BitTable on_activation;
    BitTable on_deactivation;
    BitTable on_event;
    bool any_stored_step_action = false;

    std::vector<std::uint32_t> orders_begin;
    std::vector<OrderId> orders_by_graph;
    std::vector<EnclosureId> enclosures_inwards;

    /// Per expression node: its number among the edges or among the time conditions.
    std::vector<std::uint32_t> ordinals;

    // Where the control inputs stand among all inputs.
    std::size_t init = 0;
    std::size_t au_dur = 0;
    std::size_t au_doux = 0;
};

struct Evolution::Tables : EvolutionTables {
    using EvolutionTables::EvolutionTables;
};

}  // namespace grafwire
