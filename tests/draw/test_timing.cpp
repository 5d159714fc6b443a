// Runs as timing diagrams, measured in the SVG file, and as WaveJSON.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "draw/picture_rules.h"
#include "draw/timing_diagram.h"
#include "draw/write_drawing.h"

namespace grafwire::testing {

namespace {

using Kind = Trace::Column::Kind;

/// A run of an input, two control inputs, two steps, an output and a counter; a row is a time in
/// milliseconds and the values.
Trace run_with(const std::vector<std::vector<std::int64_t>>& rows) {
    Trace trace;
    trace.columns = {{"a", 1, Kind::input},   {"Init", 1, Kind::input}, {"AUdur", 1, Kind::input},
                     {"X1", 1, Kind::step},   {"X2", 1, Kind::step},    {"été", 1, Kind::output},
                     {"c", 4, Kind::internal}};
    for (const std::vector<std::int64_t>& row : rows) {
        trace.times.push_back(row.front() * millisecond);
        trace.values.insert(trace.values.end(), row.begin() + 1, row.end());
    }
    return trace;
}

const Trace& short_run() {
    static const Trace trace = run_with({{0, 0, 0, 0, 1, 0, 0, 0},
                                         {100, 1, 0, 0, 0, 1, 1, 1},
                                         {150, 1, 0, 0, 0, 1, 1, 1},
                                         {300, 0, 1, 0, 1, 0, 0, 12},
                                         {400, 0, 0, 0, 1, 0, 0, 12}});
    return trace;
}

Picture picture_of(const Trace& trace, std::size_t* sheets = nullptr,
                   Language language = Language::english) {
    TimingDrawing how;
    how.title = "run";
    how.language = language;
    const std::vector<Sheet> drawn = draw_timing(trace, how);
    if (sheets != nullptr) *sheets = drawn.size();
    return read_picture(write_svg_drawing(drawn, how.title, how.paper, language));
}

/// The levels of a signal from left to right, one for each level line: `0`, `1`; and what its boxes
/// say.
std::string shown_values(const Picture& picture, const std::string& name) {
    std::string shown;
    for (const PictureGroup* signal : picture.all("signal")) {
        if (signal->fact("signal") != name) continue;
        double low = 0;
        for (const Stroke& stroke : signal->strokes) low = std::max(low, stroke.y1);
        for (const Stroke& stroke : signal->strokes) {
            if (stroke.is_heavy && stroke.is_level()) shown += stroke.y1 < low ? '1' : '0';
        }
        for (std::size_t i = 1; i < signal->words.size(); ++i) shown += signal->words[i] + ' ';
    }
    return shown;
}

/// Boxes hide the dashed lines below them.
Faults faults_of(const Picture& picture) {
    Faults faults = crowded_texts(picture);
    std::erase_if(faults, [](const std::string& fault) {
        return fault.find("lies on a line of moment") != std::string::npos;
    });
    return faults;
}

std::vector<std::string> times_of(const Picture& picture) {
    std::vector<std::string> times;
    for (const PictureGroup* moment : picture.all("moment")) times.push_back(moment->words.at(0));
    return times;
}

}  // namespace

TEST_CASE("timing: a line for each signal, boxes for counters and situations") {
    const Picture picture = picture_of(short_run());
    CHECK(shown_values(picture, "a") == "010");
    CHECK(shown_values(picture, "Init") == "010");
    CHECK(shown_values(picture, "X1") == "101");
    CHECK(shown_values(picture, "été") == "010");
    CHECK(shown_values(picture, "c") == "0 1 12 ");
    CHECK(shown_values(picture, "Situation") == "{1} {2} {1} ");
    // What stays 0 all the time is left out, of control inputs.
    CHECK(shown_values(picture, "AUdur").empty());
    CHECK(faults_of(picture).empty());
}

TEST_CASE("timing: moments without change have no place; time is to scale where that can be") {
    const Picture picture = picture_of(short_run());
    CHECK(times_of(picture) == std::vector<std::string>{"0s", "100ms", "300ms", "400ms"});
    const auto moments = picture.all("moment");
    const double first = moments[1]->strokes[0].x1 - moments[0]->strokes[0].x1;
    const double second = moments[2]->strokes[0].x1 - moments[1]->strokes[0].x1;
    CHECK(second == doctest::Approx(2 * first));
    CHECK(picture.all("title")[0]->words.size() == 1);
    // A wait of an hour between them: side by side, and said.
    const Picture long_wait = picture_of(run_with(
        {{0, 0, 0, 0, 1, 0, 0, 0}, {100, 1, 0, 0, 1, 0, 0, 0}, {3'600'000, 0, 0, 0, 1, 0, 0, 0}}));
    const auto apart = long_wait.all("moment");
    CHECK(apart[1]->strokes[0].x1 - apart[0]->strokes[0].x1 ==
          doctest::Approx(apart[2]->strokes[0].x1 - apart[1]->strokes[0].x1));
    CHECK(long_wait.all("title")[0]->words.at(1).find("not to scale") != std::string::npos);
}

TEST_CASE("timing: long runs are folded into strips, with the names before each, and sheets") {
    std::vector<std::vector<std::int64_t>> rows;
    for (std::int64_t i = 0; i < 100; ++i) rows.push_back({i * i, i % 2, 0, 0, 1, 0, 0, i % 16});
    std::size_t sheets = 0;
    const Trace trace = run_with(rows);
    const Picture picture = picture_of(trace, &sheets, Language::french);
    CHECK(sheets > 1);
    CHECK(times_of(picture).size() == 100);
    CHECK(times_of(picture).back() == "9,801\u00a0s");
    std::size_t strips = 0;
    for (const PictureGroup* signal : picture.all("signal")) {
        strips += signal->fact("signal") == "a" ? 1 : 0;
    }
    CHECK(strips > sheets);
    CHECK(faults_of(picture).empty());
    CHECK(picture.all("title").size() == sheets);
}

TEST_CASE("timing: an unknown value is neither 0 nor 1") {
    const Trace trace = run_with({{0, 0, 0, 0, Trace::unknown, Trace::unknown, 0, Trace::unknown},
                                  {100, 0, 0, 0, 1, 0, 0, 3}});
    const Picture picture = picture_of(trace);
    CHECK(shown_values(picture, "X1") == "1x ");
    CHECK(shown_values(picture, "c") == "x 3 ");
    CHECK(shown_values(picture, "Situation") == "{1?,2?} {1} ");
    const std::string svg = write_svg_drawing(draw_timing(trace, {}), "run", papers[0], {});
    CHECK(svg.find("<rect class=\"unknown\" fill=\"#808080\"") != std::string::npos);
}

TEST_CASE("timing: two runs, with a second line where they differ") {
    Trace found = short_run();
    found.values[2 * found.columns.size() + 4] = 0;  // X2 at 150 ms
    TimingDrawing how;
    how.title = "run";
    how.other = &found;
    const Picture picture =
        read_picture(write_svg_drawing(draw_timing(short_run(), how), how.title, how.paper, {}));
    CHECK(shown_values(picture, "X2") == "010");
    CHECK(shown_values(picture, "X2 found") == "010! ");
    CHECK(shown_values(picture, "X1 found").empty());
    CHECK(times_of(picture).size() == 5);
    CHECK(faults_of(picture).empty());
}

TEST_CASE(
    "timing: a run that ends early is unknown from there on; one without an instant is empty") {
    Trace found = short_run();
    found.times.resize(3);
    found.values.resize(3 * found.columns.size());
    TimingDrawing how;
    how.title = "run";
    how.other = &found;
    const Picture picture =
        read_picture(write_svg_drawing(draw_timing(short_run(), how), how.title, how.paper, {}));
    CHECK(shown_values(picture, "X2 found") == "01x x ! ! ");
    const Picture empty = picture_of(run_with({}));
    CHECK(empty.all("signal").empty());
    CHECK(empty.all("title").size() == 1);
}

TEST_CASE("timing: causes are dotted lines, from what changed to what followed") {
    TimingDrawing how;
    how.title = "run";
    // a begins X1, X2, été and c at 100 ms; a delay X1 and the same again at 300 ms.
    how.causes = {{100 * millisecond,
                   {0},
                   {},
                   {{3, 100 * millisecond}, {4, 100 * millisecond}, {5, 100 * millisecond}}},
                  {300 * millisecond, {}, {"200ms/X2"}, {{3, 300 * millisecond}}},
                  // Neither of these has a place: no effect, no such moment.
                  {400 * millisecond, {1}, {}, {}},
                  {170 * millisecond, {1}, {}, {{3, 170 * millisecond}}}};
    const Picture picture =
        read_picture(write_svg_drawing(draw_timing(short_run(), how), how.title, how.paper, {}));
    const auto causes = picture.all("cause");
    REQUIRE(causes.size() == 2);
    const auto moments = picture.all("moment");
    CHECK(moments[2]->words == std::vector<std::string>{"300ms", "200ms/X2"});
    const PictureGroup& by_input = *causes[0];
    CHECK(by_input.fact("time") == "100ms");
    REQUIRE(by_input.strokes.size() == 1);
    CHECK(by_input.strokes[0].is_upright());
    CHECK(by_input.strokes[0].x1 == moments[1]->strokes[0].x1);
    CHECK(by_input.marks.size() == 4);  // a dot and three heads of arrows
    const PictureGroup& a = *picture.only("signal", "signal", "a");
    const PictureGroup& output = *picture.only("signal", "signal", "été");
    const double begin = by_input.strokes[0].area().top;
    const double end = by_input.strokes[0].area().bottom;
    CHECK((begin > a.texts[0].top && begin < a.texts[0].bottom));
    CHECK((end > a.texts[0].bottom && end < output.strokes[0].area().bottom));
    // The dashed line of the moment leaves room for it.
    for (const Stroke& aid : moments[1]->strokes) {
        CHECK((aid.area().bottom <= begin || aid.area().top >= end));
    }
    CHECK(causes[1]->marks.size() == 1);
    CHECK(faults_of(picture).empty());
}

TEST_CASE("timing: an effect that comes later is at the end of a level line") {
    TimingDrawing how;
    how.title = "run";
    how.causes = {{100 * millisecond, {0}, {}, {{3, 300 * millisecond}}},
                  {100 * millisecond, {4}, {}, {{3, 300 * millisecond}}}};
    const Picture picture =
        read_picture(write_svg_drawing(draw_timing(short_run(), how), how.title, how.paper, {}));
    const auto causes = picture.all("cause");
    REQUIRE(causes.size() == 2);
    const double later = picture.all("moment")[2]->strokes[0].x1;
    for (const PictureGroup* cause : causes) {
        REQUIRE(cause->strokes.size() == 2);
        CHECK(cause->strokes[0].is_upright());
        CHECK(cause->strokes[1].is_level());
        CHECK(cause->marks.back().right == doctest::Approx(later));
    }
    // Side by side.
    CHECK(causes[0]->strokes[0].x1 < causes[1]->strokes[0].x1);
}

namespace {

/// An instant: an input, a gate that becomes unknown, a step, an output; times in nanoseconds.
Trace instant_with(const std::vector<std::vector<std::int64_t>>& rows) {
    Trace trace;
    trace.columns = {{"a", 1, Kind::input},
                     {"X1$set0", 1, Kind::internal},
                     {"X1", 1, Kind::step},
                     {"P", 1, Kind::output}};
    for (const std::vector<std::int64_t>& row : rows) {
        trace.times.push_back(row.front() * nanosecond);
        trace.values.insert(trace.values.end(), row.begin() + 1, row.end());
    }
    return trace;
}

Picture picture_of_instant(const Trace& trace, std::vector<TimingCause> causes = {}) {
    TimingDrawing how;
    how.title = "instant";
    how.causes = std::move(causes);
    how.scale = TimeScale::nanoseconds;
    return read_picture(write_svg_drawing(draw_timing(trace, how), how.title, how.paper, {}));
}

const Trace& short_instant() {
    static const Trace trace = instant_with({{-1, 0, 0, 0, 0},
                                             {0, 1, 0, 0, 0},
                                             {1, 1, Trace::unknown, 0, 0},
                                             {2, 1, 1, 1, 0},
                                             {5, 1, 1, 1, 1}});
    return trace;
}

}  // namespace

TEST_CASE("timing: within an instant there is an axis, to scale, and the level before it") {
    const Picture picture = picture_of_instant(
        short_instant(), {{0, {0}, {}, {{1, nanosecond}}}, {0, {}, {"5s/X1"}, {{0, 0}}}});
    CHECK(shown_values(picture, "a") == "01");
    CHECK(shown_values(picture, "X1$set0") == "01x ");
    CHECK(picture.only("signal", "signal", "Situation") == nullptr);
    const PictureGroup& axis = *picture.all("axis").at(0);
    CHECK(axis.words == std::vector<std::string>{"0", "1", "2", "3", "4", "5", "6", "ns"});
    // Every moment has its line at its tick, that before the instant has none.
    const auto moments = picture.all("moment");
    REQUIRE(moments.size() == 4);
    const std::size_t ticks[] = {0, 1, 2, 5};
    for (std::size_t i = 0; i < moments.size(); ++i) {
        CHECK(moments[i]->strokes.back().x1 ==
              doctest::Approx(axis.strokes[1 + ticks[i]].x1).epsilon(0.001));
        CHECK(moments[i]->fact("time") == fmt::format("{}ns", ticks[i]));
    }
    CHECK(picture.only("signal", "signal", "a")->strokes[0].x1 < moments[0]->strokes[0].x1);
    // The axis is below everything else, the delay that ended above the lines.
    for (const PictureGroup* signal : picture.all("signal")) {
        for (const Stroke& stroke : signal->strokes) CHECK(stroke.y1 < axis.strokes[0].y1);
        CHECK(signal->texts[0].top > moments[0]->texts.at(0).bottom);
    }
    CHECK(moments[0]->words == std::vector<std::string>{"5s/X1"});
    CHECK(faults_of(picture).empty());
}

TEST_CASE("timing: a long instant is folded, and the axis goes on") {
    std::vector<std::vector<std::int64_t>> rows = {{-1, 0, 0, 0, 0}};
    for (std::int64_t i = 0; i < 60; ++i) rows.push_back({i, i % 2, 0, 0, 0});
    const Picture picture = picture_of_instant(instant_with(rows));
    const auto axes = picture.all("axis");
    REQUIRE(axes.size() > 1);
    CHECK(axes[0]->words.front() == "0");
    CHECK(std::find(axes[1]->words.begin(), axes[1]->words.end(), "30") != axes[1]->words.end());
    for (const PictureGroup* axis : axes) CHECK(axis->strokes[0].x2 < picture.width);
    CHECK(faults_of(picture).empty());
    // Without a change there is an axis alone.
    const Picture quiet = picture_of_instant(instant_with({{-1, 0, 0, 0, 0}}));
    CHECK(quiet.all("moment").empty());
    CHECK(quiet.all("axis").size() == 1);
}

TEST_CASE("timing: many causes at a moment stand closer") {
    std::vector<TimingCause> causes(20, {0, {0}, {}, {{1, nanosecond}}});
    const Picture picture = picture_of_instant(short_instant(), causes);
    const double next = picture.all("moment").at(1)->strokes.back().x1;
    const auto shown = picture.all("cause");
    REQUIRE(shown.size() == causes.size());
    for (const PictureGroup* cause : shown) {
        CHECK(cause->strokes[0].x1 < next);
        CHECK(cause->strokes[1].x1 < cause->strokes[1].x2);
    }
}

TEST_CASE("WaveDrom: an instant has its times in nanoseconds") {
    const auto json = nlohmann::ordered_json::parse(
        write_wavedrom(short_instant(), "instant", Language::french, {}, TimeScale::nanoseconds));
    CHECK(json["signal"][0]["data"] ==
          nlohmann::ordered_json{"avant", "0\u00a0ns", "1\u00a0ns", "2\u00a0ns", "5\u00a0ns"});
    CHECK(json["signal"][2][1]["wave"] == "0.x1.");
}

TEST_CASE("WaveDrom: arrows lead from causes to effects") {
    const std::vector<TimingCause> causes = {
        {100 * millisecond, {0}, {}, {{3, 100 * millisecond}, {5, 300 * millisecond}}},
        {300 * millisecond, {}, {"2s/a"}, {{3, 300 * millisecond}}}};
    const auto json = nlohmann::ordered_json::parse(
        write_wavedrom(short_run(), "run", Language::english, causes));
    CHECK(json["edge"] == nlohmann::ordered_json{"A->B", "A|->C", "D->E 2s/a"});
    CHECK(json["signal"][0]["node"] == "..D.");
    CHECK(json["signal"][1][1]["node"] == ".A..");
    CHECK(json["signal"][2][1]["node"] == ".BE.");
    CHECK(json["signal"][3][1]["node"] == "..C.");
}

TEST_CASE("WaveDrom: a period for each moment, groups, and the texts of boxes") {
    const auto json =
        nlohmann::ordered_json::parse(write_wavedrom(short_run(), "run", Language::english));
    CHECK(json["head"]["text"] == "run");
    const auto& signals = json["signal"];
    REQUIRE(signals.size() == 5);
    CHECK(signals[0]["data"] == nlohmann::ordered_json{"0s", "100ms", "300ms", "400ms"});
    CHECK(signals[1][0] == "inputs");
    CHECK(signals[1][1] == nlohmann::ordered_json{{"name", "a"}, {"wave", "010."}});
    CHECK(signals[2][1] == nlohmann::ordered_json{{"name", "X1"}, {"wave", "101."}});
    CHECK(signals[3][1] == nlohmann::ordered_json{{"name", "été"}, {"wave", "010."}});
    CHECK(signals[4][1] ==
          nlohmann::ordered_json{{"name", "c"}, {"wave", "===."}, {"data", {"0", "1", "12"}}});
}

}  // namespace grafwire::testing
