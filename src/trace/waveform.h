#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "text/safe_names.h"
#include "text/time.h"
#include "trace/trace.h"

namespace grafwire {

class VcdWriter;

/// A waveform (VCD, IEEE 1364-2001 clause 18), and which of its signals are worth showing.
struct Waveform {
    struct Signal {
        Trace::Column::Kind kind = Trace::Column::Kind::internal;
        std::string name;  ///< as a viewer calls it
        bool is_number = false;
    };
    std::string vcd;
    std::vector<Signal> signals;  ///< in the order of the chart

    /// Notes the signal that shows a column.
    void add(const Trace::Column& column, const VcdWriter& writer, std::uint32_t signal);
};

/// The trace as a waveform that GTKWave opens: each column holds its value from its row to the
/// next. `scope` names the module.
Waveform waveform_of(const Trace& trace, std::string_view scope);

/// What GTKWave shows of a waveform (its save file): inputs, steps, outputs, vars and counters in
/// groups. `vcd_file`: the name of the file that holds the waveform, beside this one.
std::string write_gtkw(const Waveform& waveform, std::string_view vcd_file);

/// Builds a VCD text (IEEE 1364-2001 clause 18): declare all signals, then begin(), then changes in
/// the order of time. The timescale is the picosecond where a time needs it, else as coarse as
/// the caller says. Names are written in what GTKWave reads: in ASCII, `épais` as `epais`, other
/// characters that it does not read as `_`; a name that another signal already bears is followed by
/// `_2`, `_3`, …. Comments at the end say what names stand for that are not those of the chart.
class VcdWriter {
  public:
    /// `tick` is the timescale: every time given later is a whole number of ticks
    /// (1 ps, 1 ns, 1 us or 1 ms).
    explicit VcdWriter(std::string_view scope, Time tick = 1);

    /// Adds a signal of `width` bits and returns its number.
    std::uint32_t add_signal(std::string_view name, std::uint32_t width = 1);
    /// What a viewer calls a signal: `scope.name`, with the range of its bits where there are many.
    std::string shown_name(std::uint32_t signal) const;
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
    void tell_apart(std::string_view name, std::string_view written);
    static std::string identifier(std::uint32_t signal);

    std::string scope_;  ///< as it is written
    std::string text_;
    std::string comments_;
    Time tick_;
    Time now_ = -1;
    std::vector<std::uint32_t> widths_;
    std::vector<std::string> written_;  ///< the name of each signal
    SafeNames names_{true, [](std::string_view) { return false; }};
};

}  // namespace grafwire
