// The sizes are read off the offsets that Cordier prints before each instruction: an instruction
// ends where the next one begins. They agree with one another throughout the skeleton (sections 5.0
// to 5.9) and the three applications, except in one place: application 3, network 13, prints
// `66 = V10.0`, `67 = V20.0`, then 69, as if `= V10.0` took one byte and `= V20.0` two (three
// everywhere else); all offsets behind it are too small by three. tests/s7/test_offsets.cpp
// computes all of them again.
//
// What they say: an operation takes two bytes with a bit of E, A, SM or T, three with one of V,
// whose address needs a byte more. Work on bytes and words takes two bytes, two for each address,
// and for a constant as many as its width.

#include "s7/instruction_set.h"

#include <unordered_map>
#include <vector>

namespace grafwire::s7 {

namespace {

using enum Operation;
using enum SizeRule;
using enum SizeSource;
using Kind = OperandKind;

constexpr auto bit = Width::bit;
constexpr auto byte = Width::byte;
constexpr auto word = Width::word;
constexpr auto dword = Width::dword;

constexpr InstructionRow table[] = {
    // Bit logic.
    {load, bit, "LD", "LD", {Kind::bit}, 2, of_bit, offsets},
    {load_not, bit, "LDN", "LDN", {Kind::bit}, 2, of_bit, offsets},
    {and_, bit, "U", "A", {Kind::bit}, 2, of_bit, offsets},
    {and_not, bit, "UN", "AN", {Kind::bit}, 2, of_bit, offsets},
    {or_, bit, "O", "O", {Kind::bit}, 2, of_bit, offsets},
    {or_not, bit, "ON", "ON", {Kind::bit}, 2, of_bit, analogy},  // as O
    {and_load, bit, "ULD", "ALD", {}, 1, fixed, analogy},        // as OLD
    {or_load, bit, "OLD", "OLD", {}, 1, fixed, offsets},
    {push, bit, "LPS", "LPS", {}, 1, fixed, analogy},  // these seven as OLD
    {read_push, bit, "LRD", "LRD", {}, 1, fixed, analogy},
    {pop, bit, "LPP", "LPP", {}, 1, fixed, analogy},
    {negate, bit, "NOT", "NOT", {}, 1, fixed, analogy},
    {rise, bit, "EU", "EU", {}, 1, fixed, analogy},
    {fall, bit, "ED", "ED", {}, 1, fixed, analogy},
    {assign, bit, "=", "=", {Kind::place_bit}, 2, of_bit, offsets},
    {set, bit, "S", "S", {Kind::place_bit, Kind::count}, 7, fixed, offsets},
    {reset, bit, "R", "R", {Kind::reset_bit, Kind::count}, 7, fixed, offsets},
    // Comparisons; those of words and double words as those of bytes.
    {load_compare, byte, "LDB", "LDB", {Kind::value, Kind::value}, 2, of_words, analogy},
    {load_compare, word, "LDW", "LDW", {Kind::value, Kind::value}, 2, of_words, analogy},
    {load_compare, dword, "LDD", "LDD", {Kind::value, Kind::value}, 2, of_words, analogy},
    {and_compare, byte, "UB", "AB", {Kind::value, Kind::value}, 2, of_words, offsets},
    {and_compare, word, "UW", "AW", {Kind::value, Kind::value}, 2, of_words, analogy},
    {and_compare, dword, "UD", "AD", {Kind::value, Kind::value}, 2, of_words, analogy},
    {or_compare, byte, "OB", "OB", {Kind::value, Kind::value}, 2, of_words, analogy},
    {or_compare, word, "OW", "OW", {Kind::value, Kind::value}, 2, of_words, analogy},
    {or_compare, dword, "OD", "OD", {Kind::value, Kind::value}, 2, of_words, analogy},
    // Work on bytes, words and double words.
    {move, byte, "MOVB", "MOVB", {Kind::value, Kind::place}, 2, of_words, offsets},
    {move, word, "MOVW", "MOVW", {Kind::value, Kind::place}, 2, of_words, offsets},
    {move, dword, "MOVD", "MOVD", {Kind::value, Kind::place}, 2, of_words, offsets},
    {block_move, byte, "BMB", "BMB", {Kind::place, Kind::place, Kind::count}, 10, fixed, analogy},
    {block_move, word, "BMW", "BMW", {Kind::place, Kind::place, Kind::count}, 10, fixed, offsets},
    {fill, word, "FILL", "FILL", {Kind::value, Kind::place, Kind::count}, 10, fixed, offsets},
    {invert, byte, "INVB", "INVB", {Kind::place}, 2, of_words, analogy},
    {invert, word, "INVW", "INVW", {Kind::place}, 2, of_words, offsets},
    {invert, dword, "INVD", "INVD", {Kind::place}, 2, of_words, offsets},
    {and_words, byte, "UNDB", "ANDB", {Kind::value, Kind::place}, 2, of_words, analogy},
    {and_words, word, "UNDW", "ANDW", {Kind::value, Kind::place}, 2, of_words, offsets},
    {and_words, dword, "UNDD", "ANDD", {Kind::value, Kind::place}, 2, of_words, offsets},
    {or_words, byte, "ORB", "ORB", {Kind::value, Kind::place}, 2, of_words, analogy},
    {or_words, word, "ORW", "ORW", {Kind::value, Kind::place}, 2, of_words, offsets},
    {or_words, dword, "ORD", "ORD", {Kind::value, Kind::place}, 2, of_words, offsets},
    {xor_words, byte, "XORB", "XORB", {Kind::value, Kind::place}, 2, of_words, analogy},
    {xor_words, word, "XORW", "XORW", {Kind::value, Kind::place}, 2, of_words, analogy},
    {xor_words, dword, "XORD", "XORD", {Kind::value, Kind::place}, 2, of_words, analogy},
    {add, word, "+I", "+I", {Kind::value, Kind::place}, 2, of_words, analogy},
    {add, dword, "+D", "+D", {Kind::value, Kind::place}, 2, of_words, analogy},
    {subtract, word, "-I", "-I", {Kind::value, Kind::place}, 2, of_words, analogy},
    {subtract, dword, "-D", "-D", {Kind::value, Kind::place}, 2, of_words, analogy},
    {increment, byte, "INCB", "INCB", {Kind::place}, 2, of_words, analogy},
    {increment, word, "INCW", "INCW", {Kind::place}, 2, of_words, analogy},
    {increment, dword, "INCD", "INCD", {Kind::place}, 2, of_words, analogy},
    {decrement, byte, "DECB", "DECB", {Kind::place}, 2, of_words, analogy},
    {decrement, word, "DECW", "DECW", {Kind::place}, 2, of_words, analogy},
    {decrement, dword, "DECD", "DECD", {Kind::place}, 2, of_words, analogy},
    // Timers and counters.
    {on_delay, bit, "TON", "TON", {Kind::timer, Kind::preset}, 6, fixed, offsets},
    {retentive_on_delay, bit, "TONR", "TONR", {Kind::timer, Kind::preset}, 6, fixed, analogy},
    {count_up, bit, "CTU", "CTU", {Kind::counter, Kind::preset}, 6, fixed, analogy},  // as TON
    {count_up_down, bit, "CTUD", "CTUD", {Kind::counter, Kind::preset}, 6, fixed, analogy},
    // Program control.
    {call, bit, "CALL", "CALL", {Kind::subroutine}, 3, fixed, offsets},
    {subroutine, bit, "SBR", "SBR", {Kind::subroutine}, 3, fixed, offsets},
    {return_, bit, "RET", "RET", {}, 1, fixed, offsets},
    {conditional_return, bit, "CRET", "CRET", {}, 1, fixed, offsets},
    {jump, bit, "JMP", "JMP", {Kind::label}, 3, fixed, offsets},
    {label, bit, "LBL", "LBL", {Kind::label}, 3, fixed, offsets},
    {end, bit, "END", "END", {}, 1, fixed, analogy},  // as MEND
    {main_end, bit, "MEND", "MEND", {}, 1, fixed, offsets},
    {no_operation, bit, "NOP", "NOP", {Kind::number}, 2, fixed, offsets},
};

constexpr std::string_view relations[] = {"=", "<>", "<", "<=", ">", ">="};

/// Every mnemonic with what it names, in the order of the table.
struct Names {
    Names() {
        for (const InstructionRow& row : table) {
            for (const std::string_view stem : {row.simatic, row.international}) {
                if (!row.is_comparison()) {
                    add(std::string(stem), {&row, Compare::equal});
                    continue;
                }
                for (std::size_t r = 0; r < std::size(relations); ++r) {
                    add(std::string(stem) + std::string(relations[r]),
                        {&row, static_cast<Compare>(r)});
                }
            }
        }
        for (const std::string& name : order) views.push_back(name);
    }
    void add(std::string name, NamedInstruction instruction) {
        if (by_name.emplace(name, instruction).second) order.push_back(std::move(name));
    }
    std::unordered_map<std::string, NamedInstruction> by_name;
    std::vector<std::string> order;
    std::vector<std::string_view> views;
};

const Names& names() {
    static const Names all;
    return all;
}

std::uint32_t size_of_word_operand(const Operand& operand, Width width) {
    if (operand.area != Area::constant) return 2;
    return width == Width::byte ? 1 : width == Width::word ? 2 : 4;
}

}  // namespace

std::size_t InstructionRow::operand_count() const {
    std::size_t count = 0;
    while (count < operands.size() && operands[count] != OperandKind::none) ++count;
    return count;
}

std::span<const InstructionRow> instruction_set() {
    return table;
}

const InstructionRow* row_of(Operation operation, Width width) {
    for (const InstructionRow& row : table) {
        if (row.operation == operation && row.width == width) return &row;
    }
    return nullptr;
}

std::optional<NamedInstruction> instruction_named(std::string_view mnemonic) {
    const auto found = names().by_name.find(std::string(mnemonic));
    if (found == names().by_name.end()) return std::nullopt;
    return found->second;
}

std::span<const std::string_view> mnemonic_names() {
    return names().views;
}

std::string_view relation_sign(Compare compare) {
    return relations[static_cast<std::size_t>(compare)];
}

std::string mnemonic_of(const Instruction& instruction, Mnemonics mnemonics) {
    const InstructionRow* row = row_of(instruction.operation, instruction.width);
    if (row == nullptr) return {};
    std::string text(mnemonics == Mnemonics::simatic ? row->simatic : row->international);
    if (row->is_comparison()) text += relation_sign(instruction.compare);
    return text;
}

std::uint32_t size_of(const Instruction& instruction) {
    const InstructionRow* row = row_of(instruction.operation, instruction.width);
    if (row == nullptr) return 0;
    std::uint32_t size = row->size;
    if (row->rule == of_bit && !instruction.operands.empty() &&
        instruction.operands[0].area == Area::variable) {
        ++size;
    }
    if (row->rule == of_words) {
        for (const Operand& operand : instruction.operands) {
            size += size_of_word_operand(operand, row->width);
        }
    }
    return size;
}

std::uint32_t size_of(const Listing& listing) {
    std::uint32_t size = 0;
    for (const Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) size += size_of(instruction);
    }
    return size;
}

std::vector<OffsetDeviation> offset_deviations(const Listing& listing) {
    std::vector<OffsetDeviation> deviations;
    std::uint32_t next = 0;
    for (const Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) {
            const std::uint32_t printed = instruction.printed_offset;
            if (printed != Instruction::no_offset) {
                if (printed != next) {
                    deviations.push_back({network.number, printed, next, instruction.where});
                }
                next = printed;
            }
            next += size_of(instruction);
        }
    }
    return deviations;
}

void set_offsets(Listing& listing) {
    std::uint32_t next = 0;
    for (Network& network : listing.networks) {
        for (Instruction& instruction : network.instructions) {
            instruction.printed_offset = next;
            next += size_of(instruction);
        }
    }
}

}  // namespace grafwire::s7
