#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "text/time.h"

namespace grafwire::iec {

/// `T#5m`, `T#1.5s`: exactly the duration, in one unit, which may have a fraction
/// (section 2.2.3.1); `T#0.25ms` below a millisecond.
std::string time_literal(Time duration);

/// `T#1m30s500ms`, `TIME#1.5s`, `t#250us`; underscores are skipped. Empty where the text is none,
/// or is negative or out of range.
std::optional<Time> parse_time_literal(std::string_view text);

/// `12`, `-3`, `INT#12`, `16#FF`, `2#1010`, `TRUE`, `FALSE`. Empty where the text is none, or has
/// more than 64 bits.
std::optional<std::int64_t> parse_number_literal(std::string_view text);

}  // namespace grafwire::iec
