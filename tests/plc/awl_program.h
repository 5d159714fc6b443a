#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// A SIMATIC S7 operand: `E 0.0`, `MW 20`, `T 3`, `L#5`, `S5T#2S`, `FC 1`, a label.
struct AwlOperand {
    enum class Kind { none, bit, word, timer, constant, s5_time, block, label };
    Kind kind = Kind::none;
    char area = ' ';           ///< 'E', 'A' or 'M' whatever the mnemonics
    std::uint32_t number = 0;  ///< of a byte, a timer, a block
    std::uint32_t bit = 0;
    std::uint32_t bytes = 0;  ///< of a word
    std::int64_t value = 0;   ///< of a constant; of a time in picoseconds
    bool is_wide = false;     ///< of a constant: L#
    std::string label;
};

struct AwlInstruction {
    std::string operation;  ///< in SIMATIC mnemonics
    AwlOperand operand;
    // Of CALL SFB n, DB n: the parameters.
    AwlOperand in, out;
    std::uint32_t data_block = 0;
    std::size_t line = 0;
};

/// A block of code: its instructions, and where its labels stand.
struct AwlBlock {
    std::vector<AwlInstruction> instructions;
    std::map<std::string, std::size_t> labels;
};

/// A source file in Statement List.
struct AwlProgram {
    std::map<std::string, AwlBlock> blocks;            ///< `FC 1`, `OB 1`
    std::map<std::uint32_t, std::uint32_t> instances;  ///< data block to its SFB
    std::map<std::string, AwlOperand> symbols;         ///< of the assignment in the comments
};

/// Reads such a file in the mnemonics given; refuses what STEP 7 would: unknown mnemonics,
/// malformed operands, times that are not exact, labels of more than four characters or that are
/// not there, calls of blocks that come later.
AwlProgram read_awl(const std::string& text, bool international);

}  // namespace grafwire::testing
