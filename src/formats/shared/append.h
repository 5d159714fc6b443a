#pragma once

#include <fmt/format.h>

#include <concepts>
#include <string>
#include <string_view>

namespace grafwire {

inline void append_one(std::string& out, std::string_view text) {
    out.append(text);
}
inline void append_one(std::string& out, char character) {
    out.push_back(character);
}
template <std::integral Number>
requires(!std::same_as<Number, char> &&
         !std::same_as<Number, bool>) void append_one(std::string& out, Number number) {
    const fmt::format_int digits(number);
    out.append(digits.data(), digits.size());
}

/// Puts texts and numbers at the end of `out`: the writers' hot path, where a format string would
/// be read again for every one of millions of cells.
template <typename... Parts>
void append(std::string& out, const Parts&... parts) {
    (append_one(out, parts), ...);
}

/// A text for the rest of a comment line: control characters become blanks.
inline void append_comment(std::string& out, std::string_view text) {
    for (const char c : text) out.push_back(static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
}

}  // namespace grafwire
