#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "s7/listing.h"

namespace grafwire::s7 {

/// What may stand in one place behind a mnemonic.
enum class OperandKind : std::uint8_t {
    none,
    bit,        ///< a bit to read: of E, A, V, M or SM, or a timer's or counter's
    place_bit,  ///< a bit to write: of E, A, V or M
    reset_bit,  ///< a place_bit, a timer or a counter
    value,      ///< memory of the width of the row, or a constant; of words, a current value too
    place,      ///< memory of the width of the row
    count,      ///< a constant, 1 … 255
    preset,     ///< a word in memory, or a constant 0 … 32767
    timer,
    counter,
    subroutine,  ///< the number of a subroutine, as a constant
    label,       ///< the number of a label, as a constant
    number,      ///< any constant, 0 … 255
};

/// How the size of an instruction comes about.
enum class SizeRule : std::uint8_t {
    fixed,     ///< always the size of the row
    of_bit,    ///< one byte more where the bit is in V, whose addresses need two bytes
    of_words,  ///< two bytes more for each operand in memory, and the width of each constant
};

/// Where the size of an instruction is known from.
enum class SizeSource : std::uint8_t {
    offsets,  ///< the offsets that Cordier prints before instructions
    analogy,  ///< no listing shows the instruction: the size of its nearest relative
};

/// One row per instruction and width; of a comparison, the six relations share a row.
struct InstructionRow {
    Operation operation;
    Width width;
    std::string_view simatic;        ///< of a comparison without its relation: `LDB`
    std::string_view international;  ///< likewise
    std::array<OperandKind, 3> operands;
    std::uint8_t size;  ///< in bytes, to which the rule adds
    SizeRule rule;
    SizeSource source;

    std::size_t operand_count() const;
    bool is_comparison() const {
        return operation == Operation::load_compare || operation == Operation::and_compare ||
               operation == Operation::or_compare;
    }
};

std::span<const InstructionRow> instruction_set();

/// The row of an instruction; nullptr where there is none of that operation and width.
const InstructionRow* row_of(Operation operation, Width width);

/// An instruction without operands, by its mnemonic in either spelling.
struct NamedInstruction {
    const InstructionRow* row = nullptr;
    Compare compare = Compare::equal;
};
std::optional<NamedInstruction> instruction_named(std::string_view mnemonic);

/// All mnemonics of a spelling, comparisons with their relations.
std::span<const std::string_view> mnemonic_names();

std::string_view relation_sign(Compare compare);
std::string mnemonic_of(const Instruction& instruction, Mnemonics mnemonics);

/// The bytes an instruction takes in the program memory; 0 for one that is not in the set.
std::uint32_t size_of(const Instruction& instruction);

/// The size of a whole program.
std::uint32_t size_of(const Listing& listing);

/// A printed offset at which the instruction before it does not end.
struct OffsetDeviation {
    std::uint32_t network = 0;
    std::uint32_t printed = 0;
    std::uint32_t computed = 0;  ///< the printed offset of the instruction before it, and its size
    Location where;
};

/// Compares each printed offset with the one before it, so that one misprint is one deviation,
/// whatever follows. Instructions without offset count with their size.
std::vector<OffsetDeviation> offset_deviations(const Listing& listing);

/// Gives every instruction its offset from the beginning of the program.
void set_offsets(Listing& listing);

}  // namespace grafwire::s7
