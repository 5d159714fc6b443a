#pragma once

#include <optional>
#include <string>

#include "text/diagnostics.h"

namespace grafwire {

/// The text of a chart in the canonical layout, which README.md describes: the same chart, with its
/// comments, blank lines and line ends within lists and conditions, and with its keywords in one
/// language. A text in that layout stays as it is.
///
/// Empty if the chart has an error: errors and warnings are those of parse_grafcet(), and go into
/// `diagnostics`.
std::optional<std::string> format_grafcet(const SourceFile& source, Language keywords,
                                          Diagnostics& diagnostics);

}  // namespace grafwire
