// Paper: one sheet while that can be, then several, with names at the links that are cut.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "draw/draw_chart.h"
#include "draw/picture_rules.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

/// So many steps one after the other, the last followed by the first.
Grafcet sequence(int steps) {
    std::string text = "input a\ngraph G {\n initial 0\n";
    for (int i = 1; i < steps; ++i) text += fmt::format("step {}\n", i);
    for (int i = 0; i < steps; ++i) text += fmt::format("{} -> {} : a\n", i, (i + 1) % steps);
    auto read = read_grafcet(text + "}\n");
    REQUIRE(read);
    return std::move(*read);
}

}  // namespace

TEST_CASE("sheets: a short chart takes what it needs, a longer one smaller letters, then sheets") {
    const std::vector<Sheet> small = draw_chart(sequence(5), {});
    REQUIRE(small.size() == 1);
    CHECK(small[0].unit == 8);
    CHECK(small[0].height < 14);
    const std::vector<Sheet> longer = draw_chart(sequence(21), {});
    REQUIRE(longer.size() == 1);
    CHECK(longer[0].unit == 6);
    CHECK(longer[0].height * longer[0].unit <= 277);
    const std::vector<Sheet> large = draw_chart(sequence(200), {});
    CHECK(large.size() > 1);
    for (const Sheet& sheet : large) {
        CHECK(sheet.width * sheet.unit <= 190.001);
        CHECK(sheet.height * sheet.unit <= 277.001);
    }
    ChartDrawing on_a3;
    on_a3.paper = papers[1];
    CHECK(draw_chart(sequence(200), on_a3).size() < large.size());
}

TEST_CASE("sheets: a cut link names the step and its sheet, and the step what leads there") {
    const Grafcet grafcet = sequence(200);
    const Picture picture = read_picture(svg_of(grafcet));
    CHECK(all_faults(grafcet, picture).empty());
    std::string names;
    std::string arrivals;
    for (const PictureGroup* cut : picture.all("cut")) {
        (cut->is("arrival") ? arrivals : names) += cut->words.at(0) + "; ";
    }
    CHECK(names.find(", sheet 2; ") != std::string::npos);
    CHECK(names.find("0, sheet 1; ") != std::string::npos);
    CHECK(arrivals.find(", sheet 1; ") != std::string::npos);
    ChartDrawing french;
    french.language = Language::french;
    CHECK(svg_of(grafcet, french).find(", folio 2") != std::string::npos);
}

TEST_CASE("sheets: one action more in a branch moves nothing in the branches left of it") {
    const auto chart_with = [](const std::string& action) {
        return "input a, b\noutput o, p\ngraph G {\n initial 0\n step 1 : o\n step 2" + action +
               "\n step 3\n0 -> 1 : a\n0 -> 2 : b . /a\n1 -> 3 : a\n2 -> 3 : b\n3 -> 0 : a\n}\n";
    };
    const auto place_of = [&](const std::string& action, const std::string& step) {
        const auto grafcet = read_grafcet(chart_with(action));
        REQUIRE(grafcet);
        const Picture picture = read_picture(svg_of(*grafcet));
        const PictureGroup* found = picture.only("step", "step", step);
        REQUIRE(found != nullptr);
        return std::pair(found->boxes[0].left, found->boxes[0].top);
    };
    CHECK(place_of("", "1") == place_of(" : p", "1"));
    CHECK(place_of("", "0") == place_of(" : p", "0"));
}

TEST_CASE("sheets: a situation shows active steps by a dot, transitions by an arrow") {
    const Grafcet grafcet = sequence(3);
    ChartDrawing how;
    how.situation.active = {false, true, false};
    how.situation.enabled = {false, true, false};
    how.situation.clearable = {false, true, false};
    how.situation.caption = "now";
    const Picture picture = read_picture(svg_of(grafcet, how));
    CHECK(picture.only("step", "step", "1")->is("active"));
    CHECK(picture.only("step", "step", "1")->marks.size() == 1);
    CHECK(picture.only("step", "step", "0")->marks.empty());
    CHECK(picture.only("transition", "transition", "(1)")->is("clearable"));
    CHECK(picture.only("transition", "transition", "(1)")->marks.size() == 1);
    CHECK(picture.only("transition", "transition", "(0)")->marks.empty());
    CHECK(picture.all("title").at(0)->words.at(0) == "grafcet – now");
}

TEST_CASE("sheets: for a page, every step has its dot and every transition its arrow") {
    const Grafcet grafcet = sequence(3);
    ChartDrawing how;
    how.animated = true;
    const Picture picture = read_picture(svg_of(grafcet, how));
    for (const Step& step : grafcet.steps) {
        CHECK(picture.only("token", "step", step.name)->marks.size() == 1);
        CHECK(picture.only("step", "step", step.name)->marks.empty());
    }
    for (const Transition& transition : grafcet.transitions) {
        const std::string name = '(' + transition.name + ')';
        CHECK(picture.only("token", "transition", name)->marks.size() == 1);
        CHECK(!picture.only("transition", "transition", name)->is("enabled"));
    }
}

}  // namespace grafwire::testing
