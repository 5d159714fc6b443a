#pragma once

#include <cstddef>
#include <string_view>

namespace grafwire {

/// The text without the blanks at its ends: spaces, tabs and what else does not end a line.
constexpr std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\v\f";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace grafwire
