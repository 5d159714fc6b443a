#include "command/wrapped_help.h"

#include <algorithm>

#include "command/help.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr std::size_t columns = 80;
/// Where CLI11 lets the description of an option begin.
constexpr std::size_t description_column = 30;

/// How a line that is broken ends, and where the next one begins.
struct Break {
    std::string_view end;
    std::size_t indent = 0;
    bool before_options = false;  ///< so that an option stays with its value
};

Break break_of(std::string_view line, Language language) {
    if (line.starts_with(messages::help::example.in(language, ""))) return {" \\", 4, true};
    if (line.starts_with("  ")) return {"", description_column, false};
    return {};
}

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

/// The blank before the last option behind column `first`, where there is one before `blank`.
std::size_t before_option(std::string_view line, std::size_t first, std::size_t blank) {
    const std::size_t option = line.rfind(" --", blank);
    return option == std::string_view::npos || option <= first ? blank : option;
}

std::string wrapped_line(std::string line, const Break& how) {
    std::string result;
    while (count_code_points(line) > columns) {
        std::size_t blank = last_blank(line, how.indent, columns - how.end.size());
        if (blank == std::string::npos) break;
        if (how.before_options) blank = before_option(line, how.indent, blank);
        result.append(line, 0, blank).append(how.end) += '\n';
        line.replace(0, blank + 1, how.indent, ' ');
    }
    return result + line;
}

}  // namespace

std::string wrapped_help(std::string_view text, Language language) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        result += wrapped_line(std::string(line), break_of(line, language));
        if (end < text.size()) result += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

}  // namespace grafwire
