// The tables of the method (Cordier, section 3.2): where a listing keeps them, and what they should
// hold.
//
// What they should hold is worked out from the reference alone, not from the form that listings are
// generated from: the transitions that a scan clears say Ta and Td, the orders of the steps that
// are active after the evolution say Tf1 and Tf0 (section 5.6).
//
// The bytes, and the bit of a step that has V21.0 in Ts:
//
//     Tp VB10   Ts VB20   Tpulse VB30   Ta VB40   Td VB50   Tf1 VB60   Tf0 VB70   Tt VB80
//     V11.0     V21.0     V31.0         V41.0     V51.0     V61.0      V71.0

#include "s7check/method_tables.h"

#include <algorithm>

namespace grafwire {

namespace {

/// Whether an address is that of a bit in some bytes of V.
bool is_bit_within(const std::optional<s7::Operand>& operand, std::int32_t first,
                   std::int32_t bytes) {
    return operand && operand->area == s7::Area::variable && operand->width == s7::Width::bit &&
           operand->address >= first && operand->address < first + bytes;
}

/// Of a source transition nothing has to be active.
bool are_active(std::span<const StepId> steps, const BitTable& situation) {
    return std::all_of(steps.begin(), steps.end(),
                       [&](StepId step) { return situation.test(index_of(step)); });
}

/// Tf1 and Tf0, from the orders of the steps active after the evolution (Cordier, section 5.6).
void collect_orders(const Grafcet& grafcet, ExpectedTables& tables) {
    for (const Order& order : grafcet.orders) {
        if (order.kind == OrderKind::freeze || !tables.evolved.test(index_of(order.step))) continue;
        const Graph& graph = grafcet.graphs[order.graph];
        for (const StepId step : graph.steps) {
            const std::size_t s = index_of(step);
            tables.forced_off.set(s);
            const bool is_initial = grafcet.steps[step].initial;
            if (order.kind == OrderKind::initial && is_initial) tables.forced_on.set(s);
        }
        for (const StepId step : order.steps) tables.forced_on.set(index_of(step));
    }
}

}  // namespace

s7::Operand MethodTables::in(Distance table, s7::Operand step) {
    step.address += table;
    return step;
}

bool keeps_method_tables(const s7::Binding& binding) {
    constexpr std::int32_t first_byte_of_tt = 80;
    constexpr std::int32_t bytes_of_tt = 20;
    return std::all_of(binding.steps.begin(), binding.steps.end(),
                       [](const auto& step) {
                           return is_bit_within(step, MethodTables::first_byte_of_ts,
                                                MethodTables::bytes);
                       }) &&
           std::all_of(binding.transitions.begin(), binding.transitions.end(),
                       [&](const auto& transition) {
                           return is_bit_within(transition, first_byte_of_tt, bytes_of_tt);
                       });
}

ExpectedTables scan_with_tables(const Evolution& evolution, EvolutionState& state,
                                const EvolutionInputs& inputs, Time now) {
    const Grafcet& grafcet = evolution.grafcet();
    const BitTable steps(grafcet.steps.size());
    const BitTable transitions(grafcet.transitions.size());
    ExpectedTables tables{transitions, transitions, state.situation, steps, steps, steps,
                          steps,       steps,       steps,           {},    {},    {}};
    for (std::size_t t = 0; t < grafcet.transitions.size(); ++t) {
        const Transition& transition = grafcet.transitions[static_cast<TransitionId>(t)];
        if (are_active(grafcet.preceding(transition), state.situation)) tables.enabled.set(t);
    }
    for (const TransitionId id : evolution.cleared_by_scan(state, inputs, now)) {
        const Transition& transition = grafcet.transitions[id];
        tables.cleared.set(index_of(id));
        for (const StepId step : grafcet.following(transition)) {
            tables.activate.set(index_of(step));
        }
        for (const StepId step : grafcet.preceding(transition)) {
            tables.deactivate.set(index_of(step));
        }
    }
    for (std::size_t s = 0; s < grafcet.steps.size(); ++s) {
        const bool stays = tables.previous.test(s) && !tables.deactivate.test(s);
        tables.evolved.assign(s, stays || tables.activate.test(s));
    }
    collect_orders(grafcet, tables);
    evolution.scan(state, inputs, now);
    tables.situation = state.situation;
    tables.may_evolve = state.may_evolve;
    tables.vars = state.vars;
    tables.outputs = evolution.outputs(state, inputs);
    return tables;
}

}  // namespace grafwire
