// What blocks read, and where functions leave their results.

#include "plcopen/plcopen_networks.h"

namespace grafwire::ladder {

namespace {

using Kind = PlcopenElement::Kind;

}  // namespace

std::optional<Block> PlcopenNetworks::block_of(std::size_t element) {
    const BlockTypeRow& row = *block_named(elements_[element].text);
    Block block;
    block.type = row.type;
    for (std::size_t i = 0; i < operand_count(row); ++i) {
        const bool is_time = row.type == BlockType::on_delay || row.type == BlockType::off_delay;
        const bool is_bit = !row.is_function && row.inputs[i] != "PV";
        const auto value =
            operand(element, row.inputs[i], is_time ? Operand::Kind::time : Operand::Kind::number,
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
std::optional<VariableId> PlcopenNetworks::target_of(std::size_t element) {
    std::optional<VariableId> target;
    bool is_wired = false;
    for (const auto& consumer : elements_.consumers({element, "OUT"})) {
        const PlcopenElement& item = elements_[consumer.element];
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
            Type::integer);
    }
    results_[element] = *target;
    return target;
}

void PlcopenNetworks::add_moves(std::size_t element, Rung& rung) {
    const auto result = results_.find(element);
    if (result == results_.end()) return;
    for (const auto& consumer : elements_.consumers({element, "OUT"})) {
        const PlcopenElement& item = elements_[consumer.element];
        if (item.kind != Kind::out_variable) continue;
        states_[consumer.element] = State::done;
        const auto target = variables_.integer(item.text, item.node);
        if (!target || *target == result->second) continue;
        const Operand source{Operand::Kind::variable, 0, result->second};
        rung.blocks.push_back({BlockType::move, *target, {source}});
    }
}

bool PlcopenNetworks::gives_number(const PlcopenOutput& output) const {
    const PlcopenElement& item = elements_[output.element];
    if (item.kind != Kind::block || is_pure(output.element)) return false;
    const BlockTypeRow* row = block_named(item.text);
    return row != nullptr &&
           (output.parameter == "CV" || (row->is_function && output.parameter == "OUT"));
}

std::optional<Operand> PlcopenNetworks::operand(std::size_t element, std::string_view name,
                                                Operand::Kind kind, bool of_bits) {
    const PlcopenElement& item = elements_[element];
    const PlcopenInlet* inlet = item.inlet(name);
    if (inlet != nullptr && !inlet->expression.empty()) {
        return variables_.operand(inlet->expression, kind, of_bits, inlet->node);
    }
    if (inlet == nullptr || inlet->sources.empty()) {
        if (of_bits) return Operand{};
        source_.error(item.node, fmt::format("input {} of this block is not connected", name));
        return std::nullopt;
    }
    const PlcopenOutput& source = inlet->sources.front();
    const bool is_one = inlet->sources.size() == 1;
    const PlcopenElement& from = elements_[source.element];
    if (is_one && from.kind == Kind::in_variable && !inlet->negated &&
        !from.node.attribute("negated").as_bool()) {
        return variables_.operand(from.text, kind, of_bits, from.node);
    }
    if (is_one && !of_bits && gives_number(source)) {
        read_block(source.element);
        Operand operand{Operand::Kind::variable, 0, {}};
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
    source_.error(inlet->node, fmt::format("input {} of this block is fed by no number", name));
    return std::nullopt;
}

/// A bit that a rung of its own works out.
Operand PlcopenNetworks::worked_out(const PlcopenInlet& inlet, std::size_t element) {
    PlcopenInlet plain = inlet;
    plain.negated = false;
    const VariableId bit = variables_.add_hidden(
        fmt::format("{}_{}", inlet.name, elements_[element].node.attribute("localId").as_string()),
        Type::bit);
    if (auto cause = power(plain, element)) {
        Rung rung;
        rung.power = std::move(*cause);
        rung.coils.push_back({inlet.negated ? CoilKind::negated : CoilKind::normal, bit});
        push(std::move(rung), element);
    }
    return {Operand::Kind::variable, 0, bit};
}

}  // namespace grafwire::ladder
