// Conditions and sums with the operators of a language, read from a table of spellings.
//
// Parentheses stand round every compound operand, and round comparisons where a language needs
// them: in Pascal `a and b < c` means `(a and b) < c`. `a ⊕ /b` gets them round the negation as
// well, since `!b` beside `^` reads like a mistake. Two sides of a comparison that are the same
// sum, `n < n`, are settled here: compilers warn of them.

#include "plc/shared/condition_text.h"

#include <fmt/format.h>

namespace grafwire {

namespace {

using Kind = Condition::Kind;

/// Both sides are the same sum: compilers take that for a mistake of the author.
bool is_settled(const Condition& condition) {
    return condition.kind == Kind::comparison &&
           condition.comparison.left == condition.comparison.right;
}

bool holds_of_equals(Relation relation) {
    return relation == Relation::equal || relation == Relation::less_equal ||
           relation == Relation::greater_equal;
}

}  // namespace

std::string ConditionText::operand(const Condition& condition, Kind within) const {
    bool parentheses = false;
    switch (condition.kind) {
        case Kind::constant:
        case Kind::bit:
            break;
        case Kind::conjunction:
        case Kind::disjunction:
        case Kind::exclusive_or:
            parentheses = true;
            break;
        case Kind::negation:
            parentheses = within == Kind::exclusive_or;
            break;
        case Kind::comparison:
            parentheses = !is_settled(condition) &&
                          (spelling_.relations_bind_weakest || within == Kind::exclusive_or ||
                           within == Kind::negation);
            break;
    }
    const std::string text = of(condition);
    return parentheses ? "(" + text + ")" : text;
}

std::string ConditionText::of(const Condition& condition) const {
    std::string_view between;
    switch (condition.kind) {
        case Kind::constant:
            return std::string(condition.value ? spelling_.one : spelling_.zero);
        case Kind::bit:
            return name_(condition.bit);
        case Kind::negation:
            return std::string(spelling_.negation) +
                   operand(condition.operands.front(), Kind::negation);
        case Kind::comparison: {
            const Comparison& comparison = condition.comparison;
            if (is_settled(condition)) {
                return std::string(holds_of_equals(comparison.relation) ? spelling_.one
                                                                        : spelling_.zero);
            }
            return fmt::format("{} {} {}", of(comparison.left),
                               spelling_.relations[static_cast<std::size_t>(comparison.relation)],
                               of(comparison.right));
        }
        case Kind::conjunction:
            between = spelling_.conjunction;
            break;
        case Kind::disjunction:
            between = spelling_.disjunction;
            break;
        case Kind::exclusive_or:
            between = spelling_.exclusive_or;
            break;
    }
    std::string text;
    for (const Condition& part : condition.operands) {
        if (!text.empty()) text += between;
        text += operand(part, condition.kind);
    }
    return text;
}

std::string ConditionText::of(const Sum& sum) const {
    std::string text;
    for (const SumTerm& term : sum) {
        const bool first = text.empty();
        if (first) {
            if (term.negative) text = "-";
        } else {
            text += term.negative ? " - " : " + ";
        }
        if (term.counter != SumTerm::no_counter) {
            text += counter_({false, term.counter});
        } else if (first && sum.size() > 1) {
            // Counters are as wide as every sum; a number alone may be an int of 16 bits.
            text += fmt::format("{}{}{}", spelling_.before_first_number, term.value,
                                spelling_.after_first_number);
        } else {
            text += fmt::format("{}", term.value);
        }
    }
    return text;
}

}  // namespace grafwire
