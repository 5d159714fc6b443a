#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "text/time.h"

namespace grafwire {

/// A run as a table: one row per scan or instant. Columns are the inputs, Init, AUdur, AUdoux, X of
/// every step, the outputs, the vars and the counters, each group in the order of the file.
struct Trace {
    /// What a simulated bit shows that is neither 0 nor 1; written as `x`.
    static constexpr std::int64_t unknown = INT64_MIN;

    struct Column {
        enum class Kind { input, step, output, internal };
        std::string name;
        std::uint32_t width = 1;  ///< bits to show in a waveform; 1 except for counters
        Kind kind = Kind::internal;
    };
    std::vector<Column> columns;
    std::vector<Time> times;           ///< one per row
    std::vector<std::int64_t> values;  ///< row after row

    std::size_t row_count() const { return times.size(); }
};

/// A trace without rows, with the columns of the GRAFCET.
Trace empty_trace(const Grafcet& grafcet);

/// RFC 4180 with LF line ends: a header `time_ms,…` and one line per row. Times in milliseconds
/// without trailing zeros.
std::string write_csv(const Trace& trace);

}  // namespace grafwire
