// Charts drawn, and measured in the SVG file.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "draw/draw_chart.h"
#include "draw/picture_rules.h"
#include "random/random_grafcet.h"
#include "random/read_text.h"
#include "support/chart_files.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

Grafcet chart(const std::string& text) {
    auto read = read_grafcet(text);
    REQUIRE(read);
    return std::move(*read);
}

}  // namespace

TEST_CASE("drawing: the examples, as a teacher would print them") {
    for (const ChartFiles& example : example_charts()) {
        CAPTURE(example.name);
        const Grafcet grafcet = chart(example.chart);
        const std::string svg = svg_of(grafcet);
        const Picture picture = read_picture(svg);
        CHECK(told(all_faults(grafcet, picture)) == "");
        CHECK(crossings(picture) == 0);
        CHECK(picture.all("cut").empty());
        CHECK(svg_of(grafcet) == svg);
    }
}

TEST_CASE("drawing: random charts") {
    RandomSource random(20260117);
    for (int i = 0; i < (is_slow_build ? 40 : 500); ++i) {
        Features features;
        features.steps = 2 + static_cast<std::size_t>(i) % 30;
        features.plain = i % 3 == 0;
        const std::string text = random_grafcet(random, features);
        const Grafcet grafcet = chart(text);
        const std::string faults = told(all_faults(grafcet, read_picture(svg_of(grafcet))));
        if (faults.empty()) continue;
        CAPTURE(i);
        CAPTURE(text);
        CHECK(faults == "");
        break;
    }
}

}  // namespace grafwire::testing
