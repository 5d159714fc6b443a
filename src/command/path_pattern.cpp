// A star first stands for nothing; where the rest does not fit, the last star takes one character
// more. Going back to the last one is enough, for whatever an earlier one could take it could take
// as well.

#include "command/path_pattern.h"

#include "text/utf8.h"

namespace grafwire {

bool has_wildcards(std::string_view path) {
    return path.find_first_of("*?") != std::string_view::npos;
}

namespace {

/// The bytes of the character at the beginning, one of a name that is not UTF-8.
std::size_t character_size(std::string_view text) {
    const std::size_t size = decode_utf8(text, 0).length;
    return size == 0 ? 1 : size;
}

}  // namespace

bool name_fits(std::string_view name, std::string_view pattern) {
    if (name.starts_with('.') && !pattern.starts_with('.')) return false;
    // The rest of both behind the last star.
    std::string_view name_again;
    std::string_view pattern_again;
    bool has_star = false;
    while (!name.empty()) {
        if (pattern.starts_with('*')) {
            pattern.remove_prefix(1);
            name_again = name;
            pattern_again = pattern;
            has_star = true;
        } else if (pattern.starts_with('?')) {
            pattern.remove_prefix(1);
            name.remove_prefix(character_size(name));
        } else if (!pattern.empty() && pattern.front() == name.front()) {
            pattern.remove_prefix(1);
            name.remove_prefix(1);
        } else if (has_star) {
            name_again.remove_prefix(character_size(name_again));
            name = name_again;
            pattern = pattern_again;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*') == std::string_view::npos;
}

}  // namespace grafwire
