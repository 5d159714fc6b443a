#include "plc/wrap_text.h"

#include <algorithm>

#include "text/utf8.h"

namespace grafwire {

std::string wrap_text(std::string_view line, std::size_t indent, std::size_t width) {
    std::string wrapped(4 * indent, ' ');
    std::size_t column = wrapped.size();
    std::size_t margin = column;
    for (std::size_t at = 0; at < line.size();) {
        // A word with the blanks before it.
        const std::size_t begin = line.find_first_not_of(' ', at);
        if (begin == std::string_view::npos) break;
        const std::size_t end = std::min(line.find(' ', begin), line.size());
        const std::string_view word = line.substr(begin, end - begin);
        const std::size_t length = count_code_points(word);
        if (column > margin && column + (begin - at) + length > width) {
            margin = 4 * (indent + 1);
            wrapped += '\n' + std::string(margin, ' ');
            column = margin;
        } else {
            wrapped.append(begin - at, ' ');
            column += begin - at;
        }
        wrapped += word;
        column += length;
        at = end;
    }
    wrapped += '\n';
    return wrapped;
}

}  // namespace grafwire
