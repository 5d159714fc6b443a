#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace grafwire::iec {

// The Boolean operators of Structured Text and how strongly they bind (IEC 61131-3, 2nd edition,
// table 55).

/// From the weakest on. Comparisons stand between AND and NOT; they are written in parentheses, so
/// that readers need not know.
enum class Precedence : std::uint8_t { disjunction, exclusive_or, conjunction, negation, operand };

struct OperatorRow {
    Precedence precedence;
    std::string_view word;  ///< with the blanks around it
};

/// By precedence.
inline constexpr std::array<OperatorRow, 4> operator_table{{
    {Precedence::disjunction, " OR "},
    {Precedence::exclusive_or, " XOR "},
    {Precedence::conjunction, " AND "},
    {Precedence::negation, "NOT "},
}};

constexpr std::string_view word_of(Precedence precedence) {
    return operator_table[static_cast<std::size_t>(precedence)].word;
}

/// In the order of Relation.
inline constexpr std::array<std::string_view, 6> relation_signs{"=", "<>", "<", "<=", ">", ">="};
inline constexpr std::string_view word_true = "TRUE";
inline constexpr std::string_view word_false = "FALSE";

}  // namespace grafwire::iec
