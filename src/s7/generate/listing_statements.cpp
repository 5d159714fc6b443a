// One statement of the program as networks.

#include <algorithm>
#include <array>
#include <utility>

#include "s7/generate/integer_width.h"
#include "s7/generate/listing_build.h"
#include "s7/generate/messages.h"
#include "s7/make_instruction.h"

namespace grafwire::s7 {

namespace say = messages::s7_generate;

void ListingBuild::write(const Statement& statement) {
    switch (statement.kind) {
        case Statement::Kind::assign:
            write_assign(statement);
            break;
        case Statement::Kind::set:
        case Statement::Kind::reset:
            write_set_or_reset(statement);
            break;
        case Statement::Kind::move:
            write_move(statement);
            break;
        case Statement::Kind::time:
            write_time(statement);
            break;
        case Statement::Kind::table:
            break;  // the skeleton has it
    }
}

/// A network: what is done where a prepared condition is 1.
void ListingBuild::add(const Localized& comment, const Condition& condition,
                       std::vector<Instruction> work) {
    std::vector<Instruction> instructions = conditions_.load(condition);
    for (Instruction& instruction : work) instructions.push_back(std::move(instruction));
    networks_.add(Part::chart, comment, std::move(instructions));
}

void ListingBuild::write_assign(const Statement& statement) {
    const Bit target = statement.targets[0];
    const Condition condition = conditions_.prepare(statement.condition, statement.comment);
    // A transition condition that is always 1 is written down, as the document does: LD SM0.0, U
    // Tfig.
    if (target.kind == BitKind::transition && condition.kind == Condition::Kind::bit &&
        condition.bit.kind == BitKind::may_evolve) {
        networks_.add(Part::chart, statement.comment,
                      {make(Operation::load, {always_on()}),
                       make(Operation::and_, {addresses_[condition.bit]}),
                       make(Operation::assign, {addresses_[target]})});
        return;
    }
    add(statement.comment, condition, {make(Operation::assign, {addresses_[target]})});
}

void ListingBuild::write_set_or_reset(const Statement& statement) {
    const Condition condition = conditions_.prepare(statement.condition, statement.comment);
    const Operation operation =
        statement.kind == Statement::Kind::set ? Operation::set : Operation::reset;
    std::vector<Instruction> work;
    for (std::size_t at = 0; at < statement.targets.size();) {
        // One table after the other, in the order of the statement.
        const BitKind table = statement.targets[at].kind;
        std::vector<Operand> bits;
        for (; at < statement.targets.size() && statement.targets[at].kind == table; ++at) {
            bits.push_back(addresses_[statement.targets[at]]);
        }
        for (const BitRun& run : runs_of(std::move(bits))) {
            work.push_back(make(operation, {run.first, constant_operand(run.count)}));
        }
    }
    add(statement.comment, condition, std::move(work));
}

/// A value that may lie outside the range of its counter is worked out and held within it in the
/// accumulator, whatever the condition; the condition decides whether it is taken.
void ListingBuild::write_move(const Statement& statement) {
    const Width width = addresses_.width();
    const Condition condition = conditions_.prepare(statement.condition, statement.comment);
    const Operand target = addresses_[statement.integer];
    const auto take = [&](const Operand& source) {
        add(statement.comment, condition, {make(Operation::move, width, {source, target})});
    };
    if (statement.sum.empty()) {
        // The value was held within the same range when it was worked out.
        take(addresses_[statement.source]);
        return;
    }
    const IntegerRange range = value_range(grafcet_, statement.sum);
    if (range.low == range.high) {
        take(constant_operand(std::clamp(range.low, statement.low, statement.high)));
        return;
    }
    const bool is_within = range.low >= statement.low && range.high <= statement.high;
    if (is_within && is_operand(statement.sum)) {
        take(conditions_.operand_of(statement.sum));
        return;
    }
    const Operand accumulator = addresses_.accumulator(0);
    std::vector<Instruction> sum{make(Operation::load, {always_on()})};
    for (Instruction& part : conditions_.work_out(statement.sum, accumulator)) {
        sum.push_back(std::move(part));
    }
    networks_.add(Part::chart, say::sum_of(statement.comment), std::move(sum));
    hold_within(range, statement);
    take(accumulator);
}

void ListingBuild::hold_within(const IntegerRange& range, const Statement& statement) {
    const Width width = addresses_.width();
    const Operand accumulator = addresses_.accumulator(0);
    const auto hold = [&](Compare compare, std::int64_t bound, const Localized& comment) {
        networks_.add(Part::chart, comment,
                      {make_compare(Operation::load_compare, width, compare, accumulator,
                                    constant_operand(bound)),
                       make(Operation::move, width, {constant_operand(bound), accumulator})});
    };
    if (range.high > statement.high) {
        hold(Compare::greater_equal, statement.high, say::not_above(statement.high));
    }
    if (range.low < statement.low) {
        hold(Compare::less_equal, statement.low, say::not_below(statement.low));
    }
}

/// value = T(on) + value . /T(off), with T(on) counting while the operand is 1 and T(off) while it
/// is 0. A TON restarts whenever its condition has been 0, so T(on) says that the operand has
/// been 1 for the delay, and T(off) that it has been 0 for the other. Without an on-delay the
/// operand itself stands for T(on); without an off-delay the value is T(on).
void ListingBuild::write_time(const Statement& statement) {
    const Bit value = statement.targets[0];
    const TimeConditionTimers& timers = timers_[value.index];
    const Condition operand = conditions_.prepare(statement.condition, statement.comment);
    const auto count = [&](const Delay& delay, const Condition& condition,
                           const Localized& comment) {
        const Operand timer = timer_operand(static_cast<std::uint32_t>(delay.number));
        add(comment, condition,
            {make(Operation::on_delay, {timer, constant_operand(delay.preset)})});
        return timer;
    };
    std::vector<Instruction> result;
    if (timers.on) {
        const Operand on = count(*timers.on, operand, statement.comment);
        if (timers.timer_is_value()) return;
        result.push_back(make(Operation::load, {on}));
    } else {
        result = conditions_.load(operand);
    }
    const Operand held = addresses_[value];
    if (timers.off) {
        const Operand off =
            count(*timers.off, not_condition(operand), say::off_delay_of(statement.comment));
        result.push_back(make(Operation::load, {held}));
        result.push_back(make(Operation::and_not, {off}));
        result.push_back(make(Operation::or_load));
    }
    result.push_back(make(Operation::assign, {held}));
    networks_.add(Part::chart, say::value_of(statement.comment), std::move(result));
}

}  // namespace grafwire::s7
