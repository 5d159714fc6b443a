// What follows from a chart and is asked for by more than one folder: names of variables, the order
// of enclosures, the depth of forcing, the range of a sum.

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

/// An enclosing step may stand in a graph that is itself enclosed; the chain ends, since enclosures
/// form no circle (check_hierarchy.cpp).
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

/// The longest path of forcing orders that leads to a graph, by relaxing every order until none
/// deepens its graph: as many rounds as the hierarchy has levels, which are few.
std::vector<std::size_t> forcing_depths(const Grafcet& grafcet) {
    std::vector<std::size_t> depths(grafcet.graphs.size(), 0);
    // Orders form no circle, so this comes to an end.
    for (bool deepened = true; deepened;) {
        deepened = false;
        for (const Order& order : grafcet.orders) {
            if (order.kind == OrderKind::freeze) continue;
            const std::size_t above = depths[index_of(grafcet.steps[order.step].graph)];
            std::size_t& forced = depths[index_of(order.graph)];
            if (forced > above) continue;
            forced = above + 1;
            deepened = true;
        }
    }
    return depths;
}

namespace {

/// The values of a term without its sign.
IntegerRange range_of(const Grafcet& grafcet, const SumTerm& term) {
    if (term.counter == SumTerm::no_counter) return {term.value, term.value};
    const Counter& counter = grafcet.counters[CounterId{term.counter}];
    return {counter.low, counter.high};
}

}  // namespace

std::optional<IntegerRange> range_of(const Grafcet& grafcet, const Sum& sum) {
    IntegerRange reached;  // by any partial sum; the empty one is 0
    std::int64_t low = 0;
    std::int64_t high = 0;
    for (const SumTerm& term : sum) {
        IntegerRange part = range_of(grafcet, term);
        if (term.negative) {
            if (part.low == std::numeric_limits<std::int64_t>::min()) return std::nullopt;
            part = {-part.high, -part.low};
        }
        if (__builtin_add_overflow(low, part.low, &low) ||
            __builtin_add_overflow(high, part.high, &high)) {
            return std::nullopt;
        }
        reached.low = std::min(reached.low, low);
        reached.high = std::max(reached.high, high);
    }
    return reached;
}

IntegerRange value_range(const Grafcet& grafcet, const Sum& sum) {
    IntegerRange range;
    for (const SumTerm& term : sum) {
        IntegerRange part = range_of(grafcet, term);
        if (term.negative) part = {-part.high, -part.low};
        range.low += part.low;
        range.high += part.high;
    }
    return range;
}

}  // namespace grafwire
