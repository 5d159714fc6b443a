// What reaches the inlets of an element.
//
// Power is followed from the inlet to the left, through contacts, comparisons and the outputs of
// blocks, and put into a PowerGraph, which makes a tree of contacts of it. Two inlets on the same
// wires share a point of that graph, so that the tree is as small as the drawing. An inlet of a
// block that takes a value reads a variable, a literal or the result of a function; anything else
// is worked out into a bit by a rung of its own before.

#include <algorithm>

#include "plcopen/ladder_networks.h"
#include "plcopen/messages.h"

namespace grafwire::plcopen {

namespace {

using Kind = Element::Kind;

}  // namespace

/// Comparisons and gates do nothing but let power through.
bool LadderNetworks::is_pure(std::size_t element) const {
    const Element& item = elements_[element];
    return item.kind == Kind::block && (comparison_named(item.text) || is_gate(item.text));
}

PowerGraph::Rank LadderNetworks::rank_of(std::size_t element) const {
    return {elements_[element].y, elements_[element].x};
}

std::optional<ladder::Power> LadderNetworks::power(const Inlet& inlet, std::size_t element) {
    if (inlet.negated) {
        const ladder::Operand bit = worked_out(inlet, element);
        return contact(bit.variable);
    }
    if (nesting_ > deepest) {
        source_.error(elements_[element].node, messages::plcopen::nested_too_deeply());
        return std::nullopt;
    }
    ++nesting_;
    Wiring wiring;
    wiring.rail = wiring.graph.new_point();
    const PowerGraph::Point end = point_of(wiring, inlet, element);
    --nesting_;
    if (wiring.failed) return std::nullopt;
    if (end == wiring.rail) return ladder::Power();
    auto tree = wiring.graph.tree(wiring.rail, end, most_contacts);
    if (!tree) {
        source_.error(elements_[element].node, messages::plcopen::too_entangled());
    }
    return tree;
}

PowerGraph::Point LadderNetworks::point_of(Wiring& wiring, const Inlet& inlet,
                                           std::size_t element) {
    if (!inlet.expression.empty()) {
        const PowerGraph::Point point = wiring.graph.new_point();
        const auto variable = variables_.bit(inlet.expression, inlet.node);
        if (variable) wiring.graph.add(wiring.rail, point, contact(*variable), rank_of(element));
        wiring.failed = wiring.failed || !variable;
        return point;
    }
    if (inlet.sources.empty()) {
        source_.error(elements_[element].node,
                      inlet.name.empty() ? messages::plcopen::element_not_connected()
                                         : messages::plcopen::input_not_connected(inlet.name));
        wiring.failed = true;
        return wiring.rail;
    }
    if (inlet.sources.size() == 1) return point_of(wiring, inlet.sources.front());
    // Two contacts behind the same wires share one point, else `(a + b) . (c + d)` would be no
    // tree.
    if (const auto found = wiring.joints.find(inlet.sources); found != wiring.joints.end()) {
        return found->second;
    }
    const PowerGraph::Point joint = wiring.graph.new_point();
    wiring.joints.emplace(inlet.sources, joint);
    for (const Output& source : inlet.sources) {
        wiring.graph.add(point_of(wiring, source), joint, ladder::Power(), rank_of(source.element));
    }
    return joint;
}

PowerGraph::Point LadderNetworks::point_of(Wiring& wiring, const Output& output) {
    const Element& item = elements_[output.element];
    if (item.kind == Kind::left_rail) return wiring.rail;
    if (const auto found = wiring.points.find(output); found != wiring.points.end()) {
        return found->second;
    }
    if (wiring.failed) return wiring.rail;
    if (wiring.begun.size() >= deepest || !wiring.begun.insert(output).second) {
        source_.error(item.node, wiring.begun.size() >= deepest
                                     ? messages::plcopen::too_long()
                                     : messages::plcopen::element_in_a_circle());
        wiring.failed = true;
        return wiring.rail;
    }
    const PowerGraph::Point point = make_point(wiring, output);
    wiring.begun.erase(output);
    wiring.points.emplace(output, point);
    return point;
}

PowerGraph::Point LadderNetworks::make_point(Wiring& wiring, const Output& output) {
    const std::size_t element = output.element;
    const Element& item = elements_[element];
    PowerGraph::Point before = wiring.rail;
    std::optional<ladder::Power> part;
    switch (item.kind) {
        case Kind::contact:
        case Kind::coil:
            if (item.inlets.empty()) {
                source_.error(item.node, messages::plcopen::element_not_connected());
                break;
            }
            before = point_of(wiring, item.inlets.front(), element);
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
            source_.error(item.node, messages::plcopen::no_power());
            break;
    }
    if (!part) {
        wiring.failed = true;
        return wiring.rail;
    }
    const PowerGraph::Point after = wiring.graph.new_point();
    wiring.graph.add(before, after, std::move(*part), rank_of(element));
    return after;
}

std::optional<ladder::Power> LadderNetworks::contact_of(const Element& element) const {
    const auto variable = variables_.bit(element.text, element.node);
    if (!variable) return std::nullopt;
    const std::string_view edge = element.node.attribute("edge").as_string("none");
    const bool negated = element.node.attribute("negated").as_bool();
    if (edge != "none" && negated) {
        source_.error(element.node, messages::plcopen::negated_edge());
        return std::nullopt;
    }
    return contact(*variable, edge == "rising"    ? ladder::ContactKind::rising
                              : edge == "falling" ? ladder::ContactKind::falling
                              : negated           ? ladder::ContactKind::negated
                                                  : ladder::ContactKind::normal);
}

/// An inVariable where power is wanted.
std::optional<ladder::Power> LadderNetworks::value_of(const Element& element) const {
    const auto operand =
        variables_.operand(element.text, ladder::Operand::Kind::number, true, element.node);
    if (!operand) return std::nullopt;
    const bool negated = element.node.attribute("negated").as_bool();
    if (operand->kind == ladder::Operand::Kind::variable) {
        return contact(operand->variable,
                       negated ? ladder::ContactKind::negated : ladder::ContactKind::normal);
    }
    if ((operand->value != 0) != negated) return ladder::Power();
    source_.error(element.node, messages::plcopen::never_1());
    return std::nullopt;
}

std::optional<ladder::Power> LadderNetworks::comparison_of(std::size_t element) {
    const Element& item = elements_[element];
    const auto left = operand(element, "IN1", ladder::Operand::Kind::number, false);
    const auto right = operand(element, "IN2", ladder::Operand::Kind::number, false);
    if (!left || !right) return std::nullopt;
    ladder::Power comparison;
    comparison.kind = ladder::Power::Kind::comparison;
    comparison.relation = *comparison_named(item.text);
    comparison.left = *left;
    comparison.right = *right;
    const Inlet* enable = item.inlet("EN");
    if (enable == nullptr || enable->sources.empty()) return comparison;
    auto before = power(*enable, element);
    if (!before) return std::nullopt;
    std::vector<ladder::Power> both;
    both.push_back(std::move(*before));
    both.push_back(std::move(comparison));
    return series(std::move(both));
}

std::optional<ladder::Power> LadderNetworks::gate_of(std::size_t element) {
    std::vector<ladder::Power> parts;
    for (const Inlet& inlet : elements_[element].inlets) {
        if (inlet.name == "EN" && inlet.sources.empty()) continue;
        auto part = power(inlet, element);
        if (!part) return std::nullopt;
        parts.push_back(std::move(*part));
    }
    if (elements_[element].text == "AND") return series(std::move(parts));
    return parallel(std::move(parts));
}

/// The output of a block that has been executed.
std::optional<ladder::Power> LadderNetworks::block_output(std::size_t element) {
    const Element& item = elements_[element];
    const ladder::BlockTypeRow* row = block_named(item.text);
    if (row == nullptr) return std::nullopt;
    read_block(element);
    if (states_[element] != State::done) return std::nullopt;
    if (row->is_function) {
        const auto executed = executed_.find(element);
        if (executed != executed_.end()) return contact(executed->second);
        source_.error(item.node, messages::plcopen::number_as_power());
        return std::nullopt;
    }
    const auto instance =
        variables_.instance(item.node.attribute("instanceName").as_string(), row->type, item.node);
    if (!instance) return std::nullopt;
    return contact(*instance);
}

std::optional<ladder::Block> LadderNetworks::block_of(std::size_t element) {
    const ladder::BlockTypeRow& row = *block_named(elements_[element].text);
    ladder::Block block;
    block.type = row.type;
    for (std::size_t i = 0; i < operand_count(row); ++i) {
        const bool is_time =
            row.type == ladder::BlockType::on_delay || row.type == ladder::BlockType::off_delay;
        const bool is_bit = !row.is_function && row.inputs[i] != "PV";
        const auto value =
            operand(element, row.inputs[i],
                    is_time ? ladder::Operand::Kind::time : ladder::Operand::Kind::number,
                    is_bit && !is_time);
        if (!value) return std::nullopt;
        block.operands.push_back(*value);
    }
    const auto target =
        row.is_function
            ? target_of(element)
            : variables_.instance(elements_[element].node.attribute("instanceName").as_string(),
                                  row.type, elements_[element].node);
    if (!target) return std::nullopt;
    block.target = *target;
    return block;
}

/// Where a function leaves its result: in the variable of the first outVariable it feeds, or in one
/// of the reader's own where blocks are wired to it.
std::optional<ladder::VariableId> LadderNetworks::target_of(std::size_t element) {
    std::optional<ladder::VariableId> target;
    bool is_wired = false;
    for (const auto& consumer : elements_.consumers({element, "OUT"})) {
        const Element& item = elements_[consumer.element];
        if (item.kind != Kind::out_variable) {
            is_wired = true;
        } else if (!target) {
            target = variables_.integer(item.text, item.node);
            if (!target) return std::nullopt;
        }
    }
    if (!target || is_wired) {
        target = variables_.add_hidden(
            fmt::format("OUT_{}", elements_[element].node.attribute("localId").as_string()),
            ladder::Type::integer);
    }
    results_[element] = *target;
    return target;
}

void LadderNetworks::add_moves(std::size_t element, ladder::Rung& rung) {
    const auto result = results_.find(element);
    if (result == results_.end()) return;
    for (const auto& consumer : elements_.consumers({element, "OUT"})) {
        const Element& item = elements_[consumer.element];
        if (item.kind != Kind::out_variable) continue;
        states_[consumer.element] = State::done;
        const auto target = variables_.integer(item.text, item.node);
        if (!target || *target == result->second) continue;
        const ladder::Operand source{ladder::Operand::Kind::variable, 0, result->second};
        rung.blocks.push_back({ladder::BlockType::move, *target, {source}});
    }
}

bool LadderNetworks::gives_number(const Output& output) const {
    const Element& item = elements_[output.element];
    if (item.kind != Kind::block || is_pure(output.element)) return false;
    const ladder::BlockTypeRow* row = block_named(item.text);
    return row != nullptr &&
           (output.parameter == "CV" || (row->is_function && output.parameter == "OUT"));
}

std::optional<ladder::Operand> LadderNetworks::operand(std::size_t element, std::string_view name,
                                                       ladder::Operand::Kind kind, bool of_bits) {
    const Element& item = elements_[element];
    const Inlet* inlet = item.inlet(name);
    if (inlet != nullptr && !inlet->expression.empty()) {
        return variables_.operand(inlet->expression, kind, of_bits, inlet->node);
    }
    if (inlet == nullptr || inlet->sources.empty()) {
        if (of_bits) return ladder::Operand{};
        source_.error(item.node, messages::plcopen::input_not_connected(name));
        return std::nullopt;
    }
    const Output& source = inlet->sources.front();
    const bool is_one = inlet->sources.size() == 1;
    const Element& from = elements_[source.element];
    if (is_one && from.kind == Kind::in_variable && !inlet->negated &&
        !from.node.attribute("negated").as_bool()) {
        return variables_.operand(from.text, kind, of_bits, from.node);
    }
    if (is_one && !of_bits && gives_number(source)) {
        read_block(source.element);
        ladder::Operand operand{ladder::Operand::Kind::variable, 0, {}};
        if (const auto result = results_.find(source.element); result != results_.end()) {
            operand.variable = result->second;
            return operand;
        }
        const auto instance = variables_.instance(from.node.attribute("instanceName").as_string(),
                                                  block_named(from.text)->type, from.node);
        if (!instance) return std::nullopt;
        operand.variable = *instance;
        return operand;
    }
    if (of_bits) return worked_out(*inlet, element);
    source_.error(inlet->node, messages::plcopen::no_number(name));
    return std::nullopt;
}

/// A bit that a rung of its own works out.
ladder::Operand LadderNetworks::worked_out(const Inlet& inlet, std::size_t element) {
    Inlet plain = inlet;
    plain.negated = false;
    const ladder::VariableId bit = variables_.add_hidden(
        fmt::format("{}_{}", inlet.name, elements_[element].node.attribute("localId").as_string()),
        ladder::Type::bit);
    if (auto cause = power(plain, element)) {
        ladder::Rung rung;
        rung.power = std::move(*cause);
        rung.coils.push_back(
            {inlet.negated ? ladder::CoilKind::negated : ladder::CoilKind::normal, bit});
        push(std::move(rung), element);
    }
    return {ladder::Operand::Kind::variable, 0, bit};
}

}  // namespace grafwire::plcopen
