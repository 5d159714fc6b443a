#include "referee/ladder_interpreter.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace grafwire::testing {

using ladder::Block;
using ladder::BlockType;
using ladder::Coil;
using ladder::CoilKind;
using ladder::ContactKind;
using ladder::Power;
using ladder::Rung;
using ladder::Type;
using ladder::Variable;

std::size_t LadderInterpreter::variable_named(const std::string& name) const {
    for (std::size_t v = 0; v < ladder_.variables.size(); ++v) {
        if (ladder_.variables[v].name == name) return v;
    }
    return ladder_.variables.size();
}

void LadderInterpreter::start() {
    bits_.assign(ladder_.variables.size(), false);
    numbers_.assign(ladder_.variables.size(), 0);
    instances_.assign(ladder_.variables.size(), {});
    edges_.clear();
    for (std::size_t v = 0; v < ladder_.variables.size(); ++v) {
        const Variable& variable = ladder_.variables[v];
        if (variable.type == Type::bit) bits_[v] = variable.initial != 0;
        if (variable.type == Type::integer) numbers_[v] = variable.initial;
    }
}

std::vector<bool> LadderInterpreter::shown() const {
    std::vector<bool> values;
    const auto add = [&](const std::string& name) {
        const std::size_t variable = variable_named(name);
        if (variable == ladder_.variables.size()) FAIL("no variable " << name);
        values.push_back(bits_[variable]);
    };
    for (const Step& step : grafcet_.steps) add("X" + step.name);
    for (const Output& output : grafcet_.outputs) add(output.name);
    return values;
}

void LadderInterpreter::scan(Time now, const InputValues& inputs) {
    now_ = now;
    place_ = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const std::size_t variable = variable_named(std::string(input_name(grafcet_, i)));
        if (variable < ladder_.variables.size()) bits_[variable] = inputs[i] != 0;
    }
    for (const Rung& rung : ladder_.rungs) {
        bool power = flow(rung.power);
        for (const Block& part : rung.blocks) power = block(part, power);
        for (const Coil& part : rung.coils) coil(part, power);
    }
}

/// Every part is evaluated, whether there is power before it or not.
bool LadderInterpreter::flow(const Power& power) {
    bool all = true;
    bool any = false;
    for (const Power& part : power.parts) {
        const bool passes = flow(part);
        all = all && passes;
        any = any || passes;
    }
    switch (power.kind) {
        case Power::Kind::wire:
            return true;
        case Power::Kind::series:
            return all;
        case Power::Kind::parallel:
            return any;
        case Power::Kind::comparison:
            return compare(power);
        case Power::Kind::contact:
            break;
    }
    const bool value = bits_[static_cast<std::size_t>(power.variable)];
    switch (power.contact) {
        case ContactKind::negated:
            return !value;
        case ContactKind::rising:
            return edge(value, true);
        case ContactKind::falling:
            return edge(value, false);
        default:
            return value;
    }
}

bool LadderInterpreter::edge(bool now, bool rising) {
    bool& last = edges_[place_++];
    const bool before = last;
    last = now;
    return rising ? now && !before : !now && before;
}

std::int64_t LadderInterpreter::number(const ladder::Operand& operand) const {
    if (operand.kind != ladder::Operand::Kind::variable) return operand.value;
    return numbers_[static_cast<std::size_t>(operand.variable)];
}

bool LadderInterpreter::bit(const ladder::Operand& operand) const {
    if (operand.kind != ladder::Operand::Kind::variable) return operand.value != 0;
    return bits_[static_cast<std::size_t>(operand.variable)];
}

bool LadderInterpreter::compare(const Power& power) const {
    const std::int64_t left = number(power.left);
    const std::int64_t right = number(power.right);
    switch (power.relation) {
        case Relation::equal:
            return left == right;
        case Relation::not_equal:
            return left != right;
        case Relation::less:
            return left < right;
        case Relation::less_equal:
            return left <= right;
        case Relation::greater:
            return left > right;
        default:
            return left >= right;
    }
}

/// The power behind a block: ENO of a function, Q of a function block.
bool LadderInterpreter::block(const Block& block, bool power) {
    const auto target = static_cast<std::size_t>(block.target);
    if (row_of(block.type).is_function) {
        if (power) function(block);
        return power;
    }
    const bool last = instances_[target].last;
    instances_[target].last = power;
    switch (block.type) {
        case BlockType::rise:
            bits_[target] = power && !last;
            break;
        case BlockType::fall:
            bits_[target] = !power && last;
            break;
        case BlockType::set_dominant:
            bits_[target] = power || (bits_[target] && !bit(block.operands[0]));
            break;
        case BlockType::reset_dominant:
            bits_[target] = (power || bits_[target]) && !bit(block.operands[0]);
            break;
        case BlockType::on_delay:
        case BlockType::off_delay:
            timer(block, power);
            break;
        default:
            counter(block, power && !last);
            break;
    }
    return bits_[target];
}

/// TON: Q once IN has been 1 for PT. TOF: Q until IN has been 0 for PT.
void LadderInterpreter::timer(const Block& block, bool power) {
    const auto target = static_cast<std::size_t>(block.target);
    Instance& instance = instances_[target];
    const bool is_on_delay = block.type == BlockType::on_delay;
    const bool waits = is_on_delay ? power : !power && bits_[target];
    if (!waits) {
        instance.runs = false;
        bits_[target] = power && !is_on_delay;
        return;
    }
    if (!instance.runs) instance.since = now_;
    instance.runs = true;
    const bool is_over = now_ - instance.since >= block.operands[0].value;
    bits_[target] = is_on_delay == is_over;
}

void LadderInterpreter::counter(const Block& block, bool counts) {
    const auto target = static_cast<std::size_t>(block.target);
    const bool is_up = block.type == BlockType::count_up;
    const std::int64_t preset = number(block.operands[1]);
    std::int64_t& value = numbers_[target];
    if (bit(block.operands[0])) {
        value = is_up ? 0 : preset;
    } else if (counts) {
        value += is_up ? 1 : -1;
    }
    bits_[target] = is_up ? value >= preset : value <= 0;
}

void LadderInterpreter::function(const Block& block) {
    std::vector<std::int64_t> in;
    for (const ladder::Operand& operand : block.operands) in.push_back(number(operand));
    // Without a sign, as overflow is to wrap around.
    const auto bits = [&](std::size_t i) { return static_cast<std::uint64_t>(in[i]); };
    std::uint64_t result = bits(0);
    if (block.type == BlockType::add) result = bits(0) + bits(1);
    if (block.type == BlockType::subtract) result = bits(0) - bits(1);
    if (block.type == BlockType::multiply) result = bits(0) * bits(1);
    std::int64_t value = static_cast<std::int64_t>(result);
    if (block.type == BlockType::limit) value = std::max(in[0], std::min(in[1], in[2]));
    numbers_[static_cast<std::size_t>(block.target)] = value;
}

void LadderInterpreter::coil(const Coil& coil, bool power) {
    const auto variable = static_cast<std::size_t>(coil.variable);
    switch (coil.kind) {
        case CoilKind::normal:
            bits_[variable] = power;
            return;
        case CoilKind::negated:
            bits_[variable] = !power;
            return;
        case CoilKind::set:
            if (power) bits_[variable] = true;
            return;
        case CoilKind::reset:
            if (power) bits_[variable] = false;
            return;
        case CoilKind::rising:
        case CoilKind::falling:
            bits_[variable] = edge(power, coil.kind == CoilKind::rising);
            return;
    }
}

}  // namespace grafwire::testing
