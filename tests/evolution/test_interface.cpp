#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

namespace {

std::string names_of(const Grafcet& grafcet, const std::vector<TransitionId>& transitions) {
    std::string text;
    for (const TransitionId id : transitions) text += grafcet.transitions[id].name + " ";
    return text;
}

}  // namespace

TEST_CASE("the tables before the first scan") {
    const Grafcet grafcet = grafcet_from(R"(
input a
output o, s
var v
counter c : -2..5
graph G { initial 1 : o  step 2 : set s, set v, c := 1  1 -> 2 : ↑a + ↑/a + 1s/a }
graph H { initial 3 : G{*} }
)");
    const Evolution evolution(grafcet);
    const InputValues inputs = {1, 0, 0, 0};
    const EvolutionState state = evolution.start({inputs});
    BitTable situation(3);
    situation.set(0);
    situation.set(2);
    BitTable both(2);
    both.set(0);
    both.set(1);
    BitTable memory(2);
    memory.set(0);
    CHECK(state.situation == situation);
    CHECK(state.previous == situation);
    CHECK(state.may_evolve == both);
    CHECK(state.stored_outputs == BitTable(2));
    CHECK(state.vars == BitTable(1));
    CHECK(state.counters == std::vector<std::int64_t>{-2});
    CHECK(state.edges == BitTable(2));
    CHECK(state.edge_memory == memory);
    CHECK(state.time_values == BitTable(1));
    CHECK(state.due == std::vector<Time>{never});
}

TEST_CASE("delays are kept as the moment at which they end, and can be ended from outside") {
    const Grafcet grafcet =
        grafcet_from("input a\noutput o\ngraph G { initial 1 : o if 2s/a/3s . 1s/X1 }");
    const Evolution evolution(grafcet);
    InputValues inputs = {1, 0, 0, 0};
    EvolutionState state = evolution.start({inputs});
    evolution.scan(state, {inputs}, 10 * second);
    CHECK(state.due == std::vector<Time>{12 * second, 11 * second});
    evolution.end_delays(state, {inputs}, 11 * second);
    CHECK(state.due == std::vector<Time>{12 * second, never});
    CHECK(state.time_values.test(1));
    REQUIRE(Evolution::is_running(state, 0));
    CHECK_FALSE(Evolution::is_running(state, 1));
    state.due[0] = 0;
    evolution.end_delays(state, {inputs}, 11 * second);
    CHECK(state.time_values.test(0));
    CHECK_FALSE(Evolution::is_running(state, 0));
    evolution.scan(state, {inputs}, 11 * second);
    CHECK(state.due == std::vector<Time>{never, never});
    CHECK(evolution.outputs(state, {inputs}).test(0));
    inputs[0] = 0;
    evolution.scan(state, {inputs}, 20 * second);
    CHECK(state.due == std::vector<Time>{23 * second, never});
    evolution.end_delays(state, {inputs}, 23 * second);
    CHECK_FALSE(state.time_values.test(0));
}

TEST_CASE("the transitions cleared by a scan, in table order, without changing the state") {
    const Grafcet grafcet = grafcet_from(R"(
input a
graph G {
  initial 1  step 2  initial 3
  (late)  3 -> 2 : a
  (early) 1 -> 2 : ↑a
  (never) 2 -> 1 : a
  (from)  -> 1 : a
}
graph H { initial 10 : I{20} }
graph I { step 20  step 21
(over) 20 -> 21 : 1 }
)");
    const Evolution evolution(grafcet);
    InputValues inputs(grafcet.all_input_count(), 0);
    EvolutionState state = evolution.start({inputs});
    CHECK(evolution.cleared_by_scan(state, {inputs}, 0).empty());
    evolution.scan(state, {inputs}, 0);
    inputs[0] = 1;
    const EvolutionState before = state;
    CHECK(names_of(grafcet, evolution.cleared_by_scan(state, {inputs}, 0)) ==
          "late early from over ");
    CHECK(state == before);
    inputs[1] = 1;  // Init
    CHECK(evolution.cleared_by_scan(state, {inputs}, 0).empty());
}

TEST_CASE("the inputs consulted are those that could matter") {
    const Grafcet grafcet = grafcet_from(R"(
input a, b, c, d, e, f
output o, p
graph G {
  initial 1 : o if c . d
  step 2 : p if e
  1 -> 2 : a . b
  2 -> 1 : f
}
)");
    const Evolution evolution(grafcet);
    const auto consulted = [&](InputValues inputs, bool second_step) {
        std::vector<std::uint8_t> in_start(inputs.size());
        std::vector<std::uint8_t> in_scan(inputs.size());
        std::vector<std::uint8_t> in_outputs(inputs.size());
        EvolutionState state = evolution.start({inputs, &in_start});
        if (second_step) {
            state.situation.reset(0);
            state.situation.set(1);
        }
        evolution.scan(state, {inputs, &in_scan}, 0);
        evolution.outputs(state, {inputs, &in_outputs});
        std::string text;
        for (const auto* set : {&in_start, &in_scan, &in_outputs}) {
            for (std::size_t i = 0; i < set->size(); ++i) {
                if ((*set)[i] != 0) text += std::string(input_name(grafcet, i)) + " ";
            }
            text += "| ";
        }
        return text;
    };
    CHECK(consulted({0, 1, 0, 1, 0, 0, 0, 0, 0}, false) == "| a Init AUdur | c | ");
    CHECK(consulted({1, 0, 1, 0, 0, 0, 0, 0, 0}, false) == "| a b Init AUdur | c d | ");
    CHECK(consulted({1, 0, 1, 1, 0, 0, 0, 0, 0}, false) == "| a b Init AUdur | c d AUdoux | ");
    CHECK(consulted({1, 1, 1, 1, 1, 0, 1, 0, 1}, false) == "| Init AUdur | c d AUdoux | ");
    CHECK(consulted({1, 1, 1, 1, 1, 0, 0, 1, 0}, false) == "| a b Init AUdur | | ");
    CHECK(consulted({1, 1, 1, 1, 1, 0, 0, 0, 0}, true) == "| f Init AUdur | e AUdoux | ");
}

TEST_CASE("an Evolution can be moved, and one serves several states") {
    const Grafcet grafcet = grafcet_from("input a graph G { initial 1 step 2 1 -> 2 : a }");
    Evolution first(grafcet);
    const InputValues off = {0, 0, 0, 0};
    const InputValues on = {1, 0, 0, 0};
    EvolutionState one = first.start({off});
    Evolution moved(std::move(first));
    EvolutionState two = moved.start({on});
    moved.scan(one, {off}, 0);
    moved.scan(two, {on}, 0);
    CHECK(one.situation.test(0));
    CHECK(two.situation.test(1));
    CHECK_FALSE(one == two);
    CHECK(&moved.grafcet() == &grafcet);
}

}  // namespace grafwire::testing
