#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "trace/trace_table.h"

namespace grafwire {

/// How a table is to look on standard output, where that is a terminal: as wide as it is (80
/// columns where that is not known), emphasised unless NO_COLOR is set (no-color.org) or the
/// terminal is a dumb one.
std::optional<TableLook> look_of_terminal();

/// How wide the lines of a text on standard output may be: as wide as the terminal; 80 columns
/// where it is none, or where that is not known.
std::size_t width_of_output();

/// A trace for the file at `path`: CSV, but a table where it goes to standard output (`path` is
/// empty) and that is a terminal.
std::string trace_text(const Trace& trace, const Grafcet& grafcet, const std::string& path,
                       Language language);

}  // namespace grafwire
