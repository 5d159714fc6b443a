// Timers of STEP 7.
//
// S5 timers are what the course and most machines use, and they are seen in the status of the CPU;
// but they count three digits of a base, 10 ms at the finest, so 1.25 s fits and 1.253 s does not.
// What does not fit takes an IEC timer of the operating system, SFB 4 or 5, which wants a data
// block of its own and bits to hold its input and output. `1s/e/2s` is never made of an on-delay
// with an off-delay behind it, which would start the first one again: two on-delays set and reset
// the value.

#include "plc/step7/stl_timers.h"

#include <fmt/format.h>

#include <array>

#include "plc/step7/messages.h"
#include "program/messages.h"
#include "text/shown_duration.h"

namespace grafwire {

namespace {

/// Milliseconds as hours, minutes, seconds and milliseconds: `2H46M30S`.
std::string in_units(std::int64_t milliseconds) {
    struct Unit {
        const char* name;
        std::int64_t length;
    };
    static constexpr Unit units[] = {{"H", 3'600'000}, {"M", 60'000}, {"S", 1000}, {"MS", 1}};
    std::string text;
    for (const Unit& unit : units) {
        if (milliseconds < unit.length) continue;
        text += fmt::format("{}{}", milliseconds / unit.length, unit.name);
        milliseconds %= unit.length;
    }
    return text;
}

}  // namespace

std::optional<std::string> s5_time(Time duration) {
    for (const Time base : {10 * millisecond, 100 * millisecond, second, 10 * second}) {
        if (duration > 0 && duration % base == 0 && duration / base <= 999) {
            return "S5T#" + in_units(duration / millisecond);
        }
    }
    return std::nullopt;
}

std::optional<std::string> iec_time_constant(Time duration) {
    if (duration <= 0 || duration % millisecond != 0) return std::nullopt;
    if (duration / millisecond > INT32_MAX) return std::nullopt;
    return "T#" + in_units(duration / millisecond);
}

void StlTimers::add(Time duration, bool is_off_delay, Location origin, Diagnostics& diagnostics) {
    Timer timer;
    timer.is_off_delay = is_off_delay;
    if (const auto constant = s5_time(duration); constant && s5_used_ < s5_timer_count) {
        timer.s5_number = s5_used_++;
        timer.constant = *constant;
    } else if (const auto iec_constant = iec_time_constant(duration)) {
        timer.constant = *iec_constant;
        timer.data_block = ++data_blocks_;
        timer.in = memory_.new_bit();
        timer.out = memory_.new_bit();
    } else {
        diagnostics.error(code::unsupported_by_language, origin,
                          messages::plc_step7::no_timer_holds(shown_duration(duration)));
    }
    timers_.push_back(timer);
}

/// An on-delay and an off-delay are two timers, in this order.
void StlTimers::prepare(const ScanProgram& program, Diagnostics& diagnostics) {
    for (const Statement& statement : program.section(SectionKind::times)) {
        if (statement.kind != Statement::Kind::time) continue;
        first_.emplace(statement.targets.front().index, timers_.size());
        const bool both = statement.on_delay != 0 && statement.off_delay != 0;
        if (statement.on_delay != 0) add(statement.on_delay, false, statement.origin, diagnostics);
        if (statement.off_delay != 0)
            add(statement.off_delay, !both, statement.origin, diagnostics);
    }
}

void StlTimers::call(const Timer& timer, std::string_view time) {
    text_.line(
        fmt::format("      CALL  SFB {}, DB {} (", timer.is_off_delay ? 5 : 4, timer.data_block));
    text_.line(fmt::format("            IN := {},", text_.operand(timer.in)));
    text_.line(fmt::format("            PT := {},", time));
    text_.line(fmt::format("            Q  := {});", text_.operand(timer.out)));
}

void StlTimers::write_start() {
    if (!timers_.empty()) text_.op("SET");
    for (const Timer& timer : timers_) {
        text_.op("R", timer.s5_number ? status(timer) : text_.operand(timer.in),
                 messages::plc_step7::timer_stopped.in(language_));
    }
    for (const Timer& timer : timers_) {
        if (!timer.s5_number) call(timer, "T#0MS");  // a time of 0 makes Q 0 whatever it was
    }
}

std::string StlTimers::status(const Timer& timer) const {
    return timer.s5_number ? fmt::format("T {}", *timer.s5_number) : text_.operand(timer.out);
}

void StlTimers::run(const Timer& timer, const Condition& input) {
    conditions_.load(input);
    if (timer.s5_number) {
        text_.op("L", timer.constant);
        return text_.op(timer.is_off_delay ? "SA" : "SE", status(timer));
    }
    text_.op("=", text_.operand(timer.in));
    call(timer, timer.constant);
}

void StlTimers::write(const Statement& statement) {
    const Bit bit = statement.targets.front();
    const std::string value = text_.operand(memory_.of(bit));
    const std::string symbol = memory_.symbol(bit);
    if (statement.on_delay == 0 && statement.off_delay == 0) {
        conditions_.load(statement.condition);
        return text_.op("=", value, symbol);
    }
    if (statement.on_delay == 0 || statement.off_delay == 0) {
        const Timer& timer = timers_[first_.at(bit.index)];
        run(timer, statement.condition);
        text_.op("U", status(timer));
        return text_.op("=", value, symbol);
    }
    const Timer& on = timers_[first_.at(bit.index)];
    const Timer& off = timers_[first_.at(bit.index) + 1];
    const Condition held = bit_condition(bit);
    run(on, and_condition({statement.condition, not_condition(held)}));
    run(off, and_condition({not_condition(statement.condition), held}));
    text_.op("U", status(on));
    text_.op("S", value, symbol);
    text_.op("U", status(off));
    text_.op("R", value, symbol);
}

void StlTimers::write_data_blocks() {
    for (const Timer& timer : timers_) {
        if (timer.s5_number) continue;
        text_.line(fmt::format("DATA_BLOCK DB {}\nSFB {}\nBEGIN\nEND_DATA_BLOCK\n",
                               timer.data_block, timer.is_off_delay ? 5 : 4));
    }
}

}  // namespace grafwire
