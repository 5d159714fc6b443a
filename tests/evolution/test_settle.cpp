#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

namespace {

/// The number of repetitions at the instant 0; 0 where there is no stable situation.
std::uint32_t repetitions_at_start(std::string_view text, std::vector<std::uint8_t> inputs) {
    const Grafcet grafcet = grafcet_from(text);
    inputs.resize(grafcet.all_input_count(), 0);
    const Evolution evolution(grafcet);
    EvolutionState state = evolution.start({inputs});
    const SettleResult result = evolution.settle(state, {inputs}, 0);
    return result.stable ? result.repetitions : 0;
}

}  // namespace

TEST_CASE("the last repetition is one without edges that changes nothing") {
    CHECK(repetitions_at_start("graph G { initial 1 }", {}) == 1);
    CHECK(repetitions_at_start("graph G { initial 1 step 2 step 3 1 -> 2 : 1 2 -> 3 : 1 }", {}) ==
          3);
    // A loop on one step changes nothing.
    CHECK(repetitions_at_start("graph G { initial 1 1 -> 1 : 1 }", {}) == 1);
    // X2 comes up in the first repetition, ↑X2 in the second, which is therefore not the last,
    // though it leaves everything as it was.
    CHECK(repetitions_at_start("graph G { initial 1 step 2 1 -> 2 : 1 2 -> 1 : ↑X2 . 0 }", {}) ==
          3);
    // The freeze bit of B changes in the first repetition.
    CHECK(repetitions_at_start("graph A { initial 0 : B{*} } graph B { initial 10 }", {}) == 2);
    // A time condition without delay, on an input: only its value changes.
    CHECK(repetitions_at_start("input a graph G { initial 1 step 2 1 -> 2 : 0s/a . 0 }", {1}) == 2);
    CHECK(repetitions_at_start("input a graph G { initial 1 step 2 1 -> 2 : 1s/a . 0 }", {1}) == 1);
}

TEST_CASE("whoever waits for a stable situation is asked now and then, and can break off") {
    const Grafcet grafcet =
        grafcet_from("counter c : 0..20000 graph G { initial 1 1 -> 1 : 1 do c := c + 1 }");
    const Evolution evolution(grafcet);
    const std::vector<std::uint8_t> inputs(grafcet.all_input_count(), 0);
    for (const int patience : {1, 2, 1000}) {
        int asked = 0;
        EvolutionState state = evolution.start({inputs});
        const SettleResult result =
            evolution.settle(state, {inputs}, 0, [&] { return ++asked < patience; });
        CHECK(result.broken_off == (patience != 1000));
        CHECK(result.stable);
        if (result.broken_off) {
            CHECK(asked == patience);
            CHECK(result.repetitions < 20001);
        } else {
            CHECK(result.repetitions == 20001);
        }
    }
}

TEST_CASE("a long way to a stable situation is walked to its end") {
    CHECK(repetitions_at_start(
              "counter c : 0..20000 graph G { initial 1 1 -> 1 : 1 do c := c + 1 }", {}) == 20001);
}

TEST_CASE("an instant without a stable situation names what keeps changing, and ends the run") {
    const char* const grafcet = R"(
input a, b
output o, "steady out"
var v, w
counter c : 0..2
counter d : 0..9
graph G {
  initial 1
  step 2 : set "steady out"
  step 3 : set o, v := /v, c := c + 1, d := d + 1
  step 4 : reset o, c := 0
  1 -> 2 : a
  2 -> 3 : b
  3 -> 4 : 1
  4 -> 3 : 1
}
)";
    // d stops at 9, w is never written, 1 and 2 are left for good.
    CHECK(until_stable(grafcet, "10ms : a=1\n 20ms : b=1\n 30ms : a=0", "X1 X2 X3") == R"(
0 1 0 0
10 0 1 0
unstable at 20: X3 X4 o v c
)");
    // Scan by scan there is no such thing.
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : b=1\n 40ms : end", 10 * millisecond, "X3 X4 v d") ==
          R"(
0 0 0 0 0
10 0 0 0 0
20 1 0 1 1
30 0 1 1 1
40 1 0 0 2
)");
}

TEST_CASE("no stable situation: only what is on the cycle is named, not the way there") {
    const char* const grafcet = R"(
graph G {
  initial 1  step 2  step 3  step 4  step 5
  1 -> 2 : 1   2 -> 3 : 1   3 -> 4 : 1   4 -> 5 : 1   5 -> 3 : 1
}
)";
    CHECK(until_stable(grafcet, "0s : end", "X1") == "\nunstable at 0: X3 X4 X5\n");
}

TEST_CASE("a cycle through forcing and through time conditions without delay") {
    CHECK(until_stable(R"(
graph A { initial 0  step 1 : B{11}  0 -> 1 : X10  1 -> 0 : X11 }
graph B { initial 10  step 11  11 -> 10 : 1 }
)",
                       "1s : end", "X0") == "\nunstable at 0: X0 X1 X10 X11\n");
    CHECK(until_stable(R"(
input a
graph A { initial 0  step 1  0 -> 1 : a . /(0s/X1)  1 -> 0 : 0s/X1 }
)",
                       "1s : a=1\n 2s : end", "X0") == "\n0 1\nunstable at 1000: X0 X1\n");
}

TEST_CASE("is_settled compares what the next scan reads, and wants no edge") {
    const Grafcet grafcet = grafcet_from(R"(
input a
var v
counter c : 0..3
output o
graph A { initial 0 : B{*}, set v on ↑a, c := 1 on 1s/a, set o on ↑a }
graph B { initial 10 }
)");
    const Evolution evolution(grafcet);
    const InputValues inputs(grafcet.all_input_count(), 0);
    const EvolutionState before = evolution.start({inputs});
    CHECK(Evolution::is_settled(before, before));
    const auto differs = [&](auto&& change) {
        EvolutionState after = before;
        change(after);
        return !Evolution::is_settled(before, after);
    };
    CHECK(differs([](EvolutionState& s) { s.situation.reset(0); }));
    CHECK(differs([](EvolutionState& s) { s.may_evolve.reset(1); }));
    CHECK(differs([](EvolutionState& s) { s.vars.set(0); }));
    CHECK(differs([](EvolutionState& s) { s.stored_outputs.set(0); }));
    CHECK(differs([](EvolutionState& s) { s.counters[0] = 1; }));
    CHECK(differs([](EvolutionState& s) { s.time_values.set(0); }));
    CHECK(differs([](EvolutionState& s) { s.edges.set(0); }));
    CHECK_FALSE(differs([](EvolutionState& s) { s.edge_memory.set(0); }));
    CHECK_FALSE(differs([](EvolutionState& s) { s.due[0] = 5; }));
    CHECK_FALSE(differs([](EvolutionState& s) { s.previous.reset(0); }));
}

}  // namespace grafwire::testing
