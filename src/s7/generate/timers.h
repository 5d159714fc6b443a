#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "program/program.h"
#include "s7/addresses/cpu.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// A timer at work: TON T`number` K`preset`.
struct Delay {
    std::int32_t number = 0;
    std::int32_t preset = 0;
};

/// How a time condition `t1/e/t2` is made. A delay of 0 has no timer.
struct TimeConditionTimers {
    std::optional<Delay> on;
    std::optional<Delay> off;

    /// Whether the bit of the timer is the value of the condition: an on-delay alone, unless the
    /// timer counts milliseconds, which changes its bit in the middle of a scan.
    bool timer_is_value() const;
};

/// Gives every delay a timer, the coarsest that counts it exactly: 100 ms rather than 10 ms rather
/// than 1 ms. Delays that only a fine timer counts choose first. Errors: a delay that no timer
/// counts, or no timer left.
std::vector<TimeConditionTimers> plan_timers(const Grafcet& grafcet, const ScanProgram& program,
                                             Cpu cpu, Diagnostics& diagnostics);

}  // namespace grafwire::s7
