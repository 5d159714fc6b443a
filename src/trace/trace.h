#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/grafcet.h"
#include "text/safe_names.h"
#include "text/time.h"

namespace grafwire {

/// A run as a table: one row per scan or instant. Columns are the inputs, Init, AUdur, AUdoux, X of
/// every step, the outputs, the vars and the counters, each group in the order of the file.
struct Trace {
    /// What a simulated bit shows that is neither 0 nor 1; written as `x`.
    static constexpr std::int64_t unknown = INT64_MIN;

    struct Column {
        std::string name;
        std::uint32_t width = 1;  ///< bits to show in a waveform; 1 except for counters
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

/// The trace as a waveform (VCD, IEEE 1364-2001 clause 18) that GTKWave opens: each column holds
/// its value from its row to the next. `scope` names the module.
std::string write_vcd(const Trace& trace, std::string_view scope);

/// Builds a VCD text (IEEE 1364-2001 clause 18): declare all signals, then begin(), then changes in
/// the order of time. The timescale is the picosecond where a time needs it, else as coarse as
/// the caller says. Names with characters VCD cannot hold (white space) have them replaced by `_`;
/// a name that another signal already bears is followed by `_2`, `_3`, ….
class VcdWriter {
  public:
    /// `tick` is the timescale: every time given later is a whole number of ticks
    /// (1 ps, 1 ns, 1 us or 1 ms).
    explicit VcdWriter(std::string_view scope, Time tick = 1);

    /// Adds a signal of `width` bits and returns its number.
    std::uint32_t add_signal(std::string_view name, std::uint32_t width = 1);
    /// Ends the declarations.
    void begin();
    /// The value is '0', '1' or 'x' for one bit; 'x' also for all bits of a wider signal.
    void change(Time at, std::uint32_t signal, char value);
    /// A value of several bits, two's complement.
    void change(Time at, std::uint32_t signal, std::int64_t value);
    /// Marks the end of the recording and gives the text.
    std::string finish(Time end);

  private:
    void move_to(Time at);
    static std::string identifier(std::uint32_t signal);

    std::string text_;
    Time tick_;
    Time now_ = -1;
    std::vector<std::uint32_t> widths_;
    SafeNames names_{true, [](std::string_view) { return false; }};
};

}  // namespace grafwire
