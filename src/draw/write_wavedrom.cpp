// WaveDrom counts time in periods of one character, so a moment of change is a period, whatever the
// time to the next: the times stand in a line of their own. `.` goes on as before, `x` is unknown,
// `=` a box with the next of the texts in `data`. An arrow joins two nodes, each of which is named
// by one character; WaveDrom prints the names that are no capital letters.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "draw/messages.h"
#include "draw/moments.h"
#include "draw/write_drawing.h"
#include "text/joined.h"

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

/// The arrows of causes, and the names of their ends.
class Arrows {
  public:
    Arrows(const Trace& trace, const std::vector<std::size_t>& rows,
           const std::vector<TimingCause>& causes) {
        const auto moment_at = [&](Time at) {
            const auto found = std::find_if(
                rows.begin(), rows.end(), [&](std::size_t row) { return trace.times[row] == at; });
            return static_cast<std::size_t>(found - rows.begin());
        };
        for (const TimingCause& cause : causes) {
            const std::size_t begin = moment_at(cause.at);
            for (const TimingCause::Effect& effect : cause.effects) {
                const Place to{effect.column, moment_at(effect.at)};
                if (begin == rows.size() || to.second == rows.size()) continue;
                const std::string_view shape = begin == to.second ? "->" : "|->";
                for (const std::size_t column : cause.columns) add({column, begin}, shape, to, "");
                if (cause.ended.empty()) continue;
                add({times, begin}, shape, to, joined(cause.ended, ", "));
            }
        }
    }

    /// Adds the names of its ends to a signal; `column`: `times` for the line of the times.
    void add_nodes(Json& signal, std::size_t column, std::size_t moments) const {
        std::string text;
        bool has_any = false;
        for (std::size_t moment = 0; moment < moments; ++moment) {
            const auto node = nodes_.find({column, moment});
            has_any = has_any || node != nodes_.end();
            text += node == nodes_.end() ? "." : node->second;
        }
        if (has_any) signal["node"] = text;
    }
    const Json& edges() const { return edges_; }

    static constexpr std::size_t times = static_cast<std::size_t>(-1);

  private:
    using Place = std::pair<std::size_t, std::size_t>;  ///< column and moment

    /// Empty once all capital letters are taken: Latin, Greek and Cyrillic ones.
    std::string node_at(const Place& place) {
        const auto known = nodes_.find(place);
        if (known != nodes_.end()) return known->second;
        constexpr std::string_view latin = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
        constexpr std::string_view of_two_bytes =
            "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩАБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯ";
        const std::size_t number = nodes_.size();
        if (number < latin.size()) return nodes_[place] = latin[number];
        const std::size_t byte = 2 * (number - latin.size());
        if (byte >= of_two_bytes.size()) return {};
        return nodes_[place] = of_two_bytes.substr(byte, 2);
    }

    void add(const Place& from, std::string_view shape, const Place& to, const std::string& label) {
        const std::string begin = node_at(from);
        const std::string end = node_at(to);
        if (begin.empty() || end.empty()) return;
        edges_.push_back(
            fmt::format("{}{}{}{}{}", begin, shape, end, label.empty() ? "" : " ", label));
    }

    std::map<Place, std::string> nodes_;
    Json edges_ = Json::array();
};

}  // namespace

std::string write_wavedrom(const Trace& trace, std::string_view title, Language language,
                           const std::vector<TimingCause>& causes, TimeScale scale) {
    const std::vector<std::size_t> rows = moments_of(trace, nullptr);
    const Arrows arrows(trace, rows, causes);
    Json times = Json::array();
    for (const std::size_t row : rows) {
        times.push_back(moment_text(trace.times[row], scale, language));
    }
    Json signals = Json::array();
    signals.push_back({{"name", say::time.in(language)},
                       {"wave", std::string(rows.size(), '=')},
                       {"data", std::move(times)}});
    arrows.add_nodes(signals.back(), Arrows::times, rows.size());
    Json group;
    for (std::size_t i = 0; i < trace.columns.size(); ++i) {
        const Kind kind = trace.columns[i].kind;
        if (i == 0 || kind != trace.columns[i - 1].kind) {
            if (!group.is_null()) signals.push_back(std::move(group));
            group = Json::array({group_name(kind).in(language)});
        }
        group.push_back(signal_of(trace, i, rows));
        arrows.add_nodes(group.back(), i, rows.size());
    }
    if (!group.is_null()) signals.push_back(std::move(group));
    Json all{{"signal", std::move(signals)},
             {"head", {{"text", std::string(title)}}},
             {"config", {{"hscale", 2}}}};
    if (!arrows.edges().empty()) all["edge"] = arrows.edges();
    return all.dump(2) + "\n";
}

}  // namespace grafwire
