#include "check/check_equivalence.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

NeverExercised never_of(const std::string& chart, Style style, bool has_modes = true) {
    const Grafcet grafcet = grafcet_of(chart);
    const Netlist netlist = netlist_of(grafcet, style, has_modes);
    return check_equivalence(grafcet, netlist, {}).never;
}

}  // namespace

TEST_CASE("the first of everything may be what is never exercised") {
    // b, dark, step 0 and its two transitions; Init sets step 1 alone.
    const std::string chart = R"(
input b, a
output dark, lamp
assume /b
graph G { step 0 : dark initial 1 : lamp step 2
  (off) 1 -> 0 : b
  (again) 0 -> 1 : a
  (go) 1 -> 2 : a
  (back) 2 -> 1 : /a })";
    for (const Style style : {Style::nand, Style::clocked}) {
        const NeverExercised never = never_of(chart, style);
        CHECK(never.steps == std::vector<StepId>{StepId{0}});
        CHECK(never.transitions == std::vector<TransitionId>{TransitionId{0}, TransitionId{1}});
        CHECK(never.inputs == std::vector<std::uint32_t>{0});
        CHECK(never.outputs == std::vector<OutputId>{OutputId{0}});
    }
}

TEST_CASE("without modes the control inputs are not said to be unexercised") {
    const std::string chart = "input a output lamp graph G { initial 0 step 1 : lamp 0 -> 1 : a }";
    for (const bool has_modes : {true, false}) {
        CHECK(never_of(chart, Style::nand, has_modes) == NeverExercised{});
    }
}

TEST_CASE("an input that stays at one value is unexercised, whichever that is") {
    for (const char* assumption : {"assume a ", "assume /a "}) {
        const NeverExercised never =
            never_of("input a, b output lamp " + std::string(assumption) +
                         "graph G { initial 0 step 1 : lamp 0 -> 1 : b 1 -> 0 : /b . /(a . b) }",
                     Style::nand);
        CHECK(never.inputs == std::vector<std::uint32_t>{0});
    }
}

TEST_CASE("an input that nothing reads may have any value, and so has had both") {
    for (const Style style : {Style::nand, Style::clocked}) {
        CHECK(never_of("input a, unread output lamp graph G { initial 0 step 1 : lamp 0 -> 1 : a }",
                       style) == NeverExercised{});
    }
}

TEST_CASE("a step that is active for a single scan is exercised") {
    const NeverExercised never = never_of(R"(
input a
output lamp
graph G { initial 0 step 1 step 2 : lamp
  0 -> 1 : a
  1 -> 2 : =1
  2 -> 0 : /a })",
                                          Style::clocked);
    CHECK(never == NeverExercised{});
}

}  // namespace grafwire::testing
