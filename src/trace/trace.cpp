// A run as a table, written row by row (CSV) or change by change (VCD).
//
// A VCD text declares its signals under short identifiers of printable characters, then holds only
// changes: of the rows 0, 0, 1 of a column the first (its value from then on) and the third.
// Counters are vectors in two's complement, so that a viewer shows them as signed numbers.

#include "trace/trace.h"

#include <fmt/format.h>

#include <cassert>
#include <iterator>
#include <string_view>
#include <utility>

#include "text/escape.h"

namespace grafwire {

namespace {

/// The bits of a two's complement number that holds every value of the counter.
std::uint32_t width_of(const Counter& counter) {
    std::uint32_t width = 2;  // a counter is shown as a number even where one bit would do
    const auto fits = [&](std::int64_t value) {
        const std::int64_t limit = std::int64_t{1} << (width - 1);
        return value >= -limit && value < limit;
    };
    while (width < 63 && !(fits(counter.low) && fits(counter.high))) ++width;
    return width < 63 ? width : 64;
}

/// The coarsest timescale in which every time in the trace is a whole number.
Time tick_of(const Trace& trace) {
    for (const Time tick : {millisecond, microsecond, nanosecond}) {
        bool fits = true;
        for (const Time at : trace.times) fits = fits && at % tick == 0;
        if (fits) return tick;
    }
    return 1;
}

}  // namespace

Trace empty_trace(const Grafcet& grafcet) {
    Trace trace;
    const auto add = [&](std::string name, std::uint32_t width = 1) {
        trace.columns.push_back({std::move(name), width});
    };
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        add(std::string(input_name(grafcet, i)));
    }
    for (const Step& step : grafcet.steps) add("X" + step.name);
    for (const Output& output : grafcet.outputs) add(output.name);
    for (const Var& var : grafcet.vars) add(var.name);
    for (const Counter& counter : grafcet.counters) add(counter.name, width_of(counter));
    return trace;
}

// Most values are single bits, so these are not sent through the formatter.
std::string write_csv(const Trace& trace) {
    std::string out = "time_ms";
    for (const Trace::Column& column : trace.columns) {
        out += ',';
        append_csv_field(out, column.name);
    }
    out += '\n';
    const std::int64_t* value = trace.values.data();
    for (const Time at : trace.times) {
        out += format_milliseconds(at);
        for (std::size_t c = 0; c < trace.columns.size(); ++c, ++value) {
            if (*value == Trace::unknown) {
                out += ",x";
            } else if (*value == 0 || *value == 1) {
                out += *value == 0 ? ",0" : ",1";
            } else {
                fmt::format_to(std::back_inserter(out), ",{}", *value);
            }
        }
        out += '\n';
    }
    return out;
}

std::string write_vcd(const Trace& trace, std::string_view scope) {
    VcdWriter writer(scope, tick_of(trace));
    for (const Trace::Column& column : trace.columns) writer.add_signal(column.name, column.width);
    writer.begin();
    const std::size_t count = trace.columns.size();
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        const std::int64_t* values = trace.values.data() + row * count;
        const Time at = trace.times[row];
        for (std::size_t c = 0; c < count; ++c) {
            if (row != 0 && values[c] == (values - count)[c]) continue;
            const auto signal = static_cast<std::uint32_t>(c);
            if (values[c] == Trace::unknown) {
                writer.change(at, signal, 'x');
            } else if (trace.columns[c].width == 1) {
                writer.change(at, signal, values[c] == 0 ? '0' : '1');
            } else {
                writer.change(at, signal, values[c]);
            }
        }
    }
    return writer.finish(trace.times.empty() ? 0 : trace.times.back());
}

namespace {

/// A name as one word of a VCD. A leading `$` would make it a keyword.
std::string one_word(std::string_view name) {
    std::string word(name);
    for (char& c : word) {
        if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f') c = '_';
    }
    if (word.empty()) return "_";
    if (word.front() == '$') word.front() = '_';
    return word;
}

std::string_view timescale(Time tick) {
    if (tick == millisecond) return "1 ms";
    if (tick == microsecond) return "1 us";
    if (tick == nanosecond) return "1 ns";
    assert(tick == 1);
    return "1 ps";
}

}  // namespace

VcdWriter::VcdWriter(std::string_view scope, Time tick)
    : text_(fmt::format("$version grafwire $end\n$timescale {} $end\n$scope module {} $end\n",
                        timescale(tick), one_word(scope))),
      tick_(tick) {}

/// `!`, `"`, … `~`, `!!`, `"!`, …: a number in base 94 whose digits count from 1, so that all
/// differ.
std::string VcdWriter::identifier(std::uint32_t signal) {
    constexpr std::uint32_t printable = 94;  // '!' to '~'
    std::string id;
    do {
        id += static_cast<char>('!' + signal % printable);
        signal /= printable;
    } while (signal-- != 0);
    return id;
}

std::uint32_t VcdWriter::add_signal(std::string_view name, std::uint32_t width) {
    assert(now_ < 0 && width >= 1);
    const auto signal = static_cast<std::uint32_t>(widths_.size());
    widths_.push_back(width);
    fmt::format_to(std::back_inserter(text_), "$var wire {} {} {} $end\n", width,
                   identifier(signal), names_.claim_word(one_word(name)));
    return signal;
}

void VcdWriter::begin() {
    text_ += "$upscope $end\n$enddefinitions $end\n";
}

/// A line of its own says the time of all changes that follow it.
void VcdWriter::move_to(Time at) {
    assert(at >= now_ && at % tick_ == 0);
    if (at == now_) return;
    fmt::format_to(std::back_inserter(text_), "#{}\n", at / tick_);
    now_ = at;
}

void VcdWriter::change(Time at, std::uint32_t signal, char value) {
    move_to(at);
    if (widths_[signal] == 1) {
        text_ += value;
    } else {
        assert(value == 'x');
        text_ += "bx ";
    }
    text_ += identifier(signal);
    text_ += '\n';
}

void VcdWriter::change(Time at, std::uint32_t signal, std::int64_t value) {
    move_to(at);
    text_ += 'b';
    for (std::uint32_t bit = widths_[signal]; bit-- > 0;) {
        const bool is_set = bit > 63 ? value < 0 : (value >> bit & 1) != 0;
        text_ += is_set ? '1' : '0';
    }
    text_ += ' ';
    text_ += identifier(signal);
    text_ += '\n';
}

std::string VcdWriter::finish(Time end) {
    move_to(end);
    return std::move(text_);
}

}  // namespace grafwire
