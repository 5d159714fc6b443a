// Conditions as contacts. Negations are pushed down to the contacts, because a contact can be
// negated and a branch cannot; an exclusive or of two contacts is drawn as two branches. A
// comparison gets a rung of its own that keeps its result in a bit: within a rung the box would
// hang on the power before it, and IEC 61131-3 leaves open what its output is while EN is 0.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "ladder/ladder_build.h"

namespace grafwire::ladder {

namespace {

Condition exclusive_or_condition(std::vector<Condition> operands) {
    bool odd = false;
    std::vector<Condition> kept;
    for (Condition& operand : operands) {
        if (operand.kind == Condition::Kind::constant) {
            odd = odd != operand.value;
        } else {
            kept.push_back(std::move(operand));
        }
    }
    Condition result;
    if (kept.empty()) return constant_condition(odd);
    if (kept.size() == 1) {
        result = std::move(kept.front());
    } else {
        result.kind = Condition::Kind::exclusive_or;
        result.operands = std::move(kept);
    }
    return odd ? not_condition(std::move(result)) : result;
}

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

}  // namespace

void collect_reads(const Condition& condition, std::set<Bit>& bits) {
    if (condition.kind == Condition::Kind::bit) bits.insert(condition.bit);
    for (const Condition& operand : condition.operands) collect_reads(operand, bits);
}

/// A condition with the bits that never change replaced by their values. A transition that is
/// cleared had its preceding steps active: where it is a factor, those need not be asked again.
Condition LadderBuild::simplified(const Condition& condition) const {
    std::vector<Condition> operands;
    std::set<Bit> implied;
    if (condition.kind == Condition::Kind::conjunction) {
        for (const Condition& operand : condition.operands) {
            if (operand.kind != Condition::Kind::bit) continue;
            if (operand.bit.kind == BitKind::transition) implied = before_[operand.bit.index];
        }
    }
    for (const Condition& operand : condition.operands) {
        const bool is_implied = operand.kind == Condition::Kind::bit &&
                                operand.bit.kind == BitKind::previous &&
                                implied.count({BitKind::step, operand.bit.index}) > 0;
        if (!is_implied) operands.push_back(simplified(operand));
    }
    switch (condition.kind) {
        case Condition::Kind::bit: {
            const auto constant = constants_.find(condition.bit);
            return constant == constants_.end() ? condition : constant_condition(constant->second);
        }
        case Condition::Kind::negation:
            return not_condition(std::move(operands.front()));
        case Condition::Kind::conjunction:
            return and_condition(std::move(operands));
        case Condition::Kind::disjunction:
            return or_condition(std::move(operands));
        case Condition::Kind::exclusive_or:
            return exclusive_or_condition(std::move(operands));
        default:
            return condition;
    }
}

Power LadderBuild::power(const Condition& condition, bool positive) {
    std::vector<Power> parts;
    switch (condition.kind) {
        case Condition::Kind::constant:
            return {};  // the callers draw no rung for a constant 0
        case Condition::Kind::bit:
            return contact(id_of(condition.bit),
                           positive ? ContactKind::normal : ContactKind::negated);
        case Condition::Kind::negation:
            return power(condition.operands.front(), !positive);
        case Condition::Kind::comparison: {
            const Condition bit = worked_out(comparison(condition.comparison));
            return power(bit, positive);
        }
        case Condition::Kind::exclusive_or:
            return exclusive_or(condition, positive);
        case Condition::Kind::conjunction:
        case Condition::Kind::disjunction:
            break;
    }
    for (const Condition& operand : condition.operands) parts.push_back(power(operand, positive));
    const bool in_series = (condition.kind == Condition::Kind::conjunction) == positive;
    return in_series ? series(std::move(parts)) : parallel(std::move(parts));
}

Power LadderBuild::exclusive_or(const Condition& condition, bool positive) {
    std::vector<Condition> operands;
    for (const Condition& operand : condition.operands) {
        operands.push_back(is_contact(operand) ? operand : worked_out(power(operand)));
    }
    const auto of_two = [&](const Condition& a, const Condition& b, bool odd) {
        std::vector<Power> upper;
        upper.push_back(power(a));
        upper.push_back(power(b, !odd));
        std::vector<Power> lower;
        lower.push_back(power(a, false));
        lower.push_back(power(b, odd));
        std::vector<Power> both;
        both.push_back(series(std::move(upper)));
        both.push_back(series(std::move(lower)));
        return parallel(std::move(both));
    };
    Condition so_far = operands.front();
    for (std::size_t i = 1; i + 1 < operands.size(); ++i) {
        so_far = worked_out(of_two(so_far, operands[i], true));
    }
    return of_two(so_far, operands.back(), positive);
}

/// A bit that has the value of `power` from here on in this scan.
Condition LadderBuild::worked_out(Power power) {
    const Bit bit{BitKind::scratch, next_work_++};
    add_rung(std::move(power), CoilKind::normal, {bit}, "part of " + context_, origin_);
    return bit_condition(bit);
}

Power LadderBuild::comparison(const Comparison& comparison) {
    Power power;
    power.kind = Power::Kind::comparison;
    power.relation = comparison.relation;
    power.left = value_of(comparison.left);
    power.right = value_of(comparison.right);
    return power;
}

Operand LadderBuild::value_of(const Sum& sum) {
    check_range(sum);
    Operand operand;
    if (is_number(sum)) {
        operand.value = sum[0].negative ? -sum[0].value : sum[0].value;
        return operand;
    }
    operand.kind = Operand::Kind::variable;
    if (is_single_counter(sum)) {
        operand.variable = id_of(IntegerCell{false, sum[0].counter});
        return operand;
    }
    operand.variable = new_integer();
    Rung rung;
    add_up(sum, operand.variable, rung.blocks);
    push(std::move(rung), "part of " + context_, origin_);
    return operand;
}

void LadderBuild::note_range(std::int64_t low, std::int64_t high) {
    const auto holds = [&](std::int64_t limit) { return low >= -limit - 1 && high <= limit; };
    const std::uint32_t bits = holds(INT16_MAX) ? 16 : holds(INT32_MAX) ? 32 : 64;
    ladder_.integer_bits = std::max(ladder_.integer_bits, bits);
}

void LadderBuild::check_range(const Sum& sum) {
    if (const auto range = range_of(grafcet_, sum)) {
        note_range(range->low, range->high);
        return;
    }
    diagnostics_.error(Code::unsupported_by_language, origin_,
                       "a sum here can exceed 64 bits, which no ladder diagram holds; use counters "
                       "of smaller ranges");
}

void LadderBuild::add_up(const Sum& sum, VariableId target, std::vector<Block>& blocks) {
    check_range(sum);
    const auto term_operand = [&](const SumTerm& term, bool negated) {
        Operand operand;
        if (term.counter != SumTerm::no_counter) {
            operand.kind = Operand::Kind::variable;
            operand.variable = id_of(IntegerCell{false, term.counter});
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
