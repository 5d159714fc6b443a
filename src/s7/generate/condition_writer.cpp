// Conditions as instruction lists.
//
// AND and OR are written as the document writes them: LD of the first operand, U or O for every
// further bit, and LD … ULD or OLD where an operand is itself an AND or OR. That is how one reads a
// ladder network aloud, and it needs no brackets. What the stack cannot do goes into a network
// before: an exclusive or (its operands are wanted twice), a comparison of sums (a sum needs the
// accumulator), and what would need more than the nine levels of the stack.

#include "s7/generate/condition_writer.h"

#include <algorithm>
#include <utility>

#include "grafcet/expression.h"
#include "s7/generate/messages.h"
#include "s7/listing.h"
#include "s7/make_instruction.h"

namespace grafwire::s7 {

namespace {

// The controllers compare with =, >= and <= only; <>, < and > are the complements of these.

constexpr bool is_complement(Relation relation) {
    return relation == Relation::not_equal || relation == Relation::less ||
           relation == Relation::greater;
}

/// Of a relation that is no complement.
constexpr Compare compare_of(Relation relation) {
    if (relation == Relation::equal) return Compare::equal;
    return relation == Relation::less_equal ? Compare::less_equal : Compare::greater_equal;
}

using Kind = Condition::Kind;

/// One less than the stack has: the network before may have left its result below.
constexpr std::size_t stack_levels = 8;

bool is_literal(const Condition& condition) {
    return condition.kind == Kind::bit ||
           (condition.kind == Kind::negation && condition.operands[0].kind == Kind::bit);
}

bool is_constant(const Sum& sum) {
    return sum.size() == 1 && sum[0].counter == SumTerm::no_counter;
}

/// Whether load() writes the operand with U or O alone.
bool is_direct(const Condition& condition) {
    if (condition.kind == Kind::comparison) return !is_complement(condition.comparison.relation);
    return is_literal(condition);
}

/// The levels of the stack that load() takes.
std::size_t levels_of(const Condition& condition) {
    if (condition.kind == Kind::negation) return levels_of(condition.operands[0]);
    std::size_t levels = 1;
    for (std::size_t i = 0; i < condition.operands.size(); ++i) {
        const Condition& operand = condition.operands[i];
        if (i == 0) {
            levels = std::max(levels, levels_of(operand));
        } else if (!is_direct(operand)) {
            levels = std::max(levels, 1 + levels_of(operand));
        }
    }
    return levels;
}

/// a ⊕ b of two literals, with a and b each written twice.
Condition either_or(const Condition& a, const Condition& b) {
    std::vector<Condition> only_a;
    only_a.push_back(a);
    only_a.push_back(not_condition(b));
    std::vector<Condition> only_b;
    only_b.push_back(not_condition(a));
    only_b.push_back(b);
    std::vector<Condition> cases;
    cases.push_back(and_condition(std::move(only_a)));
    cases.push_back(and_condition(std::move(only_b)));
    return or_condition(std::move(cases));
}

}  // namespace

std::int64_t constant_of(const SumTerm& term) {
    return term.negative ? -term.value : term.value;
}

bool is_operand(const Sum& sum) {
    return is_constant(sum) || (sum.size() == 1 && !sum[0].negative);
}

namespace {

namespace say = messages::s7_generate;

/// Brings one condition into a form that load() can write.
class Lowering {
  public:
    Lowering(const ConditionWriter& writer, Addresses& addresses, NetworkList& networks,
             const Localized& comment)
        : writer_(writer), addresses_(addresses), networks_(networks), comment_(comment) {}

    Condition lower(const Condition& condition);

  private:
    Condition lower_exclusive_or(const Condition& condition);
    Condition lower_comparison(const Comparison& comparison);
    /// A network that keeps the value of a lowered condition in a working bit.
    Condition keep(const Condition& condition);
    Condition new_working_bit();

