// The random charts are worth something, and the shrinker makes them small.

#include <doctest/doctest.h>

#include <algorithm>

#include "evolution/run.h"
#include "grafcet/grafcet_builder.h"
#include "random/random_cases.h"
#include "random/random_grafcet.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

/// Whether something besides the inputs changes in the course of a run.
bool is_alive(const Grafcet& grafcet, const Trace& trace) {
    const std::size_t columns = trace.columns.size();
    for (std::size_t i = columns; i < trace.values.size(); ++i) {
        const bool is_input = i % columns < grafcet.all_input_count();
        if (!is_input && trace.values[i] != trace.values[i - columns]) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("random charts hold every part of the language, and most of them move") {
    std::size_t alive = 0;
    std::size_t unstable = 0;
    std::size_t macros = 0;
    std::size_t nested = 0;
    std::size_t enclosures = 0;
    std::size_t counters = 0;
    std::size_t sources = 0;
    std::size_t off_delays = 0;
    std::vector<std::size_t> orders(4);
    std::vector<std::size_t> triggers(3);
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const RandomCase item = random_case(seed, Features(), 25);
        const auto grafcet = read_grafcet(item.chart);
        CHECK(fault_of(*grafcet) == "");
        const RunResult run = run_until_stable(*grafcet, *read_stimuli(item.stimuli, *grafcet));
        alive += is_alive(*grafcet, run.trace);
        unstable += run.unstable_at.has_value();
        macros += grafcet->macros.size();
        for (const Macro& macro : grafcet->macros) {
            nested += grafcet->blocks[macro.block].is_expansion;
        }
        enclosures += grafcet->enclosures.size();
        counters += grafcet->counters.size();
        for (const Order& order : grafcet->orders) ++orders[static_cast<std::size_t>(order.kind)];
        for (const Action& action : grafcet->actions) {
            if (action.kind == ActionKind::stored) {
                ++triggers[static_cast<std::size_t>(action.trigger)];
            }
        }
        for (const Transition& transition : grafcet->transitions) {
            sources += transition.preceding.count == 0;
        }
        for (const ExprId id : grafcet->expressions.time_conditions()) {
            off_delays += grafcet->expressions.time_condition_of(id).off_delay != 0;
        }
    }
    CHECK(alive > 350);
    CHECK(unstable > 20);
    CHECK(unstable < 250);
    CHECK(macros > 100);
    CHECK(nested > 10);
    CHECK(enclosures > 50);
    CHECK(counters > 100);
    CHECK(sources > 50);
    CHECK(off_delays > 20);
    for (const std::size_t count : orders) CHECK(count > 50);
    for (const std::size_t count : triggers) CHECK(count > 50);
}

TEST_CASE("the same seed gives the same chart, another one another") {
    RandomSource a(7);
    RandomSource b(7);
    RandomSource c(8);
    const std::string chart = random_grafcet(a, Features());
    CHECK(random_grafcet(b, Features()) == chart);
    CHECK(random_grafcet(c, Features()) != chart);
    // The engine is that of the C++ standard: its 10 000th number from the default seed is given.
    RandomSource engine(5489);
    for (int i = 1; i < 10'000; ++i) engine.below(2);
    CHECK(engine.below(SIZE_MAX) == 9981545732273789042U);
}

TEST_CASE("a failing case is shrunk to what makes it fail") {
    // "Fails" wherever a freezing order can be given and something assigns to AUdur.
    const Property property = [](const RandomCase& item) -> std::string {
        const auto grafcet = read_grafcet(item.chart);
        const bool freezes =
            std::any_of(grafcet->orders.begin(), grafcet->orders.end(),
                        [](const Order& order) { return order.kind == OrderKind::freeze; });
        return freezes && item.stimuli.find("AUdur=1") != std::string::npos ? "found" : "";
    };
    std::size_t found = 0;
    for (std::uint64_t seed = 0; found < 5; ++seed) {
        const RandomCase item = random_case(seed, Features(), 25);
        if (property(item).empty()) continue;
        ++found;
        const RandomCase small = shrunk(item, property);
        INFO(small.chart << small.stimuli);
        CHECK(property(small) == "found");
        // Two graphs, one step with the order; the step perhaps in a macro-step within another.
        CHECK(std::count(small.chart.begin(), small.chart.end(), '\n') <= 13);
        CHECK(small.chart.find("->") == std::string::npos);
        CHECK(std::count(small.stimuli.begin(), small.stimuli.end(), '\n') <= 1);
    }
}

}  // namespace grafwire::testing
