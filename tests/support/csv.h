#pragma once

#include <string>
#include <vector>

namespace grafwire::testing {

using CsvRow = std::vector<std::string>;

/// The rows of a CSV text (RFC 4180, lines ended by LF), the header among them.
std::vector<CsvRow> read_csv(const std::string& text);

}  // namespace grafwire::testing
