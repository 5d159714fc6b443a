// What each style is made to get right, in charts so small that the check says so in a moment. The
// examples would show it as well, but only as other gates in netlists/.

#include "check/check_equivalence.h"
#include "support/small_netlists.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

void is_equivalent_in(const std::string& chart, const std::vector<Style>& styles) {
    const Grafcet grafcet = grafcet_of(chart);
    for (const Style style : styles) {
        if (style == Style::handshake && refused_by_handshake(grafcet)) continue;
        for (const bool has_modes : {true, false}) {
            const Netlist netlist = netlist_of(grafcet, style, has_modes);
            INFO(style_table[static_cast<std::size_t>(style)].name << (has_modes ? ", modes" : ""));
            CheckOptions options;
            options.looks_at_many = false;
            const CheckResult result = check_equivalence(grafcet, netlist, options);
            CHECK(result.verdict == Verdict::equivalent);
            CHECK(result.coverage.cases > result.coverage.unstable);
        }
    }
}

void is_equivalent_in_every_style(const std::string& chart) {
    is_equivalent_in(chart, all_styles());
}

}  // namespace

TEST_CASE("a netlist is right under the delays that it is made for") {
    const Grafcet grafcet = grafcet_of(R"(
input a
output v
graph G {
  initial 0
  step 1 : v
  step 2
  0 -> 1 : ↑a
  1 -> 2 : ↓a
  2 -> 0 : ↑a
}
)");
    const Equations equations = equations_from(grafcet, {});
    CheckOptions options;
    options.delays.gate = {3 * nanosecond, 3 * nanosecond};
    for (const Style style : asynchronous_styles()) {
        Diagnostics diagnostics;
        const auto right = netlist_from(grafcet, equations, style, diagnostics, options.delays);
        CHECK(check_equivalence(grafcet, *right, options).verdict == Verdict::equivalent);
        if (style == Style::handshake) continue;  // no pulses
        // Pulses that are too short set nothing.
        const auto hasty = netlist_from(grafcet, equations, style, diagnostics, {});
        CHECK(check_equivalence(grafcet, *hasty, options).verdict == Verdict::different);
    }
}

TEST_CASE("a source transition whose receptivity is always true sets its step for good") {
    is_equivalent_in_every_style(R"(
input a
output lamp
graph G { initial 0 step 1 : lamp
  -> 1 : =1
  0 -> : a })");
}

TEST_CASE("an order that lists a step outweighs Init and yields to AUdur") {
    is_equivalent_in_every_style(R"(
input a, b, c
output lamp
graph G1 { initial 0 step 1 : lamp step 2
  0 -> 1 : a
  1 -> 2 : b
  2 -> 0 : c }
graph G2 { initial 10 step 11 : G1{1} step 12
  10 -> 11 : c
  11 -> 12 : b
  12 -> 10 : a })");
}

TEST_CASE("a freezing order and an empty one") {
    is_equivalent_in_every_style(R"(
input a, b, c
output lamp
graph G1 { initial 0 step 1 : lamp step 2
  0 -> 1 : a
  1 -> 2 : b
  2 -> 0 : c }
graph G2 { initial 10 step 11 : G1{*} step 12 : G1{}
  10 -> 11 : c
  11 -> 12 : b
  12 -> 10 : a })");
}

TEST_CASE("the pulse of an edge is long enough to set a step, and too short for two") {
    is_equivalent_in_every_style(R"(
input a
output lamp
graph G { initial 0 step 1 : lamp step 2
  0 -> 1 : ↑a
  1 -> 2 : ↑a
  2 -> 0 : ↓a })");
}

TEST_CASE("a delay that ends as an input deactivates its step has ended") {
    // Both transitions are cleared then, and 2 and 3 active together.
    const std::string chart = R"(
input a, b
output lamp, horn
graph G { initial 0 step 1 step 2 : lamp step 3 : horn
  0 -> 1 : a
  1 -> 2 : 2s/X1
  1 -> 3 : b
  2 -> 0 : /a . /b
  3 -> : /a . /b })";
    const Grafcet grafcet = grafcet_of(chart);
    const Netlist netlist = netlist_of(grafcet, Style::nand, false);
    for (const Changes changes : {Changes::one, Changes::many}) {
        CheckOptions options;
        options.changes = changes;
        const CheckResult result = check_changes(grafcet, netlist, options);
        CHECK(result.verdict == Verdict::equivalent);
        // Alone, 2 or 3 follow 1; together under Changes::many only.
        CHECK(result.coverage.situations == (changes == Changes::one ? 5 : 6));
    }
}

TEST_CASE("an edge that clears simultaneous sequences together") {
    is_equivalent_in_every_style(R"(
input a, b
output lamp
graph G { initial 0 step 1 step 2 : lamp step 3 step 4
  0 -> 1, 2 : ↑a
  1 -> 3 : ↑a
  3, 2 -> 4 : ↓b
  4 -> 0 : b })");
}

}  // namespace grafwire::testing
