#include "check/partial_inputs.h"
#include "check/witness.h"
#include "netlist/netlists.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

constexpr Logic o = Logic::zero;
constexpr Logic i = Logic::one;
constexpr Logic x = Logic::unknown;

const std::string delayed = R"(
input a
graph G { initial 0 step 1 step 2
  0 -> 1 : a
  1 -> 2 : 3s/X1
  2 -> 0 : 1s/X2 . /a }
)";

std::string timed(const std::string& chart, const std::vector<PathStep>& path) {
    const Grafcet grafcet = grafcet_of(chart);
    const auto stimuli = stimuli_for(grafcet, Assumptions(grafcet), path, 100 * millisecond);
    if (!stimuli) return "impossible";
    return write_stimuli(*stimuli, grafcet);
}

}  // namespace

TEST_CASE("a path becomes stimuli with the lengths of the delays") {
    // Start; a; 3 s are over; 1 s is over; a back to 0.
    CHECK(timed(delayed, {{{o, o, o, o}, {o, o, o, o}, {}},
                          {{o, o, o, o}, {i, o, o, o}, {}},
                          {{i, o, o, o}, {i, o, o, o}, {0}},
                          {{i, o, o, o}, {i, o, o, o}, {1}},
                          {{i, o, o, o}, {o, o, o, o}, {}}}) ==
          "0s :\n100ms : a=1\n4.2s : a=0\n4.2s : end\n");
}

TEST_CASE("a delay that is not to end yet leaves no more time than it takes") {
    // a goes down while the 3 s are still running: 100 ms later.
    CHECK(timed(delayed, {{{i, o, o, o}, {i, o, o, o}, {}}, {{i, o, o, o}, {o, o, o, o}, {}}}) ==
          "0s : a=1\n100ms : a=0\n100ms : end\n");
}

TEST_CASE("delays in an order that their lengths do not allow have no stimuli") {
    const std::string chart = R"(
input a
output lamp
graph G { initial 0 : lamp if 1s/X0 . 5s/X0 }
)";
    const PartialInputs none_set{o, o, o, o};
    CHECK(timed(chart, {{none_set, none_set, {}}, {none_set, none_set, {0}}}) ==
          "0s :\n1s : end\n");
    CHECK(timed(chart, {{none_set, none_set, {}}, {none_set, none_set, {1}}}) == "impossible");
    CHECK(timed(chart, {{none_set, none_set, {}}, {none_set, none_set, {0, 1}}}) == "impossible");
}

TEST_CASE("open inputs are given values that the plant allows") {
    const Grafcet grafcet = grafcet_of(R"(
input a, b, c
assume /(a . b)
assume a + c
graph G { initial 0 0 -> 0 : a . b . c }
)");
    const Assumptions assumptions(grafcet);
    CHECK(assumptions.can_hold({x, x, x, x, x, x}));
    CHECK(assumptions.can_hold({i, x, x, o, o, o}));
    CHECK_FALSE(assumptions.can_hold({i, i, x, o, o, o}));
    CHECK_FALSE(assumptions.can_hold({o, x, o, o, o, o}));
    CHECK_FALSE(assumptions.can_hold({x, i, o, o, o, o}));

    const InputValues preferred{1, 1, 0, 1, 0, 1};
    const InputValues completed{1, 0, 0, 1, 0, 1};
    CHECK(assumptions.complete({x, x, x, x, x, x}, preferred) == completed);
    const InputValues with_b{0, 1, 1, 1, 0, 1};
    CHECK(assumptions.complete({x, i, x, x, x, x}, preferred) == with_b);
    CHECK_FALSE(assumptions.complete({i, i, x, x, x, x}, preferred));
}

TEST_CASE("a replay shows a difference where there is one, and only there") {
    const std::string head = "input a output lamp graph G { initial 0 : lamp if ";
    const Grafcet grafcet = grafcet_of(head + "a }");
    const Netlist right = netlist_of(grafcet, Style::gates);
    const Netlist wrong = netlist_of(grafcet_of(head + "/a }"), Style::gates);
    const auto stimuli = read_stimuli("0s : a=1\n1s : a=0\n5s : end\n", grafcet);
    REQUIRE(stimuli);
    CHECK_FALSE(replay(grafcet, right, unit_delays(right), *stimuli));
    const auto witness = replay(grafcet, wrong, unit_delays(wrong), *stimuli);
    REQUIRE(witness);
    CHECK(witness->kind == DifferenceKind::output);
    CHECK(witness->scan_period == 0);
    // Cut at the first difference.
    CHECK(write_stimuli(witness->stimuli, grafcet) == "0s : a=1\n0s : end\n");
    REQUIRE(witness->values.size() == 2);
    CHECK(witness->values[0].name == "X0");
    CHECK(witness->values[0].got == Logic::one);
    CHECK(witness->values[1].name == "lamp");
    CHECK(witness->values[1].expected == Logic::one);
    CHECK(witness->values[1].got == Logic::zero);
}

}  // namespace grafwire::testing
