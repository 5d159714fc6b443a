// A run as a table.

#include "trace/trace.h"

#include <fmt/format.h>

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

}  // namespace

Trace empty_trace(const Grafcet& grafcet) {
    Trace trace;
    using Kind = Trace::Column::Kind;
    const auto add = [&](Kind kind, std::string name, std::uint32_t width = 1) {
        trace.columns.push_back({std::move(name), width, kind});
    };
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        add(Kind::input, std::string(input_name(grafcet, i)));
    }
    for (const Step& step : grafcet.steps) add(Kind::step, "X" + step.name);
    for (const Output& output : grafcet.outputs) add(Kind::output, output.name);
    for (const Var& var : grafcet.vars) add(Kind::internal, var.name);
    for (const Counter& counter : grafcet.counters) {
        add(Kind::internal, counter.name, width_of(counter));
    }
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
                out += fmt::format(",{}", *value);
            }
        }
        out += '\n';
    }
    return out;
}

}  // namespace grafwire
