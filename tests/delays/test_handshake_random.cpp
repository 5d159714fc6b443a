// The handshake style under any delay of its gates on random charts: what it does not refuse is
// right, wherever the chart does not depend on the order in which its own transitions clear.

#include <doctest/doctest.h>

#include "delays/delay_cases.h"
#include "delays/judged_orders.h"
#include "random/plain_chart.h"
#include "random/random_cases.h"
#include "random/random_grafcet.h"
#include "random/random_source.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

struct Tally {
    std::size_t charts = 0;
    std::size_t refused = 0;
    std::size_t cases = 0;
};

void explore_one(const std::string& chart, std::uint64_t seed, std::size_t most_cases,
                 Tally& tally) {
    const Grafcet grafcet = grafcet_of(chart);
    Diagnostics diagnostics;
    const Equations equations = equations_from(grafcet, {CdxForm::successor, true});
    const auto netlist = netlist_from(grafcet, equations, Style::handshake, diagnostics);
    if (!netlist || !GateOrders::why_not(*netlist).empty()) {
        ++tally.refused;
        return;
    }
    JudgedOrders orders(grafcet);
    DelayOptions options;
    options.most_cases = most_cases;
    options.most_states = 30'000;
    options.is_ordered = [&](const ChartCase& item) { return orders.depends_on_order(item); };
    const DelayReport report = explore_delays(grafcet, *netlist, options);
    CHECK_MESSAGE(report.first_wrong.empty(), "seed " << seed << ": " << report.first_wrong << "\n"
                                                      << chart);
    CHECK_MESSAGE(orders.first_disagreement().empty(),
                  "seed " << seed << ": " << orders.first_disagreement() << "\n"
                          << chart);
    ++tally.charts;
    tally.cases += report.right;
}

/// A plain chart, and a ring of three or four steps that give orders to it. Its conditions read
/// inputs and steps of either graph; some steps are passed through.
std::string chart_with_orders(RandomSource& random) {
    Features features = Features::plain_chart();
    features.steps = 3 + random.below(4);
    features.inputs = 2;
    features.outputs = 0;
    const std::string plain = plain_chart(random, features);
    std::size_t steps = 0;
    while (plain.find(" " + std::to_string(steps) + "\n") != std::string::npos) ++steps;
    const auto some_step = [&] { return std::to_string(random.below(steps)); };
    const std::size_t ring = 3 + random.below(2);
    std::string text = "input f\n" + plain + "graph H {\n";
    for (std::size_t i = 0; i < ring; ++i) {
        text += (i == 0 ? "  initial " : "  step ") + std::to_string(100 + i);
        const std::size_t order = random.below(6);
        const std::string listed = some_step();
        if (order < 4) {
            const std::string situations[] = {"*", "", "INIT", listed};
            text += " : G{" + situations[order] + "}";
        }
        text += "\n";
    }
    for (std::size_t i = 0; i < ring; ++i) {
        const std::size_t kind = random.below(6);
        const std::string sign = random.flip() ? "/" : "";
        const std::string read = some_step();
        const std::string condition = kind == 0 ? "1" : kind == 1 ? sign + "X" + read : sign + "f";
        text += "  " + std::to_string(100 + i) + " -> " + std::to_string(100 + (i + 1) % ring) +
                " : " + condition + "\n";
    }
    return text + "}\n";
}

Features bare() {
    Features features = Features::small();
    features.steps = 6;
    features.inputs = 3;
    features.outputs = 1;
    features.vars = features.counters = features.time_conditions = features.edges = 0;
    features.expression_depth = 1;
    features.macros = features.orders = features.enclosures = features.stored = false;
    features.clearing = features.nested_times = features.off_delays = false;
    features.sources_and_sinks = features.assumptions = features.reads_controls = false;
    features.odd_names = features.named_parts = false;
    return features;
}

Tally explore_random(const Features& features, std::size_t charts) {
    Tally tally;
    const std::size_t count = case_count(charts);
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        RandomSource random(seed);
        explore_one(random_grafcet(random, features), seed, 400, tally);
    }
    return tally;
}

}  // namespace

TEST_CASE("random plain charts of 4 to 11 steps") {
    Tally tally;
    const std::size_t count = case_count(60);
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        RandomSource random(seed);
        Features features = Features::plain_chart();
        features.steps = 4 + random.below(7);
        features.inputs = 3;
        features.outputs = 2;
        explore_one(plain_chart(random, features), seed, 2000, tally);
    }
    CHECK(tally.refused == 0);
}

TEST_CASE("random plain charts under the orders of a ring") {
    Tally tally;
    const std::size_t count = case_count(150);
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        RandomSource random(seed);
        explore_one(chart_with_orders(random), seed, 400, tally);
    }
    CHECK(tally.charts > count / 2);
}

TEST_CASE("random charts of two graphs that read each other") {
    const Tally tally = explore_random(bare(), 300);
    CHECK(tally.charts > tally.refused / 4);
}

TEST_CASE("random charts with macro-steps, orders, sources and sinks") {
    Features features = bare();
    features.orders = features.sources_and_sinks = features.macros = true;
    CHECK(explore_random(features, 300).charts != 0);
}

TEST_CASE("random charts with stored actions and enclosing steps") {
    Features features = bare();
    features.graphs = 3;
    features.vars = 1;
    features.stored = features.clearing = features.enclosures = true;
    CHECK(explore_random(features, 400).charts != 0);
}

TEST_CASE("random charts with edges and time conditions") {
    Features features = bare();
    features.edges = features.time_conditions = 2;
    features.orders = true;
    CHECK(explore_random(features, 300).charts != 0);
}

}  // namespace grafwire::testing
