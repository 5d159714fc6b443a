// The statements that follow the evolution: coils, counters, time conditions.

#include "plc/pl7/pl7_statements.h"

#include <fmt/format.h>

#include "grafcet/sum_range.h"
#include "plc/pl7/messages.h"
#include "plc/shared/program_needs.h"
#include "program/messages.h"

namespace grafwire {

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
                       messages::plc_pl7::no_timer_holds(format_duration(duration)));
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
