#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "program/program.h"

namespace grafwire {

/// How a language spells conditions and sums.
struct ConditionSpelling {
    std::string_view negation;  ///< before its operand, with a blank where it needs one
    std::string_view conjunction, disjunction, exclusive_or;  ///< between operands, with blanks
    std::string_view one, zero;
    std::array<std::string_view, 6> relations;  ///< in the order of Relation
    /// Comparisons bind weaker than all other operators (Pascal), not stronger than AND and OR.
    bool relations_bind_weakest = false;
    /// Around the number that begins a sum, so that the sum is worked out in integers wide enough:
    /// `INT64_C(`, `)`.
    std::string_view before_first_number, after_first_number;
};

/// Writes conditions in a language. Operands that are compound stand in parentheses whatever the
/// precedence: readers need not know whether AND binds stronger than exclusive OR.
class ConditionText {
  public:
    /// `name` and `counter` give an operand that needs no parentheses.
    ConditionText(const ConditionSpelling& spelling, std::function<std::string(Bit)> name,
                  std::function<std::string(IntegerCell)> counter)
        : spelling_(spelling), name_(std::move(name)), counter_(std::move(counter)) {}

    std::string of(const Condition& condition) const;
    std::string of(const Sum& sum) const;

  private:
    std::string operand(const Condition& condition, Condition::Kind within) const;

    ConditionSpelling spelling_;
    std::function<std::string(Bit)> name_;
    std::function<std::string(IntegerCell)> counter_;
};

}  // namespace grafwire
