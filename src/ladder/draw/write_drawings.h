#pragma once

#include <string>

#include "ladder/ladder.h"
#include "text/message.h"

namespace grafwire::ladder {

/// The diagram drawn in characters (box drawing), at most `width` columns wide unless a single name
/// is wider: a head with the variables, then the sections and rungs with their comments. The
/// language is that of the head.
std::string write_text(const Ladder& ladder, int width = 80, Language language = Language::english);
/// One rung between its rails, without comment; lines are indented by `indent` blanks.
std::string write_rung(const Ladder& ladder, const Rung& rung, int width, std::size_t indent = 0);

/// The diagram as a picture: a self-contained SVG file for light and dark viewers. It holds pages
/// of A4 below one another, each with the title and its number, which a browser prints one by one;
/// a rung is on one page unless it is taller than that.
std::string write_svg(const Ladder& ladder, Language language = Language::english);

}  // namespace grafwire::ladder
