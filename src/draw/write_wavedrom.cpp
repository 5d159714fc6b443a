// WaveDrom counts time in periods of one character, so a moment of change is a period, whatever the
// time to the next: the times stand in a line of their own. `.` goes on as before, `x` is unknown,
// `=` a box with the next of the texts in `data`.

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "draw/messages.h"
#include "draw/moments.h"
#include "draw/write_drawing.h"
#include "text/shown_duration.h"

namespace grafwire {

namespace {

using Json = nlohmann::ordered_json;
using Kind = Trace::Column::Kind;
namespace say = messages::draw;

const Message<>& group_name(Kind kind) {
    switch (kind) {
        case Kind::input:
            return say::inputs;
        case Kind::step:
            return say::steps;
        case Kind::output:
            return say::outputs;
        case Kind::internal:
            break;
    }
    return say::internals;
}

Json signal_of(const Trace& trace, std::size_t column, const std::vector<std::size_t>& rows) {
    Json data = Json::array();
    std::string wave;
    std::int64_t before = 0;
    for (const std::size_t row : rows) {
        const std::int64_t value = trace.values[row * trace.columns.size() + column];
        if (!wave.empty() && value == before) {
            wave += '.';
        } else if (value == Trace::unknown) {
            wave += 'x';
        } else if (trace.columns[column].width == 1) {
            wave += value != 0 ? '1' : '0';
        } else {
            wave += '=';
            data.push_back(fmt::format("{}", value));
        }
        before = value;
    }
    Json signal{{"name", trace.columns[column].name}, {"wave", wave}};
    if (!data.empty()) signal["data"] = std::move(data);
    return signal;
}

}  // namespace

std::string write_wavedrom(const Trace& trace, std::string_view title, Language language) {
    const std::vector<std::size_t> rows = moments_of(trace, nullptr);
    Json times = Json::array();
    for (const std::size_t row : rows) {
        times.push_back(shown_duration(trace.times[row]).in(language));
    }
    Json signals = Json::array();
    signals.push_back({{"name", say::time.in(language)},
                       {"wave", std::string(rows.size(), '=')},
                       {"data", std::move(times)}});
    Json group;
    for (std::size_t i = 0; i < trace.columns.size(); ++i) {
        const Kind kind = trace.columns[i].kind;
        if (i == 0 || kind != trace.columns[i - 1].kind) {
            if (!group.is_null()) signals.push_back(std::move(group));
            group = Json::array({group_name(kind).in(language)});
        }
        group.push_back(signal_of(trace, i, rows));
    }
    if (!group.is_null()) signals.push_back(std::move(group));
    const Json all{{"signal", std::move(signals)},
                   {"head", {{"text", std::string(title)}}},
                   {"config", {{"hscale", 2}}}};
    return all.dump(2) + "\n";
}

}  // namespace grafwire
