// Which timer counts which delay.
//
// A controller has few timers of 1 ms, more of 10 ms and most of 100 ms, and a preset goes up to
// 32767. A delay takes the coarsest that counts it exactly, and a finer one where those have run
// out; so delays that need a fine timer choose first, and `1s` does not take the last timer of 1 ms
// from `1.003s`.

#include "s7/generate/timers.h"

#include <algorithm>
#include <array>

#include "program/messages.h"
#include "s7/generate/messages.h"
#include "text/shown_duration.h"

namespace grafwire::s7 {

namespace {

constexpr std::int64_t longest_preset = 32767;
constexpr std::array<Time, 3> ticks{100 * millisecond, 10 * millisecond, millisecond};

bool counts(Time tick, Time delay) {
    return delay % tick == 0 && delay / tick <= longest_preset;
}

/// A delay on its way to a timer.
struct Wanted {
    Time length = 0;
    std::size_t coarsest = 0;  ///< index into ticks
    const Statement* statement = nullptr;
    std::optional<Delay>* result = nullptr;
};

/// The timers of one controller that are still free, by tick; the lowest numbers go first.
class FreeTimers {
  public:
    explicit FreeTimers(const CpuRow& cpu) {
        for (std::int32_t number = cpu.timers - 1; number >= 0; --number) {
            const TimerKind kind = timer_kind(number);
            if (kind.retentive) continue;
            const auto at = std::find(ticks.begin(), ticks.end(), kind.tick) - ticks.begin();
            free_[static_cast<std::size_t>(at)].push_back(number);
        }
    }

    std::optional<Delay> take(const Wanted& wanted) {
        for (std::size_t t = wanted.coarsest; t < ticks.size(); ++t) {
            if (free_[t].empty() || !counts(ticks[t], wanted.length)) continue;
            const std::int32_t number = free_[t].back();
            free_[t].pop_back();
            return Delay{number, static_cast<std::int32_t>(wanted.length / ticks[t])};
        }
        return std::nullopt;
    }

  private:
    std::array<std::vector<std::int32_t>, ticks.size()> free_;
};

void report_uncountable(const Statement& statement, Time length, Diagnostics& diagnostics) {
    diagnostics.error(
        code::beyond_limit, statement.origin,
        messages::s7_generate::uncountable(shown_duration(length), statement.comment));
}

void report_no_timer(const Wanted& wanted, const CpuRow& cpu, Diagnostics& diagnostics) {
    const Time tick = ticks[wanted.coarsest];
    const Localized shown = shown_duration(tick);
    const auto& message = cpu.cpu == Cpu::cpu_212 ? messages::s7_generate::no_timer_left_on_212
                                                  : messages::s7_generate::no_timer_left;
    diagnostics.error(code::beyond_limit, wanted.statement->origin,
                      message(tick == ticks.back() ? shown : messages::s7_generate::or_finer(shown),
                              cpu.name, shown_duration(wanted.length), wanted.statement->comment));
}

}  // namespace

bool TimeConditionTimers::timer_is_value() const {
    return on && !off && timer_kind(on->number).tick > millisecond;
}

std::vector<TimeConditionTimers> plan_timers(const Grafcet& grafcet, const ScanProgram& program,
                                             Cpu cpu, Diagnostics& diagnostics) {
    std::vector<TimeConditionTimers> timers(grafcet.expressions.time_conditions().size());
    std::vector<Wanted> wanted;
    const auto want = [&](const Statement& statement, Time length, std::optional<Delay>& result) {
        if (length == 0) return;
        for (std::size_t t = 0; t < ticks.size(); ++t) {
            if (!counts(ticks[t], length)) continue;
            wanted.push_back({length, t, &statement, &result});
            return;
        }
        report_uncountable(statement, length, diagnostics);
    };
    for (const Statement& statement : program.section(SectionKind::times)) {
        TimeConditionTimers& condition = timers[statement.targets[0].index];
        want(statement, statement.on_delay, condition.on);
        want(statement, statement.off_delay, condition.off);
    }
    // The order of the chart stays among delays of one tick.
    std::stable_sort(wanted.begin(), wanted.end(),
                     [](const Wanted& a, const Wanted& b) { return a.coarsest > b.coarsest; });
    FreeTimers free(row_of(cpu));
    for (const Wanted& delay : wanted) {
        *delay.result = free.take(delay);
        if (!*delay.result) report_no_timer(delay, row_of(cpu), diagnostics);
    }
    return timers;
}

}  // namespace grafwire::s7
