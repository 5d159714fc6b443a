#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plc/step7/stl_instructions.h"
#include "plc/step7/stl_memory.h"

namespace grafwire {

/// A duration as a constant of an S5 timer, `S5T#1M30S`; empty where none is exactly as long. They
/// have three digits in steps of 10 ms, 100 ms, 1 s or 10 s, so 10 ms to 9990 s (2H46M30S).
std::optional<std::string> s5_time(Time duration);
/// As a TIME constant of the IEC timers, `T#500MS`: whole milliseconds, up to 24 days (2^31 - 1
/// ms).
std::optional<std::string> iec_time_constant(Time duration);

/// Writes time conditions with the timers of an S7-300 or S7-400: an S5 timer (SE, or SA where
/// there is an off-delay only) where it holds the time exactly, else the system function block SFB
/// 4 (TON) or SFB 5 (TOF), each with a data block. Where both delays are to be observed, two
/// on-delays set and reset the value.
class StlTimers {
  public:
    StlTimers(StlMemory& memory, StlText& text, StlConditions& conditions, Language language)
        : memory_(memory), text_(text), conditions_(conditions), language_(language) {}

    static constexpr std::uint32_t s5_timer_count = 256;  ///< of most CPUs

    /// Errors: more S5 timers than there are, or a time that no timer holds.
    void prepare(const ScanProgram& program, Diagnostics& diagnostics);
    /// Stops all timers, before the first scan.
    void write_start();
    void write(const Statement& statement);
    /// The data blocks of the IEC timers, `DATA_BLOCK DB 1`.
    void write_data_blocks();

  private:
    /// One timer; a time condition has up to two.
    struct Timer {
        bool is_off_delay = false;
        std::optional<std::uint32_t> s5_number;  ///< else an IEC timer
        std::uint32_t data_block = 0;
        std::string constant;
        StlAddress in, out;  ///< of an IEC timer
    };
    void add(Time duration, bool is_off_delay, Location origin, Diagnostics& diagnostics);
    void call(const Timer& timer, std::string_view time);
    void run(const Timer& timer, const Condition& input);
    std::string status(const Timer& timer) const;

    StlMemory& memory_;
    StlText& text_;
    StlConditions& conditions_;
    Language language_;
    std::vector<Timer> timers_;
    std::map<std::uint32_t, std::size_t> first_;  ///< of a time condition
    std::uint32_t s5_used_ = 0;
    std::uint32_t data_blocks_ = 0;
};

}  // namespace grafwire
