#include "text/wrapped.h"

#include <algorithm>
#include <limits>

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

/// Where the first line ends and the next one begins.
struct Break {
    std::size_t end = std::string::npos;  ///< npos: there is no place for one
    std::size_t next = 0;
};

/// At the last blank that can be.
Break break_of_words(std::string_view line, std::size_t first, std::size_t most) {
    const std::size_t blank = last_blank(line, first, most);
    return {blank, blank + 1};
}

bool is_digit_at(std::string_view line, std::size_t at) {
    return at < line.size() && line[at] >= '0' && line[at] <= '9';
}

/// A dot between digits is none of AND, but of a number.
Break break_of_formula(std::string_view line, std::size_t first, std::size_t most) {
    const std::size_t sign = line.find(" = ");
    if (sign != std::string_view::npos) first = std::max(first, sign + 2);
    Break best;
    int least = std::numeric_limits<int>::max();
    int depth = 0;  // below 0 where parentheses close that an earlier line opens
    bool is_quoted = false;
    std::size_t column = 0;
    for (std::size_t at = 0; at < line.size() && column <= most; ++column) {
        const char c = line[at];
        if (c == '"') is_quoted = !is_quoted;
        if (!is_quoted && (c == '(' || c == '[')) ++depth;
        if (!is_quoted && (c == ')' || c == ']')) --depth;
        const bool is_blank = c == ' ' && line.substr(at, 3) != " + ";
        const bool is_and =
            c == '.' && column < most && !(is_digit_at(line, at - 1) && is_digit_at(line, at + 1));
        const int rank = 2 * depth + (is_and ? 1 : 0);
        if (at > first && !is_quoted && (is_blank || is_and) && rank <= least) {
            least = rank;
            best = is_and ? Break{at + 1, at + 1} : Break{at, at + 1};
        }
        at += std::max<std::size_t>(decode_utf8(line, at).length, 1);
    }
    return best;
}

using FindBreak = Break (*)(std::string_view line, std::size_t first, std::size_t most);

void append_wrapped_line(std::string& out, std::string line, std::size_t width, FindBreak find) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t indent = begin + further_in;
    std::size_t first = begin;
    while (count_code_points(line) > width) {
        const Break found = find(line, first, width);
        if (found.end == std::string::npos) break;
        out.append(line, 0, found.end) += '\n';
        line.replace(0, found.next, indent, ' ');
        first = indent;
    }
    out += line;
}

std::string wrapped_at(std::string_view text, std::size_t width, FindBreak find) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        append_wrapped_line(result, std::string(text.substr(0, end)), width, find);
        if (end < text.size()) result += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
    return wrapped_at(text, width, break_of_words);
}

std::string wrapped_formulas(std::string_view text, std::size_t width) {
    return wrapped_at(text, width, break_of_formula);
}

}  // namespace grafwire
