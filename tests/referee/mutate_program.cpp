#include "referee/mutate_program.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "grafcet/expression.h"

namespace grafwire::testing {

namespace {

using ladder::BlockType;
using ladder::CoilKind;
using ladder::ContactKind;
using ladder::Ladder;
using ladder::Power;
using ladder::Rung;
using ladder::VariableId;

/// All parts of a power, itself included.
void collect(Power& power, std::vector<Power*>& parts) {
    parts.push_back(&power);
    for (Power& part : power.parts) collect(part, parts);
}

VariableId other_bit(const Ladder& ladder, RandomSource& random) {
    for (;;) {
        const VariableId id{static_cast<std::uint32_t>(random.below(ladder.variables.size()))};
        if (ladder.variable(id).type == ladder::Type::bit) return id;
    }
}

std::string change_power(Ladder& ladder, Power& part, RandomSource& random) {
    if (part.kind == Power::Kind::wire) return {};
    if (part.kind == Power::Kind::comparison) {
        part.relation = complement(part.relation);
        return "a comparison the other way round";
    }
    if (part.kind == Power::Kind::contact) {
        if (random.flip()) {
            part.variable = other_bit(ladder, random);
            return "a contact of " + ladder.variable(part.variable).name;
        }
        part.contact =
            part.contact == ContactKind::normal ? ContactKind::negated : ContactKind::normal;
        return "another kind of contact of " + ladder.variable(part.variable).name;
    }
    if (random.flip()) {
        part.kind = part.kind == Power::Kind::series ? Power::Kind::parallel : Power::Kind::series;
        return "series and parallel confused";
    }
    std::vector<Power> parts = part.parts;
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(random.below(parts.size())));
    const bool is_series = part.kind == Power::Kind::series;
    part = is_series ? ladder::series(std::move(parts)) : ladder::parallel(std::move(parts));
    return "a branch left out";
}

std::string change_coil(Ladder& ladder, Rung& rung, RandomSource& random) {
    if (rung.coils.empty()) return {};
    ladder::Coil& coil = rung.coils[random.below(rung.coils.size())];
    if (random.one_in(3)) {
        coil.variable = other_bit(ladder, random);
        return "a coil of " + ladder.variable(coil.variable).name;
    }
    static constexpr CoilKind others[] = {CoilKind::negated, CoilKind::normal, CoilKind::reset,
                                          CoilKind::set,     CoilKind::normal, CoilKind::normal};
    coil.kind = others[static_cast<std::size_t>(coil.kind)];
    return "another kind of coil of " + ladder.variable(coil.variable).name;
}

std::string change_block(Rung& rung, RandomSource& random) {
    if (rung.blocks.empty()) return {};
    ladder::Block& block = rung.blocks[random.below(rung.blocks.size())];
    if (block.operands.empty()) {
        block.type = block.type == BlockType::rise ? BlockType::fall : BlockType::rise;
        return "another edge";
    }
    ladder::Operand& operand = block.operands[random.below(block.operands.size())];
    if (operand.kind == ladder::Operand::Kind::variable) return {};
    const bool is_time = operand.kind == ladder::Operand::Kind::time;
    operand.value += is_time ? millisecond : 1;
    return "another operand of a block";
}

std::string change_order(Ladder& ladder, std::size_t rung, RandomSource& random) {
    if (random.flip() && rung + 1 < ladder.rungs.size()) {
        std::swap(ladder.rungs[rung], ladder.rungs[rung + 1]);
        return "two rungs swapped";
    }
    ladder.rungs.erase(ladder.rungs.begin() + static_cast<std::ptrdiff_t>(rung));
    return "a rung left out";
}

std::string change_rung(Ladder& ladder, std::size_t number, RandomSource& random) {
    Rung& rung = ladder.rungs[number];
    std::vector<Power*> parts;
    collect(rung.power, parts);
    switch (random.below(6)) {
        case 0:
            return change_coil(ladder, rung, random);
        case 1:
            return change_block(rung, random);
        case 2:
            return change_order(ladder, number, random);
        default:
            return change_power(ladder, *random.pick(parts), random);
    }
}

using s7::Area;
using s7::Instruction;
using s7::Listing;
using s7::Operation;

Operation mistaken(Operation operation) {
    static constexpr std::pair<Operation, Operation> pairs[] = {
        {Operation::load, Operation::load_not},      {Operation::and_, Operation::or_},
        {Operation::and_not, Operation::or_not},     {Operation::and_load, Operation::or_load},
        {Operation::rise, Operation::fall},          {Operation::set, Operation::reset},
        {Operation::and_words, Operation::or_words}, {Operation::add, Operation::subtract},
    };
    for (const auto& [a, b] : pairs) {
        if (operation == a) return b;
        if (operation == b) return a;
    }
    return operation;
}

Operation negated(Operation operation) {
    switch (operation) {
        case Operation::and_:
            return Operation::and_not;
        case Operation::and_not:
            return Operation::and_;
        case Operation::or_:
            return Operation::or_not;
        case Operation::or_not:
            return Operation::or_;
        default:
            return mistaken(operation);
    }
}

std::vector<s7::Operand> bits_in(const Listing& listing) {
    std::vector<s7::Operand> bits;
    for (const s7::Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) {
            for (const s7::Operand& operand : instruction.operands) {
                if (operand.width == s7::Width::bit && operand.area <= Area::memento) {
                    bits.push_back(operand);
                }
            }
        }
    }
    return bits;
}

