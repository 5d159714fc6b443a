#include "trace/trace.h"

#include <fmt/format.h>

#include <cassert>
#include <iterator>
#include <string_view>

#include "text/csv.h"
#include "trace/vcd_writer.h"

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

}  // namespace grafwire
