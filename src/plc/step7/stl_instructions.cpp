// Instructions of STEP 7 as lines of a source file, and conditions and sums as instructions.
//
// `a . /b + c . (d + e)` becomes U a, UN b, O, U c, U(, O d, O e, ): products before sums need no
// parentheses, everything deeper does. The stack of parentheses has seven entries; a condition that
// is deeper is flattened first, its innermost parts worked out into auxiliary bits of memory.

#include "plc/step7/stl_instructions.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "plc/shared/source_text.h"

namespace grafwire {

namespace {

struct Mnemonic {
    std::string_view simatic;
    std::string_view international;
};

/// Those that differ.
constexpr Mnemonic differing[] = {
    {"U", "A"},      {"UN", "AN"},  {"U(", "A("},  {"UN(", "AN("}, {"UW", "AW"}, {"UD", "AD"},
    {"SPBN", "JCN"}, {"SPB", "JC"}, {"SPA", "JU"}, {"SE", "SD"},   {"SA", "SF"},
};

}  // namespace

std::string_view StlText::mnemonic(std::string_view simatic) const {
    if (mnemonics_ == s7::Mnemonics::simatic) return simatic;
    for (const Mnemonic& row : differing) {
        if (row.simatic == simatic) return row.international;
    }
    return simatic;
}

void StlText::comment(std::string_view text) {
    for (bool goes_on = true; goes_on;) {
        const std::size_t end = text.find('\n');
        const std::string_view one = text.substr(0, end);
        text_ += one.empty() ? "//\n" : fmt::format("// {}\n", comment_text(one));
        goes_on = end != std::string_view::npos;
        if (goes_on) text.remove_prefix(end + 1);
    }
}

void StlText::network(std::string_view title) {
    text_ += fmt::format("\nNETWORK\nTITLE = {}\n", title);
}

void StlText::op(std::string_view operation, std::string_view operand, std::string_view comment) {
    std::string written = operand.empty()
                              ? fmt::format("      {};", mnemonic(operation))
                              : fmt::format("      {:<5} {};", mnemonic(operation), operand);
    if (!comment.empty()) written = fmt::format("{:<28} // {}", written, comment_text(comment));
    text_ += written + "\n";
}

void StlText::label(std::string_view name) {
    text_ += fmt::format("{}: NOP   0;\n", name);
}

std::string StlText::operand(StlAddress address) const {
    char area = address.area;
    if (mnemonics_ == s7::Mnemonics::international && area == 'E') area = 'I';
    if (mnemonics_ == s7::Mnemonics::international && area == 'A') area = 'Q';
    return fmt::format("{} {}.{}", area, address.byte, address.bit);
}

std::string StlText::word(std::uint32_t byte, std::uint32_t bytes) {
    return fmt::format("{} {}", bytes == 2 ? "MW" : "MD", byte);
}

namespace {

constexpr std::size_t stack_entries = 7;

bool is_bit_or_its_negation(const Condition& condition) {
    return condition.kind == Condition::Kind::bit ||
           (condition.kind == Condition::Kind::negation &&
            condition.operands.front().kind == Condition::Kind::bit);
}

bool is_product_of_bits(const Condition& condition) {
    if (condition.kind != Condition::Kind::conjunction) return false;
    for (const Condition& operand : condition.operands) {
        if (!is_bit_or_its_negation(operand)) return false;
    }
    return true;
}

/// How many parentheses are open at a time while it is worked out as the operand of another.
std::size_t depth_as_operand(const Condition& condition) {
    if (is_bit_or_its_negation(condition)) return 0;
    std::size_t depth = 0;
    for (const Condition& operand : condition.operands) {
        depth = std::max(depth, depth_as_operand(operand));
    }
    return condition.kind == Condition::Kind::negation ? std::max<std::size_t>(depth, 1)
                                                       : depth + 1;
}

}  // namespace

void StlConditions::load(const Condition& condition) {
    std::uint32_t auxiliaries = 0;
    load_flat(flattened(condition, stack_entries, auxiliaries));
}

/// The same condition with no more than so many levels of parentheses.
Condition StlConditions::flattened(const Condition& condition, std::size_t levels,
                                   std::uint32_t& auxiliaries) {
    Condition flat = condition;
    for (Condition& operand : flat.operands) {
        if (depth_as_operand(operand) <= levels) continue;
        // A negation shares its level with what it negates.
        const std::size_t inner = operand.kind == Condition::Kind::negation ? levels : levels - 1;
        operand =
            levels <= 1 ? worked_out(operand, auxiliaries) : flattened(operand, inner, auxiliaries);
    }
    return flat;
}

/// An auxiliary bit that has been given the value of a condition.
Condition StlConditions::worked_out(const Condition& condition, std::uint32_t& auxiliaries) {
    load_flat(flattened(condition, stack_entries, auxiliaries));
    const Bit bit = memory_.auxiliary_bit(auxiliaries++);
    text_.op("=", text_.operand(memory_.of(bit)), memory_.symbol(bit));
    return bit_condition(bit);
}

/// The RLO and an operand: `U`, `O` or `X`.
void StlConditions::combine(char operation, const Condition& operand) {
    const bool negated = operand.kind == Condition::Kind::negation;
    const Condition& inner = negated ? operand.operands.front() : operand;
    const std::string written = fmt::format("{}{}", operation, negated ? "N" : "");
    if (inner.kind == Condition::Kind::bit) {
        return text_.op(written, text_.operand(memory_.of(inner.bit)), memory_.symbol(inner.bit));
    }
    text_.op(written + "(");
    load_flat(inner);
    text_.op(")");
}

void StlConditions::load_flat(const Condition& condition) {
    switch (condition.kind) {
        case Condition::Kind::constant:
            return text_.op(condition.value ? "SET" : "CLR");
        case Condition::Kind::bit:
            return combine('U', condition);
        case Condition::Kind::negation:
            if (is_bit_or_its_negation(condition)) return combine('U', condition);
            load_flat(condition.operands.front());
            return text_.op("NOT");
        case Condition::Kind::comparison:
            return compare(condition.comparison);
        case Condition::Kind::conjunction:
            for (const Condition& operand : condition.operands) combine('U', operand);
            return;
        case Condition::Kind::exclusive_or:
            for (const Condition& operand : condition.operands) combine('X', operand);
            return;
        case Condition::Kind::disjunction:
            for (const Condition& operand : condition.operands) {
                if (!is_product_of_bits(operand)) {
                    combine('O', operand);
                    continue;
                }
                if (&operand != &condition.operands.front()) text_.op("O");
                load_flat(operand);
            }
            return;
    }
}

void StlConditions::load_constant(std::int64_t value) {
    text_.op("L", integer_bytes_ == 2 ? fmt::format("{}", value) : fmt::format("L#{}", value));
}

void StlConditions::load(IntegerCell cell) {
    text_.op("L", word(cell), memory_.symbol(cell));
}

void StlConditions::add_term(const SumTerm& term) {
    if (term.counter == SumTerm::no_counter) {
        load_constant(term.value);
    } else {
        load(IntegerCell{false, term.counter});
    }
    text_.op(integer_op(term.negative ? "-" : "+"));
}

void StlConditions::load(const Sum& sum) {
    const SumTerm& first = sum.front();
    std::span<const SumTerm> rest(sum);
    if (first.counter == SumTerm::no_counter) {
        load_constant(first.negative ? -first.value : first.value);
        rest = rest.subspan(1);
    } else if (first.negative) {
        load_constant(0);
    } else {
        load(IntegerCell{false, first.counter});
        rest = rest.subspan(1);
    }
    for (const SumTerm& term : rest) add_term(term);
}

/// Accumulator 2 is compared with accumulator 1. There are but these two, so a sum on the right is
/// worked out first and put aside.
void StlConditions::compare(const Comparison& comparison) {
    static constexpr const char* relations[] = {"==", "<>", "<", "<=", ">", ">="};
    const Sum& right = comparison.right;
    const bool is_counter = right.front().counter != SumTerm::no_counter;
    if (right.size() == 1 && !(is_counter && right.front().negative)) {
        load(comparison.left);
        load(right);
    } else {
        const std::string aside = StlText::word(memory_.auxiliary_integer(), integer_bytes_);
        load(right);
        text_.op("T", aside, memory_.auxiliary_name());
        load(comparison.left);
        text_.op("L", aside, memory_.auxiliary_name());
    }
    text_.op(integer_op(relations[static_cast<std::size_t>(comparison.relation)]));
}

}  // namespace grafwire
