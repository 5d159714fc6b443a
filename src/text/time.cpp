// Durations are exact: the digits after the point are multiplied by the unit as a fraction in
// lowest terms, never as a floating-point number.

#include "text/time.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <numeric>

#include "text/utf8.h"

namespace grafwire {

namespace {

struct Unit {
    std::string_view name;
    Time size;
};

constexpr std::array<Unit, 7> units = {{{"ps", 1},
                                        {"ns", nanosecond},
                                        {"us", microsecond},
                                        {"ms", millisecond},
                                        {"s", second},
                                        {"min", minute},
                                        {"h", hour}}};

std::string_view take_digits(std::string_view& text) {
    std::size_t count = 0;
    while (count < text.size() && is_digit(text[count])) ++count;
    const std::string_view digits = text.substr(0, count);
    text.remove_prefix(count);
    return digits;
}

/// The value of digits times `unit`, empty where it exceeds the range.
std::optional<Time> whole_part(std::string_view digits, Time unit) {
    const Time largest = (never - 1) / unit;
    Time value = 0;
    for (const char c : digits) {
        if (value > (largest - (c - '0')) / 10) return std::nullopt;
        value = value * 10 + (c - '0');
    }
    return value * unit;
}

/// 0.digits times `unit`, empty where that is no whole number of picoseconds.
std::optional<Time> fraction_part(std::string_view digits, Time unit) {
    while (!digits.empty() && digits.back() == '0') digits.remove_suffix(1);
    constexpr std::size_t most_digits = 18;  // 3.6e15 ps an hour: exact fractions have 16 at most
    if (digits.size() > most_digits) return std::nullopt;
    Time numerator = 0;
    Time denominator = 1;
    for (const char c : digits) {
        numerator = numerator * 10 + (c - '0');
        denominator *= 10;
    }
    const Time common = std::gcd(unit, denominator);
    const Time divisor = denominator / common;
    if (numerator % divisor != 0) return std::nullopt;
    return numerator / divisor * (unit / common);
}

/// `amount` in units of `unit`, a power of ten, without trailing zeros.
std::string decimal(Time amount, Time unit) {
    std::string text = fmt::format("{}", amount / unit);
    Time rest = amount % unit;
    if (rest == 0) return text;
    text += '.';
    for (Time digit = unit / 10; rest != 0; digit /= 10) {
        text += static_cast<char>('0' + rest / digit);
        rest %= digit;
    }
    return text;
}

}  // namespace

std::optional<Time> parse_duration(std::string_view text) {
    const std::string_view whole = take_digits(text);
    std::string_view fraction;
    if (whole.empty()) return std::nullopt;
    if (!text.empty() && text.front() == '.') {
        text.remove_prefix(1);
        fraction = take_digits(text);
        if (fraction.empty()) return std::nullopt;
    }
    for (const Unit& unit : units) {
        if (unit.name != text) continue;
        const auto high = whole_part(whole, unit.size);
        const auto low = fraction_part(fraction, unit.size);
        if (!high || !low || *high > never - 1 - *low) return std::nullopt;
        return *high + *low;
    }
    return std::nullopt;
}

std::string format_duration(Time duration) {
    assert(duration >= 0);
    if (duration == 0) return "0s";
    if (duration % hour == 0) return fmt::format("{}h", duration / hour);
    if (duration % minute == 0) return fmt::format("{}min", duration / minute);
    if (duration >= second) return decimal(duration, second) + "s";
    if (duration >= millisecond) return decimal(duration, millisecond) + "ms";
    return decimal(duration, microsecond) + "us";
}

std::string format_milliseconds(Time moment) {
    assert(moment >= 0);
    return decimal(moment, millisecond);
}

std::string format_nanoseconds(Time moment) {
    assert(moment >= 0);
    return decimal(moment, nanosecond);
}

}  // namespace grafwire
