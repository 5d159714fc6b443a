#include "plc/pl7/pl7_rungs.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "grafcet/relations.h"

namespace grafwire {

namespace {

Condition on_contacts(const Condition& condition, bool negated);

/// a ⊕ b as a./b + /a.b, from the left.
Condition exclusive_or_on_contacts(const Condition& condition, bool negated) {
    Condition left = condition.operands.front();
    for (std::size_t i = 1; i < condition.operands.size(); ++i) {
        const Condition& right = condition.operands[i];
        const bool last = i + 1 == condition.operands.size();
        const bool right_first = last && negated;
        std::vector<Condition> branches;
        branches.push_back(
            and_condition({on_contacts(left, false), on_contacts(right, !right_first)}));
        branches.push_back(
            and_condition({on_contacts(left, true), on_contacts(right, right_first)}));
        left = or_condition(std::move(branches));
    }
    return left;
}

/// An equal condition in which only bits are negated, and no exclusive OR occurs.
Condition on_contacts(const Condition& condition, bool negated) {
    switch (condition.kind) {
        case Condition::Kind::constant:
            return constant_condition(condition.value != negated);
        case Condition::Kind::bit:
            if (condition.bit.kind == BitKind::pulse) {
                const std::uint32_t step = condition.bit.index;
                return on_contacts(
                    and_condition({bit_condition({BitKind::step, step}),
                                   not_condition(bit_condition({BitKind::previous, step}))}),
                    negated);
            }
            return negated ? not_condition(condition) : condition;
        case Condition::Kind::negation:
            return on_contacts(condition.operands.front(), !negated);
        case Condition::Kind::comparison: {
            Condition same = condition;
            if (negated) same.comparison.relation = complement(same.comparison.relation);
            return same;
        }
        case Condition::Kind::exclusive_or:
            return exclusive_or_on_contacts(condition, negated);
        case Condition::Kind::conjunction:
        case Condition::Kind::disjunction:
            break;
    }
    std::vector<Condition> operands;
    for (const Condition& operand : condition.operands) {
        operands.push_back(on_contacts(operand, negated));
    }
    const bool series = (condition.kind == Condition::Kind::conjunction) != negated;
    return series ? and_condition(std::move(operands)) : or_condition(std::move(operands));
}

}  // namespace

void Pl7Rungs::label(std::string_view comment) {
    text_ += fmt::format("\n** LABEL {:<4} {}\n", ++labels_, comment);
}

void Pl7Rungs::line(std::string_view contacts, std::string_view coil) {
    text_ += fmt::format("   {} --{}\n", contacts, coil);
}

std::string Pl7Rungs::contacts(const Condition& condition) {
    return series_or_parallel(on_contacts(condition, false), false);
}

std::string Pl7Rungs::series_or_parallel(const Condition& condition, bool in_series) {
    switch (condition.kind) {
        case Condition::Kind::constant:
            return condition.value ? "=1" : "=0";
        case Condition::Kind::bit:
            return objects_.of(condition.bit);
        case Condition::Kind::negation:
            return "/" + objects_.of(condition.operands.front().bit);
        case Condition::Kind::comparison:
            return compare(condition.comparison);
        default:
            break;
    }
    const bool series = condition.kind == Condition::Kind::conjunction;
    std::string joined;
    for (const Condition& operand : condition.operands) {
        if (!joined.empty()) joined += series ? " . " : " + ";
        joined += series_or_parallel(operand, series);
    }
    return in_series && !series ? "(" + joined + ")" : joined;
}

std::string Pl7Rungs::compare(const Comparison& comparison) {
    const std::string left = value(comparison.left);
    const std::string right = value(comparison.right);
    return fmt::format("[{} {} {}]", left, text_of(comparison.relation), right);
}

bool Pl7Rungs::has_sums(const Condition& condition) {
    const auto is_operand = [](const Sum& sum) {
        return sum.size() == 1 &&
               !(sum.front().negative && sum.front().counter != SumTerm::no_counter);
    };
    if (condition.kind == Condition::Kind::comparison) {
        return !is_operand(condition.comparison.left) || !is_operand(condition.comparison.right);
    }
    return std::any_of(condition.operands.begin(), condition.operands.end(), has_sums);
}

/// Term by term; a chain of sums uses one word.
std::string Pl7Rungs::value(const Sum& sum) {
    const auto term_text = [&](const SumTerm& term) {
        return term.counter == SumTerm::no_counter ? fmt::format("{}", term.value)
                                                   : objects_.of(IntegerCell{false, term.counter});
    };
    const SumTerm& first = sum.front();
    std::string so_far = term_text(first);
    std::string word;
    const auto add = [&](const std::string& left, const SumTerm& term) {
        if (word.empty()) word = new_temporary();
        line("=1", fmt::format("[{} {} {} -> {}]", left, term.negative ? '-' : '+', term_text(term),
                               word));
        so_far = word;
    };
    if (first.negative && first.counter == SumTerm::no_counter) {
        so_far = fmt::format("{}", -first.value);
    } else if (first.negative) {
        add("0", first);
    }
    for (const SumTerm& term : std::span(sum).subspan(1)) add(so_far, term);
    return so_far;
}

std::string Pl7Rungs::new_temporary() {
    return *temporaries_.insert(objects_.new_word()).first;
}

std::string Pl7Rungs::limited(const std::string& value, std::optional<std::int64_t> low,
                              std::optional<std::int64_t> high) {
    if (!low && !high) return value;
    std::string word = value;
    if (temporaries_.count(value) == 0) {
        word = new_temporary();
        line("=1", fmt::format("[{} -> {}]", value, word));
    }
    if (low) line(fmt::format("[{} < {}]", word, *low), fmt::format("[{} -> {}]", *low, word));
    if (high) line(fmt::format("[{} > {}]", word, *high), fmt::format("[{} -> {}]", *high, word));
    return word;
}

}  // namespace grafwire
