#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "s7/addresses/operand.h"
#include "text/time.h"

namespace grafwire::s7 {

/// The two controllers that Cordier writes for.
enum class Cpu : std::uint8_t { cpu_212, cpu_214 };

/// What a controller has room for: bytes of each area, and how many timers, … there are (numbered
/// from 0). From Cordier, sections III, 4.1 and VI; what he does not mention from the S7-200 System
/// Manual.
struct CpuRow {
    Cpu cpu;
    std::string_view name;
    std::int32_t image_bytes;  ///< of the process image of the inputs, and of the outputs
    std::int32_t variable_bytes;
    std::int32_t memento_bytes;
    std::int32_t special_bytes;
    std::int32_t timers;
    std::int32_t counters;
    std::int32_t subroutines;
    std::int32_t labels;
    std::uint32_t program_bytes;
};

inline constexpr std::array<CpuRow, 2> cpu_table{{
    {Cpu::cpu_212, "CPU 212", 8, 1024, 16, 46, 64, 64, 16, 64, 1024},
    {Cpu::cpu_214, "CPU 214", 8, 4096, 32, 86, 128, 128, 64, 256, 4096},
}};

constexpr const CpuRow& row_of(Cpu cpu) {
    return cpu_table[static_cast<std::size_t>(cpu)];
}

/// Subroutines may call one another this deep (Cordier, section 4.1).
inline constexpr std::size_t deepest_call = 8;

/// The size of an area: bytes, or the number of timers or counters.
constexpr std::int32_t size_of_area(const CpuRow& cpu, Area area) {
    switch (area) {
        case Area::input:
        case Area::output:
            return cpu.image_bytes;
        case Area::variable:
            return cpu.variable_bytes;
        case Area::memento:
            return cpu.memento_bytes;
        case Area::special:
            return cpu.special_bytes;
        case Area::timer:
            return cpu.timers;
        case Area::counter:
            return cpu.counters;
        case Area::constant:
        case Area::symbol:
        case Area::text:
            return 0;
    }
    return 0;
}

/// What a timer of a number is: its tick, and whether it keeps its value while its condition is 0
/// (TONR) or not (TON).
struct TimerKind {
    Time tick = 0;
    bool retentive = false;
    bool operator==(const TimerKind&) const = default;
};

/// In each 64 timers: 0 (1 ms), 1 … 4 (10 ms) and 5 … 31 (100 ms) are retentive, 32 (1 ms),
/// 33 … 36 (10 ms) and 37 … 63 (100 ms) are not. (Cordier uses T37 with its 100 ms.)
constexpr TimerKind timer_kind(std::int32_t number) {
    const std::int32_t in_half = number % 64;
    const std::int32_t place = in_half % 32;
    const Time tick = place == 0 ? millisecond : place < 5 ? 10 * millisecond : 100 * millisecond;
    return {tick, in_half < 32};
}

}  // namespace grafwire::s7
