#pragma once

#include <string>
#include <string_view>

#include "plc/shared/plc_options.h"
#include "plc/step7/stl_memory.h"

namespace grafwire {

/// The lines of a source file in Statement List for STEP 7 (AWL): instructions are given in
/// SIMATIC mnemonics and written in the mnemonics wanted.
class StlText {
  public:
    explicit StlText(s7::Mnemonics mnemonics) : mnemonics_(mnemonics) {}

    /// A line as it stands.
    void line(std::string_view text) { text_ += std::string(text) + "\n"; }
    /// A comment of as many lines as the text has.
    void comment(std::string_view text);
    /// `NETWORK`, with its title, of 64 characters at most.
    void network(std::string_view title);
    void op(std::string_view operation, std::string_view operand = {},
            std::string_view comment = {});
    /// Where a jump leads: `M001: NOP 0;`.
    void label(std::string_view name);

    std::string operand(StlAddress address) const;
    /// The memory word (2 bytes) or double word (4) that begins at a byte.
    static std::string word(std::uint32_t byte, std::uint32_t bytes);

    std::string take() { return std::move(text_); }

  private:
    std::string_view mnemonic(std::string_view simatic) const;

    s7::Mnemonics mnemonics_;
    std::string text_;
};

/// Writes conditions as strings of bit logic that leave their value in the RLO, and sums as
/// arithmetic that leaves theirs in accumulator 1.
///
/// A string of U (AND) is closed by what reads the RLO; an OR of products is written with O alone,
/// "AND before OR"; anything deeper stands in parentheses. The stack of parentheses holds seven
/// entries (S7-300 instruction list), so what lies deeper is worked out beforehand into auxiliary
/// bits.
class StlConditions {
  public:
    StlConditions(StlMemory& memory, StlText& text, std::uint32_t integer_bytes)
        : memory_(memory), text_(text), integer_bytes_(integer_bytes) {}

    void load(const Condition& condition);
    void load(const Sum& sum);
    void load(IntegerCell cell);
    void load_constant(std::int64_t value);
    /// `>I`, `>D`.
    std::string integer_op(std::string_view operation) const {
        return std::string(operation) + (integer_bytes_ == 2 ? "I" : "D");
    }
    std::string word(IntegerCell cell) const {
        return StlText::word(memory_.of(cell), integer_bytes_);
    }

  private:
    /// `auxiliaries` counts the auxiliary bits that the condition has taken so far.
    Condition flattened(const Condition& condition, std::size_t levels, std::uint32_t& auxiliaries);
    Condition worked_out(const Condition& condition, std::uint32_t& auxiliaries);
    void load_flat(const Condition& condition);
    void combine(char operation, const Condition& operand);
    void compare(const Comparison& comparison);
    void add_term(const SumTerm& term);

    StlMemory& memory_;
    StlText& text_;
    std::uint32_t integer_bytes_;
};

}  // namespace grafwire
