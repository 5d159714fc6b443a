#include "grafcet/grafcet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace grafwire {

namespace {

constexpr std::string_view control_names[control_input_count] = {"Init", "AUdur", "AUdoux"};

}  // namespace

std::string variable_name(const Grafcet& grafcet, Variable variable) {
    const std::uint32_t index = variable.index;
    switch (variable.kind) {
        case VariableKind::input:
            return grafcet.inputs.items()[index].name;
        case VariableKind::control:
            return std::string(control_names[index]);
        case VariableKind::output:
            return grafcet.outputs.items()[index].name;
        case VariableKind::var:
            return grafcet.vars.items()[index].name;
        case VariableKind::counter:
            return grafcet.counters.items()[index].name;
        case VariableKind::step:
            return fmt::format("X{}", grafcet.steps.items()[index].name);
        case VariableKind::macro:
            return fmt::format("X{}", grafcet.macros.items()[index].name);
        case VariableKind::graph:
            return fmt::format("X{}", grafcet.graphs.items()[index].name);
    }
    assert(false);
    return {};
}

std::string_view input_name(const Grafcet& grafcet, std::size_t index) {
    assert(index < grafcet.all_input_count());
    if (index < grafcet.inputs.size()) return grafcet.inputs.items()[index].name;
    return control_names[index - grafcet.inputs.size()];
}

std::vector<std::string> declared_names(const Grafcet& grafcet) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        names.emplace_back(input_name(grafcet, i));
    }
    for (const Output& output : grafcet.outputs) names.push_back(output.name);
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        names.push_back(variable_name(grafcet, {VariableKind::step, s}));
    }
    for (const Var& var : grafcet.vars) names.push_back(var.name);
    for (const Counter& counter : grafcet.counters) names.push_back(counter.name);
    return names;
}

std::vector<EnclosureId> enclosures_inwards(const Grafcet& grafcet) {
    std::vector<std::pair<std::size_t, EnclosureId>> by_depth;
    for (std::size_t e = 0; e < grafcet.enclosures.size(); ++e) {
        const EnclosureId id = grafcet.enclosures.id_at(e);
        std::size_t depth = 0;
        for (EnclosureId outer = id; outer != none; ++depth) {
            const Step& enclosing = grafcet.steps[grafcet.enclosures[outer].step];
            outer = grafcet.graphs[enclosing.graph].enclosed_by;
        }
        by_depth.emplace_back(depth, id);
    }
    std::sort(by_depth.begin(), by_depth.end());
    std::vector<EnclosureId> inwards;
    for (const auto& [depth, id] : by_depth) inwards.push_back(id);
    return inwards;
}

std::vector<std::size_t> forcing_depths(const Grafcet& grafcet) {
    std::vector<std::size_t> depths(grafcet.graphs.size(), 0);
    // Orders form no circle, so this comes to an end.
    for (bool deepened = true; deepened;) {
        deepened = false;
        for (const Order& order : grafcet.orders) {
            if (order.kind == OrderKind::freeze) continue;
            const std::size_t giver = depths[index_of(grafcet.steps[order.step].graph)];
            std::size_t& forced = depths[index_of(order.graph)];
            if (forced > giver) continue;
            forced = giver + 1;
            deepened = true;
        }
    }
    return depths;
}

}  // namespace grafwire
