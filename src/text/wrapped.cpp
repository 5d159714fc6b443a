#include "text/wrapped.h"

#include <algorithm>

#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr std::size_t further_in = 4;

/// The last blank behind column `first` with at most `most` columns before it; npos where there is
/// none.
std::size_t last_blank(std::string_view line, std::size_t first, std::size_t most) {
    std::size_t found = std::string_view::npos;
    std::size_t column = 0;
    for (std::size_t at = 0; at < line.size() && column <= most; ++column) {
        if (line[at] == ' ' && column > first) found = at;
        at += std::max<std::size_t>(decode_utf8(line, at).length, 1);
    }
    return found;
}

void append_wrapped_line(std::string& out, std::string line, std::size_t width) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t indent = begin + further_in;
    std::size_t first = begin;
    while (count_code_points(line) > width) {
        const std::size_t blank = last_blank(line, first, width);
        if (blank == std::string::npos) break;
        out.append(line, 0, blank) += '\n';
        line.replace(0, blank + 1, indent, ' ');
        first = indent;
    }
    out += line;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        append_wrapped_line(result, std::string(text.substr(0, end)), width);
        if (end < text.size()) result += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

}  // namespace grafwire
