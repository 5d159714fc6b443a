// Forcing, enclosures and AUdur (SBR 5).
//
// The orders are those of the steps that SBR 4 left active, in one pass (Cordier, section 5.6):
// every statement below that forces reads Ts before `Ts = Ts . /Tf0 + Tf1`. Enclosures come after
// it; where an order bears on an enclosed graph, a scratch bit keeps that fact across the formula.

#include "grafcet/enclosures.h"
#include "grafcet/write_grafcet.h"
#include "program/program_build.h"

namespace grafwire {

void ProgramBuild::make_orders() {
    begin(SectionKind::orders);
    note_ordered_enclosures();
    make_forcing();
    make_enclosures();
    set(
        Statement::Kind::reset,
        [&] {
            std::vector<Bit> all;
            for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
                all.push_back({BitKind::step, s});
            }
            return all;
        }(),
        control(ControlInput::au_dur), "AUdur: every step");
    table(TableOperation::pulse, "Tpulse = Ts . /Tp");
}

void ProgramBuild::note_ordered_enclosures() {
    for (std::uint32_t e = 0; e < grafcet_.enclosures.size(); ++e) {
        const GraphId graph = grafcet_.enclosures[e].graph;
        std::vector<Condition> givers;
        for (const Order& order : grafcet_.orders) {
            if (order.graph != graph) continue;
            givers.push_back(bit_condition(step_bit(BitKind::step, order.step)));
        }
        if (givers.empty()) continue;
        const Bit ordered = new_scratch();
        ordered_.emplace(e, ordered);
        assign(ordered, or_condition(std::move(givers)),
               "an order bears on " + quoted_where_needed(grafcet_.graphs[graph].name));
    }
}

/// One statement of either kind per step that gives orders, as in the method: "nous traitons les
/// cas de forçage étape par étape".
void ProgramBuild::make_forcing() {
    bool any = false;
    for (std::size_t at = 0; at < grafcet_.orders.size();) {
        const StepId giver = grafcet_.orders[at].step;
        std::vector<Bit> forced;
        for (; at < grafcet_.orders.size() && grafcet_.orders[at].step == giver; ++at) {
            const Order& order = grafcet_.orders[at];
            if (order.kind == OrderKind::freeze) continue;
            const Graph& graph = grafcet_.graphs[order.graph];
            for (const Bit bit : graph_bits(BitKind::forced_off, graph)) forced.push_back(bit);
            for (const StepId step : order.steps) {
                forced.push_back(step_bit(BitKind::forced_on, step));
            }
            if (order.kind != OrderKind::initial) continue;
            for (const Bit bit : graph_bits(BitKind::forced_on, graph)) {
                if (grafcet_.steps[StepId{bit.index}].initial) forced.push_back(bit);
            }
        }
        if (forced.empty()) continue;
        any = true;
        const Step& step = grafcet_.steps[giver];
        set(Statement::Kind::set, std::move(forced), bit_condition(step_bit(BitKind::step, giver)),
            "forcing orders of step " + quoted_where_needed(step.name), step.where);
    }
    if (any) table(TableOperation::force, "Ts = Ts . /Tf0 + Tf1");
}

void ProgramBuild::make_enclosures() {
    for (const std::uint32_t e : enclosures_inwards(grafcet_)) {
        const Enclosure& enclosure = grafcet_.enclosures[e];
        const Graph& graph = grafcet_.graphs[enclosure.graph];
        const std::string name = quoted_where_needed(graph.name);
        const Condition enclosing = bit_condition(step_bit(BitKind::step, enclosure.step));
        set(Statement::Kind::reset, graph_bits(BitKind::step, graph), not_condition(enclosing),
            name + " is enclosed by step " +
                quoted_where_needed(grafcet_.steps[enclosure.step].name),
            enclosure.where);
        std::vector<Condition> parts;
        parts.push_back(enclosing);
        parts.push_back(not_condition(bit_condition(step_bit(BitKind::previous, enclosure.step))));
        parts.push_back(not_control(ControlInput::init));
        if (const auto ordered = ordered_.find(e); ordered != ordered_.end()) {
            parts.push_back(not_condition(bit_condition(ordered->second)));
        }
        std::vector<Bit> links;
        for (const StepId step : enclosure.links) links.push_back(step_bit(BitKind::step, step));
        set(Statement::Kind::set, std::move(links), and_condition(std::move(parts)),
            "activation links of " + name, enclosure.where);
    }
}

}  // namespace grafwire
