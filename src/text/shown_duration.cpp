#include "text/shown_duration.h"

namespace grafwire {

Localized shown_duration(Time duration) {
    const std::string text = format_duration(duration);
    std::string french = text;
    french.insert(french.find_last_of("0123456789") + 1, "\u00a0");
    if (const std::size_t point = french.find('.'); point != std::string::npos) french[point] = ',';
    return {text, std::move(french)};
}

}  // namespace grafwire
