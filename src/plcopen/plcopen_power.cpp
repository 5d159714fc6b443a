// What power passes on its way to an end of a network: contacts, comparisons and the outputs of
// blocks, followed from right to left and put into a PowerGraph.

#include <algorithm>

#include "plcopen/plcopen_networks.h"

namespace grafwire::ladder {

namespace {

using Kind = PlcopenElement::Kind;

}  // namespace

/// Comparisons and gates do nothing but let power through.
bool PlcopenNetworks::is_pure(std::size_t element) const {
    const PlcopenElement& item = elements_[element];
    return item.kind == Kind::block && (comparison_named(item.text) || is_gate(item.text));
}

std::int64_t PlcopenNetworks::rank_of(std::size_t element) const {
    return elements_[element].y * std::int64_t{1'000'000} + elements_[element].x;
}

std::optional<Power> PlcopenNetworks::power(const PlcopenInlet& inlet, std::size_t element) {
    if (inlet.negated) {
        const Operand bit = worked_out(inlet, element);
        return contact(bit.variable);
    }
    if (nesting_ > deepest) {
        source_.error(elements_[element].node, "the blocks of this network are nested too deeply");
        return std::nullopt;
    }
    ++nesting_;
    Way way;
    way.rail = way.graph.new_point();
    const PowerGraph::Point end = point_of(way, inlet, element);
    --nesting_;
    if (way.failed) return std::nullopt;
    if (end == way.rail) return Power();
    auto tree = way.graph.tree(way.rail, end, most_contacts);
    if (!tree) {
        source_.error(elements_[element].node,
                      "this network is too entangled; divide it into several");
    }
    return tree;
}

PowerGraph::Point PlcopenNetworks::point_of(Way& way, const PlcopenInlet& inlet,
                                            std::size_t element) {
    if (!inlet.expression.empty()) {
        const PowerGraph::Point point = way.graph.new_point();
        const auto variable = variables_.bit(inlet.expression, inlet.node);
        if (variable) way.graph.add(way.rail, point, contact(*variable), rank_of(element));
        way.failed = way.failed || !variable;
        return point;
    }
    if (inlet.sources.empty()) {
        source_.error(elements_[element].node,
                      inlet.name.empty()
                          ? "this element is not connected to anything on its left"
                          : fmt::format("input {} of this block is not connected", inlet.name));
        way.failed = true;
        return way.rail;
    }
    if (inlet.sources.size() == 1) return point_of(way, inlet.sources.front());
    // Two contacts behind the same wires share one point, else `(a + b) . (c + d)` would be no
    // tree.
    if (const auto found = way.joints.find(inlet.sources); found != way.joints.end()) {
        return found->second;
    }
    const PowerGraph::Point joint = way.graph.new_point();
    way.joints.emplace(inlet.sources, joint);
    for (const PlcopenOutput& source : inlet.sources) {
        way.graph.add(point_of(way, source), joint, Power(), rank_of(source.element));
    }
    return joint;
}

PowerGraph::Point PlcopenNetworks::point_of(Way& way, const PlcopenOutput& output) {
    const PlcopenElement& item = elements_[output.element];
    if (item.kind == Kind::left_rail) return way.rail;
    if (const auto found = way.points.find(output); found != way.points.end()) {
        return found->second;
    }
    if (way.failed) return way.rail;
    if (way.begun.size() >= deepest || !way.begun.insert(output).second) {
        source_.error(item.node, way.begun.size() >= deepest
                                     ? "this network is too long; divide it into several"
                                     : "this element feeds itself in a circle of wires");
        way.failed = true;
        return way.rail;
    }
    const PowerGraph::Point point = make_point(way, output);
    way.begun.erase(output);
    way.points.emplace(output, point);
    return point;
}

PowerGraph::Point PlcopenNetworks::make_point(Way& way, const PlcopenOutput& output) {
    const std::size_t element = output.element;
    const PlcopenElement& item = elements_[element];
    PowerGraph::Point before = way.rail;
    std::optional<Power> part;
    switch (item.kind) {
        case Kind::contact:
        case Kind::coil:
            if (item.inlets.empty()) {
                source_.error(item.node, "this element is not connected to anything on its left");
                break;
            }
            before = point_of(way, item.inlets.front(), element);
            if (item.kind == Kind::coil) return before;  // power passes a coil
            part = contact_of(item);
            break;
        case Kind::in_variable:
            part = value_of(item);
            break;
        case Kind::block:
            part = comparison_named(item.text) ? comparison_of(element)
                   : is_gate(item.text)        ? gate_of(element)
                                               : block_output(element);
            break;
        default:
            source_.error(item.node, "no power comes out of this element");
            break;
    }
    if (!part) {
        way.failed = true;
        return way.rail;
    }
    const PowerGraph::Point after = way.graph.new_point();
    way.graph.add(before, after, std::move(*part), rank_of(element));
    return after;
}

std::optional<Power> PlcopenNetworks::contact_of(const PlcopenElement& element) const {
    const auto variable = variables_.bit(element.text, element.node);
    if (!variable) return std::nullopt;
    const std::string_view edge = element.node.attribute("edge").as_string("none");
    const bool negated = element.node.attribute("negated").as_bool();
    if (edge != "none" && negated) {
        source_.error(element.node, "a negated contact of an edge is not understood");
        return std::nullopt;
    }
    return contact(*variable, edge == "rising"    ? ContactKind::rising
                              : edge == "falling" ? ContactKind::falling
                              : negated           ? ContactKind::negated
                                                  : ContactKind::normal);
}

/// An inVariable where power is wanted.
std::optional<Power> PlcopenNetworks::value_of(const PlcopenElement& element) const {
    const auto operand =
        variables_.operand(element.text, Operand::Kind::number, true, element.node);
    if (!operand) return std::nullopt;
    const bool negated = element.node.attribute("negated").as_bool();
    if (operand->kind == Operand::Kind::variable) {
        return contact(operand->variable, negated ? ContactKind::negated : ContactKind::normal);
    }
    if ((operand->value != 0) != negated) return Power();
    source_.error(element.node, "a branch that is never 1 is not understood; leave it out");
    return std::nullopt;
}

std::optional<Power> PlcopenNetworks::comparison_of(std::size_t element) {
    const PlcopenElement& item = elements_[element];
    const auto left = operand(element, "IN1", Operand::Kind::number, false);
    const auto right = operand(element, "IN2", Operand::Kind::number, false);
    if (!left || !right) return std::nullopt;
    Power comparison;
    comparison.kind = Power::Kind::comparison;
    comparison.relation = *comparison_named(item.text);
    comparison.left = *left;
    comparison.right = *right;
    const PlcopenInlet* enable = item.inlet("EN");
    if (enable == nullptr || enable->sources.empty()) return comparison;
    auto before = power(*enable, element);
    if (!before) return std::nullopt;
    std::vector<Power> both;
    both.push_back(std::move(*before));
    both.push_back(std::move(comparison));
    return series(std::move(both));
}

std::optional<Power> PlcopenNetworks::gate_of(std::size_t element) {
    std::vector<Power> parts;
    for (const PlcopenInlet& inlet : elements_[element].inlets) {
        if (inlet.name == "EN" && inlet.sources.empty()) continue;
        auto part = power(inlet, element);
        if (!part) return std::nullopt;
        parts.push_back(std::move(*part));
    }
    if (elements_[element].text == "AND") return series(std::move(parts));
    return parallel(std::move(parts));
}

/// The output of a block that has been executed.
std::optional<Power> PlcopenNetworks::block_output(std::size_t element) {
    const PlcopenElement& item = elements_[element];
    const BlockTypeRow* row = block_named(item.text);
    if (row == nullptr) return std::nullopt;
    read_block(element);
    if (states_[element] != State::done) return std::nullopt;
    if (row->is_function) {
        const auto executed = executed_.find(element);
        if (executed != executed_.end()) return contact(executed->second);
        source_.error(item.node, "the result of this block is a number; only its ENO is power");
        return std::nullopt;
    }
    const auto instance =
        variables_.instance(item.node.attribute("instanceName").as_string(), row->type, item.node);
    if (!instance) return std::nullopt;
    return contact(*instance);
}

}  // namespace grafwire::ladder