std::string change_operand(const Listing& listing, Instruction& instruction, RandomSource& random) {
    if (instruction.operands.empty()) return {};
    s7::Operand& operand = instruction.operands[random.below(instruction.operands.size())];
    if (operand.area == Area::constant) {
        operand.address += random.flip() ? 1 : -1;
        return "another constant";
    }
    if (operand.width != s7::Width::bit || operand.area > Area::memento) return {};
    operand = random.pick(bits_in(listing));
    return "another bit";
}

std::string change_instruction(const Listing& listing, Instruction& instruction,
                               RandomSource& random) {
    const Operation before = instruction.operation;
    switch (random.below(4)) {
        case 0:
            instruction.operation = mistaken(before);
            return instruction.operation == before ? "" : "another operation";
        case 1:
            instruction.operation = negated(before);
            return instruction.operation == before ? "" : "a negation too many or too few";
        case 2:
            return change_operand(listing, instruction, random);
        default:
            break;
    }
    const bool can_go = before == Operation::and_ || before == Operation::and_not ||
                        before == Operation::or_ || before == Operation::or_not ||
                        (before >= Operation::assign && before <= Operation::reset) ||
                        (before >= Operation::move && before <= Operation::on_delay);
    if (!can_go) return {};
    instruction = {};
    instruction.operands = {{Area::constant, s7::Width::bit, 0, 0, {}}};
    return "an instruction left out";
}

}  // namespace

Ladder mutated(Ladder ladder, RandomSource& random, std::string& told) {
    for (told.clear(); told.empty();) {
        const std::size_t rung = random.below(ladder.rungs.size());
        const std::string what = change_rung(ladder, rung, random);
        if (!what.empty()) told = what + ", rung " + std::to_string(rung + 1);
    }
    return ladder;
}

Listing mutated(Listing listing, RandomSource& random, std::string& told) {
    for (told.clear(); told.empty();) {
        s7::Network& network = listing.networks[random.below(listing.networks.size())];
        if (network.instructions.empty()) continue;
        const std::size_t at = random.below(network.instructions.size());
        const std::string what = change_instruction(listing, network.instructions[at], random);
        if (!what.empty()) {
            told = what + ", network " + std::to_string(network.number) + ", instruction " +
                   std::to_string(at + 1);
        }
    }
    return listing;
}

}  // namespace grafwire::testing
