// Forcing, enclosures and AUdur (SBR 5).
//
// The orders are those of the steps that SBR 4 left active, in one pass (Cordier, section 5.6):
// every statement below that forces reads Ts before `Ts = Ts . /Tf0 + Tf1`. Enclosures come after
// it; where an order applies to an enclosed graph, a scratch bit keeps that fact across the
// formula.

#include <map>

#include "grafcet/grafcet.h"
#include "grafcet/write_grafcet.h"
#include "program/messages.h"
#include "program/program_parts.h"

namespace grafwire {

namespace {

namespace say = messages::program;

std::vector<Bit> graph_bits(BitKind table, const Graph& graph) {
    std::vector<Bit> bits;
    for (const StepId step : graph.steps) bits.push_back(step_bit(table, step));
    return bits;
}

/// Per enclosure whose graph some order applies to: the bit that says so in this scan.
std::map<EnclosureId, Bit> note_ordered_enclosures(const Grafcet& grafcet, ScanProgram& program,
                                                   SectionWriter& section) {
    std::map<EnclosureId, Bit> noted;
    for (std::uint32_t e = 0; e < grafcet.enclosures.size(); ++e) {
        const GraphId graph = grafcet.enclosures[EnclosureId{e}].graph;
        std::vector<Condition> givers;
        for (const Order& order : grafcet.orders) {
            if (order.graph != graph) continue;
            givers.push_back(bit_condition(step_bit(BitKind::step, order.step)));
        }
        if (givers.empty()) continue;
        const Bit ordered = new_scratch(program);
        noted.emplace(EnclosureId{e}, ordered);
        section.assign(ordered, or_condition(std::move(givers)),
                       say::is_ordered(quoted_where_needed(grafcet.graphs[graph].name)));
    }
    return noted;
}

/// One statement of either kind per step that gives orders, as in the method: "nous traitons les
/// cas de forçage étape par étape".
void add_forcing(const Grafcet& grafcet, SectionWriter& section) {
    bool any = false;
    const std::vector<Order>& orders = grafcet.orders.items();
    for (std::size_t at = 0; at < orders.size();) {
        const StepId giver = orders[at].step;
        std::vector<Bit> forced;
        for (; at < orders.size() && orders[at].step == giver; ++at) {
            const Order& order = orders[at];
            if (order.kind == OrderKind::freeze) continue;
            const Graph& graph = grafcet.graphs[order.graph];
            for (const Bit bit : graph_bits(BitKind::forced_off, graph)) forced.push_back(bit);
            for (const StepId step : order.steps) {
                forced.push_back(step_bit(BitKind::forced_on, step));
            }
            if (order.kind != OrderKind::initial) continue;
            for (const Bit bit : graph_bits(BitKind::forced_on, graph)) {
                if (grafcet.steps[StepId{bit.index}].initial) forced.push_back(bit);
            }
        }
        if (forced.empty()) continue;
        any = true;
        const Step& step = grafcet.steps[giver];
        section.set(std::move(forced), bit_condition(step_bit(BitKind::step, giver)),
                    say::forcing_orders(quoted_where_needed(step.name)), step.where);
    }
    if (any) section.table(TableOperation::force, Localized::same_in_both("Ts = Ts . /Tf0 + Tf1"));
}

void add_enclosures(const Grafcet& grafcet, const ChartConditions& conditions,
                    const std::map<EnclosureId, Bit>& ordered, SectionWriter& section) {
    for (const EnclosureId e : enclosures_inwards(grafcet)) {
        const Enclosure& enclosure = grafcet.enclosures[e];
        const Graph& graph = grafcet.graphs[enclosure.graph];
        const std::string name = quoted_where_needed(graph.name);
        const Condition enclosing = bit_condition(step_bit(BitKind::step, enclosure.step));
        section.reset(
            graph_bits(BitKind::step, graph), not_condition(enclosing),
            say::is_enclosed(name, quoted_where_needed(grafcet.steps[enclosure.step].name)),
            enclosure.where);
        std::vector<Condition> parts;
        parts.push_back(enclosing);
        parts.push_back(not_condition(bit_condition(step_bit(BitKind::previous, enclosure.step))));
        parts.push_back(conditions.not_control(ControlInput::init));
        if (const auto found = ordered.find(e); found != ordered.end()) {
            parts.push_back(not_condition(bit_condition(found->second)));
        }
        std::vector<Bit> links;
        for (const StepId step : enclosure.links) links.push_back(step_bit(BitKind::step, step));
        section.set(std::move(links), and_condition(std::move(parts)), say::activation_links(name),
                    enclosure.where);
    }
}

}  // namespace

void add_orders(const Grafcet& grafcet, const ChartConditions& conditions, ScanProgram& program) {
    SectionWriter section(program, SectionKind::orders);
    const auto ordered = note_ordered_enclosures(grafcet, program, section);
    add_forcing(grafcet, section);
    add_enclosures(grafcet, conditions, ordered, section);
    std::vector<Bit> all;
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) all.push_back({BitKind::step, s});
    section.reset(std::move(all), conditions.control(ControlInput::au_dur), say::au_dur_resets());
    section.table(TableOperation::pulse, Localized::same_in_both("Tpulse = Ts . /Tp"));
}

}  // namespace grafwire
