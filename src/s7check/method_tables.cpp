#include "s7check/method_tables.h"

#include <algorithm>

#include "s7/instruction_set.h"

namespace grafwire {

namespace {

using s7::Operation;

constexpr std::int64_t bits_in(s7::Width width) {
    switch (width) {
        case s7::Width::byte:
            return 8;
        case s7::Width::word:
            return 16;
        case s7::Width::dword:
            return 32;
        default:
            return 1;
    }
}

/// The bits of an area that an instruction writes, as a range.
struct WrittenBits {
    s7::Area area = s7::Area::constant;  ///< constant: none
    std::int64_t first = 0;
    std::int64_t end = 0;
};

WrittenBits written_by(const s7::Instruction& instruction) {
    const s7::InstructionRow* row = s7::row_of(instruction.operation, instruction.width);
    if (row == nullptr) return {};
    std::int64_t count = 1;
    const s7::Operand* place = nullptr;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
        const s7::OperandKind kind = row->operands[i];
        if (kind == s7::OperandKind::place || kind == s7::OperandKind::place_bit ||
            kind == s7::OperandKind::reset_bit) {
            place = &instruction.operands[i];
        } else if (kind == s7::OperandKind::count) {
            count = instruction.operands[i].address;
        }
    }
    if (place == nullptr) return {};
    const std::int64_t first = std::int64_t{place->address} * 8 + place->bit;
    return {place->area, first, first + bits_in(place->width) * count};
}

bool is_bit_within(const std::optional<s7::Operand>& operand, std::int32_t first,
                   std::int32_t bytes) {
    return operand && operand->area == s7::Area::variable && operand->width == s7::Width::bit &&
           operand->address >= first && operand->address < first + bytes;
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

bool may_write(const s7::Instruction& instruction, const s7::Operand& place) {
    const WrittenBits written = written_by(instruction);
    const std::int64_t first = std::int64_t{place.address} * 8 + place.bit;
    return written.area == place.area && written.first < first + bits_in(place.width) &&
           written.end > first;
}

bool may_write_bytes(const s7::Instruction& instruction, std::int32_t first, std::int32_t count) {
    const WrittenBits written = written_by(instruction);
    return written.area == s7::Area::variable &&
           written.first < (std::int64_t{first} + count) * 8 &&
           written.end > std::int64_t{first} * 8;
}

bool loads(const s7::Instruction& instruction, const s7::Operand& bit) {
    switch (instruction.operation) {
        case Operation::load:
        case Operation::load_not:
        case Operation::and_:
        case Operation::and_not:
        case Operation::or_:
        case Operation::or_not:
            return instruction.operands[0] == bit;
        default:
            return false;
    }
}

}  // namespace grafwire