    const ConditionWriter& writer_;
    Addresses& addresses_;
    NetworkList& networks_;
    const Localized& comment_;
    std::uint32_t working_bits_ = 0;
};

Condition Lowering::lower(const Condition& condition) {
    switch (condition.kind) {
        case Kind::constant:
        case Kind::bit:
            return condition;
        case Kind::comparison:
            return lower_comparison(condition.comparison);
        case Kind::exclusive_or:
            return lower_exclusive_or(condition);
        case Kind::negation: {
            const Condition& operand = condition.operands[0];
            if (operand.kind != Kind::comparison) return not_condition(lower(operand));
            Comparison opposite = operand.comparison;
            opposite.relation = complement(opposite.relation);
            return lower_comparison(opposite);
        }
        case Kind::conjunction:
        case Kind::disjunction:
            break;
    }
    std::vector<Condition> operands;
    for (const Condition& written : condition.operands) {
        Condition operand = lower(written);
        const bool is_first = operands.empty();
        if (!is_first && levels_of(operand) + 1 > stack_levels) operand = keep(operand);
        operands.push_back(std::move(operand));
    }
    return condition.kind == Kind::conjunction ? and_condition(std::move(operands))
                                               : or_condition(std::move(operands));
}

/// Two operands at a time; of three or more, what is known so far waits in a working bit.
Condition Lowering::lower_exclusive_or(const Condition& condition) {
    bool complemented = false;
    std::vector<Condition> literals;
    for (const Condition& written : condition.operands) {
        Condition operand = lower(written);
        if (operand.kind == Kind::constant) {
            complemented ^= operand.value;
        } else {
            literals.push_back(is_literal(operand) ? std::move(operand) : keep(operand));
        }
    }
    Condition result = constant_condition(false);
    for (std::size_t i = 0; i < literals.size(); ++i) {
        if (i == 0) {
            result = literals[0];
            continue;
        }
        if (!is_literal(result)) result = keep(result);
        result = either_or(result, literals[i]);
    }
    return complemented ? not_condition(std::move(result)) : result;
}

Condition Lowering::lower_comparison(const Comparison& comparison) {
    Condition result;
    result.kind = Kind::comparison;
    result.comparison = comparison;
    Comparison& sides = result.comparison;
    if (is_constant(sides.left) && is_constant(sides.right)) {
        return constant_condition(
            holds(constant_of(sides.left[0]), sides.relation, constant_of(sides.right[0])));
    }
    if (is_constant(sides.left)) {
        std::swap(sides.left, sides.right);
        sides.relation = mirrored(sides.relation);
    }
    if (is_operand(sides.left) && is_operand(sides.right)) return result;

    std::vector<Operand> operands;
    std::vector<Instruction> sums{make(Operation::load, {always_on()})};
    for (const Sum* side : {&sides.left, &sides.right}) {
        if (is_operand(*side)) {
            operands.push_back(writer_.operand_of(*side));
            continue;
        }
        const Operand accumulator = addresses_.accumulator(operands.size());
        for (Instruction& part : writer_.work_out(*side, accumulator))
            sums.push_back(std::move(part));
        operands.push_back(accumulator);
    }
    networks_.add(Part::chart, say::sums_of(comment_), std::move(sums));
    const bool opposite = is_complement(sides.relation);
    const Relation relation = opposite ? complement(sides.relation) : sides.relation;
    Condition bit = new_working_bit();
    networks_.add(Part::chart, say::part_of(comment_),
                  {make_compare(Operation::load_compare, addresses_.width(), compare_of(relation),
                                operands[0], operands[1]),
                   make(Operation::assign, {addresses_[bit.bit]})});
    return opposite ? not_condition(std::move(bit)) : bit;
}

Condition Lowering::new_working_bit() {
    return bit_condition(addresses_.working_bit(working_bits_++));
}

Condition Lowering::keep(const Condition& condition) {
    std::vector<Instruction> instructions = writer_.load(condition);
    Condition bit = new_working_bit();
    instructions.push_back(make(Operation::assign, {addresses_[bit.bit]}));
    networks_.add(Part::chart, say::part_of(comment_), std::move(instructions));
    return bit;
}

}  // namespace

Condition ConditionWriter::prepare(const Condition& condition, const Localized& comment) {
    return Lowering(*this, addresses_, networks_, comment).lower(condition);
}

Operand ConditionWriter::operand_of(const Sum& sum) const {
    if (is_constant(sum)) return constant_operand(constant_of(sum[0]));
    return addresses_[IntegerCell{false, sum[0].counter}];
}

std::vector<Instruction> ConditionWriter::work_out(const Sum& sum, const Operand& target) const {
    const Width width = addresses_.width();
    std::vector<Instruction> instructions;
    const SumTerm& first = sum.front();
    const bool starts_from_0 = first.negative && first.counter != SumTerm::no_counter;
    instructions.push_back(
        make(Operation::move, width,
             {starts_from_0 ? constant_operand(0) : operand_of({first}), target}));
    for (std::size_t i = starts_from_0 ? 0 : 1; i < sum.size(); ++i) {
        SumTerm term = sum[i];
        const Operation operation = term.negative ? Operation::subtract : Operation::add;
        term.negative = false;
        instructions.push_back(make(operation, width, {operand_of({term}), target}));
    }
    return instructions;
}

std::vector<Instruction> ConditionWriter::load(const Condition& condition) const {
    std::vector<Instruction> instructions;
    load(condition, instructions);
    return instructions;
}

void ConditionWriter::load(const Condition& condition, std::vector<Instruction>& out) const {
    switch (condition.kind) {
        case Kind::constant:
            out.push_back(
                make(condition.value ? Operation::load : Operation::load_not, {always_on()}));
            return;
        case Kind::bit:
            out.push_back(make(Operation::load, {addresses_[condition.bit]}));
            return;
        case Kind::negation:
            if (is_literal(condition)) {
                out.push_back(make(Operation::load_not, {addresses_[condition.operands[0].bit]}));
                return;
            }
            load(condition.operands[0], out);
            out.push_back(make(Operation::negate));
            return;
        case Kind::comparison: {
            const Comparison& sides = condition.comparison;
            const bool opposite = is_complement(sides.relation);
            const Relation relation = opposite ? complement(sides.relation) : sides.relation;
            out.push_back(make_compare(Operation::load_compare, addresses_.width(),
                                       compare_of(relation), operand_of(sides.left),
                                       operand_of(sides.right)));
            if (opposite) out.push_back(make(Operation::negate));
            return;
        }
        case Kind::conjunction:
        case Kind::disjunction:
            load(condition.operands[0], out);
            for (std::size_t i = 1; i < condition.operands.size(); ++i) {
                combine(condition.kind, condition.operands[i], out);
            }
            return;
        case Kind::exclusive_or:
            return;  // prepare() leaves none
    }
}

void ConditionWriter::combine(Kind kind, const Condition& operand,
                              std::vector<Instruction>& out) const {
    const bool is_and = kind == Kind::conjunction;
    if (!is_direct(operand)) {
        load(operand, out);
        out.push_back(make(is_and ? Operation::and_load : Operation::or_load));
    } else if (operand.kind == Kind::bit) {
        out.push_back(make(is_and ? Operation::and_ : Operation::or_, {addresses_[operand.bit]}));
    } else if (operand.kind == Kind::negation) {
        out.push_back(make(is_and ? Operation::and_not : Operation::or_not,
                           {addresses_[operand.operands[0].bit]}));
    } else {
        const Comparison& sides = operand.comparison;
        out.push_back(make_compare(is_and ? Operation::and_compare : Operation::or_compare,
                                   addresses_.width(), compare_of(sides.relation),
                                   operand_of(sides.left), operand_of(sides.right)));
    }
}

}  // namespace grafwire::s7
