#pragma once

#include <string>
#include <string_view>

namespace grafwire {

/// Two spaces before every line that is not empty.
inline std::string indented(std::string_view text) {
    std::string result;
    bool at_start = true;
    for (const char c : text) {
        if (at_start && c != '\n') result += "  ";
        result += c;
        at_start = c == '\n';
    }
    return result;
}

}  // namespace grafwire
