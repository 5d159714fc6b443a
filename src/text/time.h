#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace grafwire {

/// A moment or a duration in picoseconds. The range is some 106 days either way.
using Time = std::int64_t;

inline constexpr Time nanosecond = 1'000;
inline constexpr Time microsecond = 1'000 * nanosecond;
inline constexpr Time millisecond = 1'000 * microsecond;
inline constexpr Time second = 1'000 * millisecond;
inline constexpr Time minute = 60 * second;
inline constexpr Time hour = 60 * minute;

/// Later than every moment that can occur.
inline constexpr Time never = std::numeric_limits<Time>::max();

/// The sum of two times that are not negative; `never` where it would not fit.
constexpr Time add_times(Time a, Time b) {
    return a > never - b ? never : a + b;
}

/// Reads `digits [ "." digits ] unit`, unit one of ps ns us ms s min h, with nothing before or
/// after. Empty where the text is no duration, is finer than a picosecond or is beyond the range.
/// (The languages accept us and longer units only; their readers check that.)
std::optional<Time> parse_duration(std::string_view text);

/// A duration in the largest unit (h, min, s, ms, us) that holds it in a short form: `5s`, `90s`,
/// `1.5s`, `20ms`, `2min`. Reading it back gives the same duration.
std::string format_duration(Time duration);

/// A moment in milliseconds without trailing zeros: `100`, `0.5`, `1500`.
std::string format_milliseconds(Time moment);

/// The same in nanoseconds.
std::string format_nanoseconds(Time moment);

}  // namespace grafwire
