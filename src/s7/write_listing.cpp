#include "s7/write_listing.h"

#include <fmt/format.h>

#include "s7/addresses/operand.h"
#include "s7/instruction_set.h"

namespace grafwire::s7 {

namespace {

/// Whether a constant says more in hexadecimal: a mask, which is what bits are combined with, or
/// all ones.
bool reads_better_in_hex(const Instruction& instruction, const Operand& operand) {
    if (operand.area != Area::constant) return false;
    switch (instruction.operation) {
        case Operation::and_words:
        case Operation::or_words:
        case Operation::xor_words:
            return operand.address > 9 || operand.address < 0;
        case Operation::fill:
        case Operation::move:
            return operand.address == 0xFF || operand.address == 0xFFFF;
        default:
            return false;
    }
}

void trim_end(std::string& text) {
    text.erase(text.find_last_not_of(' ') + 1);
}

void add_comment(std::string& out, const std::string& comment) {
    if (!comment.empty()) out += " // " + comment;
    out += '\n';
}

}  // namespace

std::string write_instruction(const Instruction& instruction, Mnemonics mnemonics) {
    std::string text = fmt::format("{:<6}", mnemonic_of(instruction, mnemonics));
    const std::size_t count = instruction.operands.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Operand& operand = instruction.operands[i];
        const bool in_hex = i == 0 && reads_better_in_hex(instruction, operand);
        text += fmt::format("{:<8}", write_operand(operand, mnemonics, in_hex));
        if (text.back() != ' ') text += ' ';
    }
    if (!instruction.comment.empty()) return text + "  // " + instruction.comment;
    trim_end(text);
    return text;
}

std::string write_listing(const Listing& listing, const WritingOptions& options) {
    std::string out;
    for (const std::string& line : listing.head) {
        out += line.empty() ? "//\n" : "// " + line + '\n';
    }
    std::uint32_t offset = 0;
    for (const Network& network : listing.networks) {
        const auto& instructions = network.instructions;
        const bool begins_block =
            !instructions.empty() && instructions[0].operation == Operation::subroutine;
        if (!out.empty() && (begins_block || &network == &listing.networks[0])) out += '\n';
        out += fmt::format("NETWORK{}", network.number);
        add_comment(out, network.comment);
        for (const Instruction& instruction : instructions) {
            out += options.offsets ? fmt::format("{:>5} ", offset) : std::string(6, ' ');
            out += write_instruction(instruction, options.mnemonics) + '\n';
            offset += size_of(instruction);
        }
    }
    return out;
}

}  // namespace grafwire::s7
