// What the product says of the order of clearing, against ChartOrders: every case of the examples
// and of random charts, whatever netlists they can become.

#include <doctest/doctest.h>

#include "delays/judged_orders.h"
#include "orders/tell_orders.h"
#include "random/random_cases.h"
#include "random/random_grafcet.h"
#include "random/random_source.h"
#include "support/chart_files.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

/// The case at the last instant of stimuli.
void with_last_case(const Grafcet& grafcet, const Stimuli& stimuli,
                    const std::function<void(const ChartCase&)>& visit) {
    const Evolution evolution(grafcet);
    StimuliPlayer player(stimuli, grafcet.all_input_count());
    InputValues before(grafcet.all_input_count(), 0);
    player.advance(0);
    EvolutionState state = evolution.start({player.inputs()});
    for (Time now = 0; now != stimuli.end;) {
        evolution.end_delays(state, {player.inputs()}, now);
        REQUIRE(evolution.settle(state, {player.inputs()}, now).stable);
        Time next = std::min(player.next_change(), stimuli.end);
        for (const Time due : state.due) next = std::min(next, due);
        before = player.inputs();
        player.advance(next);
        now = next;
    }
    // ChartOrders looks at cases at one second; what is due is so by then.
    for (Time& due : state.due) {
        if (due != never) due = due <= stimuli.end ? second : far_away;
    }
    visit({state, before, player.inputs(), {}});
}

/// Compares case by case, and looks at the case of every race that the product finds.
std::size_t compare(const Grafcet& grafcet, const std::string& name, std::size_t most_cases) {
    INFO(name);
    JudgedOrders orders(grafcet);
    for_each_chart_case(grafcet, most_cases,
                        [&](const ChartCase& item) { orders.depends_on_order(item); });
    CHECK(orders.first_disagreement() == "");
    RaceOptions options;
    options.max_cases = 20'000;
    const RaceReport report = find_races(grafcet, options);
    for (const FoundRace& found : report.races) {
        with_last_case(grafcet, found.stimuli, [&](const ChartCase& item) {
            INFO(told_race(grafcet, found.race).english);
            CHECK(orders.depends_on_order(item));
        });
    }
    CHECK(orders.first_disagreement() == "");
    // Lengths of delays may exclude what is found where they do not count.
    if (orders.dependent() != 0 && report.is_complete &&
        grafcet.expressions.time_conditions().empty()) {
        CHECK(!report.races.empty());
    }
    return orders.dependent();
}

Features orders_and_steps() {
    Features features = Features::small();
    features.steps = 6;
    features.inputs = 3;
    features.outputs = 1;
    features.vars = 1;
    features.counters = features.edges = 0;
    features.time_conditions = 1;
    features.expression_depth = 2;
    features.odd_names = features.named_parts = false;
    features.nested_times = features.off_delays = features.reads_controls = false;
    return features;
}

}  // namespace

TEST_CASE("the product and ChartOrders agree on the examples") {
    std::size_t charts = 0;
    for (const ChartFiles& files : example_charts()) {
        compare(grafcet_of(files.chart), files.name, 1500);
        ++charts;
    }
    CHECK(charts > 10);
}

TEST_CASE("the product and ChartOrders agree on random charts") {
    std::size_t dependent = 0;
    const std::size_t count = case_count(250);
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        RandomSource random(seed);
        const std::string chart = random_grafcet(random, orders_and_steps());
        dependent += compare(grafcet_of(chart), "seed " + std::to_string(seed) + "\n" + chart, 300);
    }
    CHECK(dependent > count);
}

}  // namespace grafwire::testing
