#pragma once

#include <string_view>

namespace grafwire {

/// How wide a text is in DejaVu Sans, in multiples of the size of its letters.
double width_in_letters(std::string_view text);

}  // namespace grafwire
