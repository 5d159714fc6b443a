// Literals of time and of whole numbers (IEC 61131-3, sections 2.2.1 and 2.2.3). A duration is read
// part by part, `1m` and `30s` of `T#1m30s`, with the reader of the other languages: the units
// differ only in `m` for the minute, which is `min` there, and in `d` for the day, which is 24
// hours. Nothing is rounded, and what does not fit into 64 bits is refused.

#include "iec/literals.h"

#include <charconv>

#include "iec/identifiers.h"
#include "text/utf8.h"

namespace grafwire::iec {

namespace {

std::string without_underscores(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c != '_') result += c;
    }
    return result;
}

/// All of `text` as a number to a base.
std::optional<std::int64_t> whole_number(std::string_view text, int base) {
    std::int64_t value = 0;
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value, base);
    if (error != std::errc() || stop != end || text.empty()) return std::nullopt;
    return value;
}

}  // namespace

std::string time_literal(Time duration) {
    // Microseconds came with the third edition, and many compilers do without them.
    if (duration > 0 && duration < millisecond) return "T#" + format_milliseconds(duration) + "ms";
    std::string text = format_duration(duration);
    if (text.ends_with("min")) text.resize(text.size() - 2);  // m is the minute of the language
    return "T#" + text;
}

std::optional<Time> parse_time_literal(std::string_view text) {
    const std::size_t mark = text.find('#');
    if (mark == std::string_view::npos) return std::nullopt;
    const std::string prefix = capitals(text.substr(0, mark));
    if (prefix != "T" && prefix != "TIME") return std::nullopt;
    const std::string rest = small_letters(without_underscores(text.substr(mark + 1)));
    if (rest.empty()) return std::nullopt;
    Time total = 0;
    for (std::size_t at = 0; at < rest.size();) {
        std::size_t unit = at;
        while (unit < rest.size() && (is_digit(rest[unit]) || rest[unit] == '.')) ++unit;
        std::size_t end = unit;
        while (end < rest.size() && !is_digit(rest[end])) ++end;
        std::string part = rest.substr(at, end - at);
        Time factor = 1;
        if (part.size() > 1 && part.back() == 'd') {
            part.back() = 'h';
            factor = 24;
        } else if (part.size() > 1 && part.back() == 'm') {
            part += "in";
        }
        const auto duration = parse_duration(part);
        if (!duration || __builtin_mul_overflow(*duration, factor, &factor)) return std::nullopt;
        if (__builtin_add_overflow(total, factor, &total)) return std::nullopt;
        at = end;
    }
    return total;
}

std::optional<std::int64_t> parse_number_literal(std::string_view text) {
    std::string number = capitals(without_underscores(text));
    if (number == "TRUE") return 1;
    if (number == "FALSE") return 0;
    // Prefixes are types or bases: `INT#16#FF`.
    int base = 10;
    for (std::size_t mark = number.find('#'); mark != std::string::npos; mark = number.find('#')) {
        const std::string prefix = number.substr(0, mark);
        number.erase(0, mark + 1);
        if (prefix == "16" || prefix == "8" || prefix == "2") {
            base = prefix == "16" ? 16 : prefix == "8" ? 8 : 2;
        } else if (prefix.empty() || is_digit(prefix.front())) {
            return std::nullopt;
        }
    }
    if (number == "TRUE" || number == "FALSE") return number == "TRUE" ? 1 : 0;
    return whole_number(number, base);
}

}  // namespace grafwire::iec
