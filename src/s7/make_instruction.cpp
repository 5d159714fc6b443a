// Operands and instructions as the generator writes them. Bits that follow each other are set and
// reset by one instruction, as a programmer would write it.

#include "s7/make_instruction.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace grafwire::s7 {

namespace {

/// The largest count of an S or R.
constexpr std::uint32_t longest_run = 255;

/// Whether `next` is the bit after `bit`, or the timer after it.
bool follows(const Operand& bit, const Operand& next) {
    if (bit.area != next.area) return false;
    if (bit.area == Area::timer) return next.address == bit.address + 1;
    return next.address * 8 + next.bit == bit.address * 8 + bit.bit + 1;
}

}  // namespace

Operand v_bit(std::uint32_t byte, std::uint32_t bit) {
    return {Area::variable,
            Width::bit,
            static_cast<std::int32_t>(byte),
            static_cast<std::uint8_t>(bit),
            {}};
}

Operand v_word(Width width, std::uint32_t byte) {
    return {Area::variable, width, static_cast<std::int32_t>(byte), 0, {}};
}

Operand timer_operand(std::uint32_t number) {
    return {Area::timer, Width::bit, static_cast<std::int32_t>(number), 0, {}};
}

Operand constant_operand(std::int64_t value) {
    return {Area::constant, Width::bit, static_cast<std::int32_t>(value), 0, {}};
}

Operand always_on() {
    return {Area::special, Width::bit, 0, 0, {}};
}

Operand first_scan() {
    return {Area::special, Width::bit, 0, 1, {}};
}

Instruction make(Operation operation, std::vector<Operand> operands) {
    return make(operation, Width::bit, std::move(operands));
}

Instruction make(Operation operation, Width width, std::vector<Operand> operands) {
    Instruction instruction;
    instruction.operation = operation;
    instruction.width = width;
    instruction.operands = std::move(operands);
    return instruction;
}

Instruction make_compare(Operation operation, Width width, Compare compare, Operand left,
                         Operand right) {
    Instruction instruction = make(operation, width, {std::move(left), std::move(right)});
    instruction.compare = compare;
    return instruction;
}

std::vector<BitRun> runs_of(std::vector<Operand> bits) {
    std::sort(bits.begin(), bits.end(), [](const Operand& a, const Operand& b) {
        return std::tie(a.area, a.address, a.bit) < std::tie(b.area, b.address, b.bit);
    });
    bits.erase(std::unique(bits.begin(), bits.end()), bits.end());
    std::vector<BitRun> runs;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        const bool joins =
            i != 0 && follows(bits[i - 1], bits[i]) && runs.back().count < longest_run;
        if (!joins) runs.push_back({bits[i], 0});
        ++runs.back().count;
    }
    return runs;
}

}  // namespace grafwire::s7
