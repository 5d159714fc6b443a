// Conditions as contacts, and statements as rungs.
//
// Only single contacts can be negated in a drawing: a negation is moved inwards, `/(a + b . c)` to
// `/a . (/b + /c)`, and an exclusive OR is drawn as its two cases, `a . /b + /a . b`. Each case
// draws both operands, so an exclusive OR among these is worked out in a rung of its own before: of
// n inputs the drawing would grow with 2^n otherwise. A block adds two words, so a sum of more
// terms is worked out before the rung that needs it as well.

#include "plc/pl7/pl7_rungs.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "grafcet/expression.h"
#include "grafcet/grafcet.h"
#include "plc/pl7/messages.h"
#include "plc/shared/program_needs.h"
#include "program/messages.h"
#include "text/shown_duration.h"

namespace grafwire {

namespace {

bool has_exclusive_or(const Condition& condition) {
    return condition.kind == Condition::Kind::exclusive_or ||
           std::any_of(condition.operands.begin(), condition.operands.end(), has_exclusive_or);
}

/// Of two operands without another exclusive OR in them.
bool is_simple_exclusive_or(const Condition& condition) {
    return condition.operands.size() <= 2 &&
           std::none_of(condition.operands.begin(), condition.operands.end(), has_exclusive_or);
}

Condition on_contacts(const Condition& condition, bool negated);

/// a ⊕ b as a./b + /a.b.
Condition exclusive_or_on_contacts(const Condition& condition, bool negated) {
    const Condition& left = condition.operands.front();
    const Condition& right = condition.operands.back();
    std::vector<Condition> branches;
    branches.push_back(and_condition({on_contacts(left, false), on_contacts(right, !negated)}));
    branches.push_back(and_condition({on_contacts(left, true), on_contacts(right, negated)}));
    return or_condition(std::move(branches));
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
    return series_or_parallel(on_contacts(drawable(condition), false), false);
}

/// An equal condition in which every exclusive OR is a simple one; rungs for the others are added.
Condition Pl7Rungs::drawable(const Condition& condition) {
    if (!has_exclusive_or(condition)) return condition;
    Condition result = condition;
    for (Condition& operand : result.operands) operand = drawable(operand);
    if (condition.kind != Condition::Kind::exclusive_or || is_simple_exclusive_or(result)) {
        return result;
    }
    // From the left, two at a time; the last two are drawn where the whole is.
    Condition drawn = std::move(result.operands.front());
    for (std::size_t i = 1; i < result.operands.size(); ++i) {
        Condition pair;
        pair.kind = Condition::Kind::exclusive_or;
        pair.operands.push_back(worked_out(std::move(drawn)));
        pair.operands.push_back(worked_out(std::move(result.operands[i])));
        drawn = std::move(pair);
    }
    return drawn;
}

/// A bit that has the value of a condition with an exclusive OR from here on in this scan; others
/// stay as they are.
Condition Pl7Rungs::worked_out(Condition condition) {
    if (!has_exclusive_or(condition)) return condition;
    const Bit bit = objects_.new_work_bit();
    line(series_or_parallel(on_contacts(condition, false), false), "( ) " + objects_.of(bit));
    return bit_condition(bit);
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

bool Pl7Rungs::has_long_exclusive_ors(const Condition& condition) {
    return (condition.kind == Condition::Kind::exclusive_or &&
            !is_simple_exclusive_or(condition)) ||
           std::any_of(condition.operands.begin(), condition.operands.end(),
                       has_long_exclusive_ors);
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

namespace {

/// `T3` of `T3,D`.
std::string timer_of(const std::string& done) {
    return done.substr(0, done.find(','));
}

}  // namespace

/// The value of a condition with an on-delay only is D of its timer.
void Pl7Statements::name_timers() {
    for (const Statement& statement : program_.section(SectionKind::times)) {
        if (statement.on_delay == 0 || statement.off_delay != 0) continue;
        objects_.name(statement.targets.front(), objects_.new_timer() + ",D");
    }
}

void Pl7Statements::write(const Statement& statement) {
    rungs_.label(statement.comment.in(language_));
    const char* coil = "( ) ";
    switch (statement.kind) {
        case Statement::Kind::move:
            return write_move(statement);
        case Statement::Kind::time:
            return write_time(statement);
        case Statement::Kind::set:
            coil = "(S) ";
            break;
        case Statement::Kind::reset:
            coil = "(R) ";
            break;
        default:
            break;
    }
    for (const Bit bit : statement.targets) {
        rungs_.rung(statement.condition, coil + objects_.of(bit));
    }
}

/// The value is worked out first, for the condition may read the counter that is written.
void Pl7Statements::write_move(const Statement& statement) {
    std::string value;
    if (statement.sum.empty()) {
        value = objects_.of(statement.source);
    } else {
        const IntegerRange range = value_range(grafcet_, statement.sum);
        std::optional<std::int64_t> low;
        std::optional<std::int64_t> high;
        if (range.low < statement.low) low = statement.low;
        if (range.high > statement.high) high = statement.high;
        value = rungs_.limited(rungs_.value(statement.sum), low, high);
    }
    rungs_.rung(statement.condition,
                fmt::format("[{} -> {}]", value, objects_.of(statement.integer)));
}

/// A timer block that a condition drives.
void Pl7Statements::run_timer(const std::string& timer, Time duration, const Condition& condition,
                              Location where) {
    const auto preset = pl7_preset(duration);
    if (preset) {
        return rungs_.rung(condition,
                           fmt::format("{} TB={} P={}", timer, preset->base, preset->count));
    }
    diagnostics_.error(code::unsupported_by_language, where,
                       messages::plc_pl7::no_timer_holds(shown_duration(duration)));
}

/// With an on-delay only, D of the timer is the value (name_timers); else two rungs set and reset
/// it.
void Pl7Statements::write_time(const Statement& statement) {
    const Bit bit = statement.targets.front();
    const Condition held = bit_condition(bit);
    const Condition& operand = statement.condition;
    if (statement.off_delay == 0) {
        if (statement.on_delay == 0) {
            return rungs_.rung(operand, "( ) " + objects_.of(bit));
        }
        return run_timer(timer_of(objects_.of(bit)), statement.on_delay, operand, statement.origin);
    }
    if (statement.on_delay == 0) {
        rungs_.rung(operand, "(S) " + objects_.of(bit));
    } else {
        const std::string timer = objects_.new_timer();
        run_timer(timer, statement.on_delay, and_condition({operand, not_condition(held)}),
                  statement.origin);
        rungs_.line(timer + ",D", "(S) " + objects_.of(bit));
    }
    const std::string timer = objects_.new_timer();
    run_timer(timer, statement.off_delay, and_condition({not_condition(operand), held}),
              statement.origin);
    rungs_.line(timer + ",D", "(R) " + objects_.of(bit));
}

}  // namespace grafwire
