#pragma once

#include <cstdint>
#include <vector>

#include "s7/listing.h"

namespace grafwire::s7 {

// Short forms for programs that write listings.

/// `V20.1`, from the number of the byte and of the bit.
Operand v_bit(std::uint32_t byte, std::uint32_t bit);
/// `VB2`, `VW2`, `VD2`.
Operand v_word(Width width, std::uint32_t byte);
Operand timer_operand(std::uint32_t number);
Operand constant_operand(std::int64_t value);
/// SM0.0, always 1, and SM0.1, 1 in the first scan.
Operand always_on();
Operand first_scan();

Instruction make(Operation operation, std::vector<Operand> operands = {});
/// Of operations on bytes, words or double words.
Instruction make(Operation operation, Width width, std::vector<Operand> operands);
Instruction make_compare(Operation operation, Width width, Compare compare, Operand left,
                         Operand right);

/// An unbroken run of bits, as S and R take them.
struct BitRun {
    Operand first;
    std::uint32_t count = 0;
};
/// The runs, of at most 255 bits each, that make up these bits, in the order of their addresses.
std::vector<BitRun> runs_of(std::vector<Operand> bits);

}  // namespace grafwire::s7
