// Conditions as contacts. Negations are pushed down to the contacts, because a contact can be
// negated and a branch cannot; an exclusive or of two contacts is drawn as two branches. A
// comparison gets a rung of its own that keeps its result in a bit: within a rung the box would
// hang on the power before it, and IEC 61131-3 leaves open what its output is while EN is 0.

#include "ladder/rung_writer.h"

#include <algorithm>
#include <cstdint>

#include "grafcet/grafcet.h"
#include "ladder/messages.h"
#include "program/messages.h"

namespace grafwire::ladder {

namespace {

bool is_contact(const Condition& condition) {
    return condition.kind == Condition::Kind::bit ||
           (condition.kind == Condition::Kind::negation && is_contact(condition.operands.front()));
}

bool is_single_counter(const Sum& sum) {
    return sum.size() == 1 && sum[0].counter != SumTerm::no_counter && !sum[0].negative;
}

bool is_number(const Sum& sum) {
    return sum.size() == 1 && sum[0].counter == SumTerm::no_counter;
}

Purpose part_of(const Purpose& purpose) {
    return {messages::ladder::part_of(purpose.comment), purpose.origin};
}

}  // namespace

void RungWriter::add(Rung rung, const Purpose& purpose) {
    rung.number = static_cast<std::uint32_t>(ladder_.rungs.size() + 1);
    rung.comment = purpose.comment.in(language_);
    rung.origin = purpose.origin;
    ladder_.rungs.push_back(std::move(rung));
}

void RungWriter::add(Power power, CoilKind kind, const std::vector<Bit>& targets,
                     const Purpose& purpose) {
    Rung rung;
    rung.power = std::move(power);
    for (const Bit bit : targets) rung.coils.push_back({kind, variables_[bit]});
    add(std::move(rung), purpose);
}

Power RungWriter::power(const Condition& condition, const Purpose& purpose, bool positive) {
    std::vector<Power> parts;
    switch (condition.kind) {
        case Condition::Kind::constant:
            return {};  // the callers draw no rung for a constant 0
        case Condition::Kind::bit:
            return contact(variables_[condition.bit],
                           positive ? ContactKind::normal : ContactKind::negated);
        case Condition::Kind::negation:
            return power(condition.operands.front(), purpose, !positive);
        case Condition::Kind::comparison: {
            const Condition bit = worked_out(comparison(condition.comparison, purpose), purpose);
            return power(bit, purpose, positive);
        }
        case Condition::Kind::exclusive_or:
            return exclusive_or(condition, purpose, positive);
        case Condition::Kind::conjunction:
        case Condition::Kind::disjunction:
            break;
    }
    for (const Condition& operand : condition.operands)
        parts.push_back(power(operand, purpose, positive));
    const bool in_series = (condition.kind == Condition::Kind::conjunction) == positive;
    return in_series ? series(std::move(parts)) : parallel(std::move(parts));
}

Power RungWriter::exclusive_or(const Condition& condition, const Purpose& purpose, bool positive) {
    std::vector<Condition> operands;
    for (const Condition& operand : condition.operands) {
        operands.push_back(is_contact(operand) ? operand
                                               : worked_out(power(operand, purpose), purpose));
    }
    const auto of_two = [&](const Condition& a, const Condition& b, bool odd) {
        std::vector<Power> upper;
        upper.push_back(power(a, purpose));
        upper.push_back(power(b, purpose, !odd));
        std::vector<Power> lower;
        lower.push_back(power(a, purpose, false));
        lower.push_back(power(b, purpose, odd));
        std::vector<Power> both;
        both.push_back(series(std::move(upper)));
        both.push_back(series(std::move(lower)));
        return parallel(std::move(both));
    };
    Condition so_far = operands.front();
    for (std::size_t i = 1; i + 1 < operands.size(); ++i) {
        so_far = worked_out(of_two(so_far, operands[i], true), purpose);
    }
    return of_two(so_far, operands.back(), positive);
}

/// A bit that has the value of `power` from here on in this scan.
Condition RungWriter::worked_out(Power power, const Purpose& purpose) {
    const Bit bit = variables_.new_work_bit();
    add(std::move(power), CoilKind::normal, {bit}, part_of(purpose));
    return bit_condition(bit);
}

Power RungWriter::comparison(const Comparison& comparison, const Purpose& purpose) {
    Power power;
    power.kind = Power::Kind::comparison;
    power.relation = comparison.relation;
    power.left = value_of(comparison.left, purpose);
    power.right = value_of(comparison.right, purpose);
    return power;
}

Operand RungWriter::value_of(const Sum& sum, const Purpose& purpose) {
    check_range(sum, purpose.origin);
    Operand operand;
    if (is_number(sum)) {
        operand.value = sum[0].negative ? -sum[0].value : sum[0].value;
        return operand;
    }
    operand.kind = Operand::Kind::variable;
    if (is_single_counter(sum)) {
        operand.variable = variables_[IntegerCell{false, sum[0].counter}];
        return operand;
    }
    operand.variable = variables_.new_integer();
    Rung rung;
    add_up(sum, operand.variable, purpose.origin, rung.blocks);
    add(std::move(rung), part_of(purpose));
    return operand;
}

void RungWriter::check_range(const Sum& sum, Location origin) {
    if (const auto range = range_of(grafcet_, sum)) {
        variables_.widen(range->low, range->high);
        return;
    }
    diagnostics_.error(code::unsupported_by_language, origin, messages::ladder::sum_too_wide());
}

void RungWriter::add_up(const Sum& sum, VariableId target, Location origin,
                        std::vector<Block>& blocks) {
    check_range(sum, origin);
    const auto term_operand = [&](const SumTerm& term, bool negated) {
        Operand operand;
        if (term.counter != SumTerm::no_counter) {
            operand.kind = Operand::Kind::variable;
            operand.variable = variables_[IntegerCell{false, term.counter}];
        } else {
            operand.value = negated ? -term.value : term.value;
        }
        return operand;
    };
    const auto add_block = [&](BlockType type, std::vector<Operand> operands) {
        blocks.push_back({type, target, std::move(operands)});
    };
    Operand so_far;
    so_far.kind = Operand::Kind::variable;
    so_far.variable = target;
    const bool starts_with_number = sum[0].counter == SumTerm::no_counter;
    std::size_t next = 1;
    if (starts_with_number || !sum[0].negative) {
        const Operand first = term_operand(sum[0], sum[0].negative);
        if (sum.size() == 1) {
            add_block(BlockType::move, {first});
            return;
        }
        add_block(sum[1].negative ? BlockType::subtract : BlockType::add,
                  {first, term_operand(sum[1], false)});
        next = 2;
    } else {
        add_block(BlockType::subtract, {Operand{}, term_operand(sum[0], false)});
    }
    for (; next < sum.size(); ++next) {
        add_block(sum[next].negative ? BlockType::subtract : BlockType::add,
                  {so_far, term_operand(sum[next], false)});
    }
}

}  // namespace grafwire::ladder
