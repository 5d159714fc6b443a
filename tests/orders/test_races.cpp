// Whether a chart depends on the order in which its transitions clear, kind by kind, on fixed
// charts.

#include <doctest/doctest.h>

#include "evolution/run.h"
#include "grafcet/shown_transition.h"
#include "orders/find_races.h"
#include "orders/two_graphs.h"

namespace grafwire::testing {

namespace {

std::string steps_of(const Grafcet& grafcet, const BitTable& situation) {
    std::string text;
    for_each_bit(situation, [&](std::size_t step) {
        text += (text.empty() ? "" : " ") + grafcet.steps[grafcet.steps.id_at(step)].name;
    });
    return text;
}

/// `KIND: FIRST | SECOND: TOGETHER | APART`, in one line a race.
std::string races_of(const std::string& chart, RaceOptions options = {}) {
    const Grafcet grafcet = chart_of(chart);
    const RaceReport report = find_races(grafcet, options);
    CHECK(report.is_complete);
    constexpr std::string_view kinds[] = {"withdrawn", "arrival", "difference", "unrest"};
    std::string text;
    for (const FoundRace& found : report.races) {
        const OrderRace& race = found.race;
        const auto name = [&](TransitionId id) {
            return id == none ? "time" : shown_transition(grafcet, id);
        };
        text += std::string(kinds[static_cast<std::size_t>(race.kind)]) + ": " + name(race.first) +
                " | " + name(race.second) + ": " + steps_of(grafcet, race.together) + " | " +
                (race.apart ? steps_of(grafcet, *race.apart) : "-") + "\n";
    }
    return text;
}

RaceOptions without_modes() {
    RaceOptions options;
    options.has_modes = false;
    return options;
}

}  // namespace

TEST_CASE("a step that is passed through while another graph reads it") {
    const std::string chart = two_graphs("1 -> 2 : a\n2 -> 3 : 1\n3 -> 1 : /a",
                                         "11 -> 12 : X2\n12 -> 13 : X3\n13 -> 11 : X1");
    CHECK(races_of(chart) == "withdrawn: (1) 2 -> 3 | (3) 11 -> 12: 3 13 | 3 11\n");
    // Where it waits for the reader, and where it waits for an input.
    CHECK(races_of(two_graphs("1 -> 2 : a\n2 -> 3 : /X11\n3 -> 1 : /a",
                              "11 -> 12 : X2\n12 -> 13 : X3\n13 -> 11 : X1"))
              .empty());
    CHECK(races_of(two_graphs("1 -> 2 : a\n2 -> 3 : /a\n3 -> 1 : b",
                              "11 -> 12 : X2\n12 -> 13 : /X2\n13 -> 11 : b"))
              .empty());
}

TEST_CASE("the stimuli of a race lead there") {
    const std::string chart = two_graphs("1 -> 2 : a\n2 -> 3 : 1\n3 -> 1 : /a",
                                         "11 -> 12 : X2 . b\n12 -> 13 : X3\n13 -> 11 : X1");
    const Grafcet grafcet = chart_of(chart);
    const RaceReport report = find_races(grafcet, {});
    REQUIRE(report.races.size() == 1);
    const FoundRace& found = report.races[0];
    CHECK(write_stimuli(found.stimuli, grafcet) == "0s : a=1 b=1\n0s : end\n");
    const RunResult run = run_until_stable(grafcet, found.stimuli);
    const std::size_t last = run.trace.row_count() - 1;
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const std::size_t column = i + 1 + grafcet.all_input_count();
        INFO(run.trace.columns[column - 1].name);
        CHECK((run.trace.values[last * run.trace.columns.size() + column - 1] != 0) ==
              found.race.together.test(i));
    }
}

TEST_CASE("two transitions that write different values") {
    CHECK(
        races_of("var v\n" + two_graphs("1 -> 2 : a do set v\n2 -> 3 : b\n3 -> 1 : /a",
                                        "11 -> 12 : a do reset v\n12 -> 13 : b\n13 -> 11 : /a")) ==
        "difference: (3) 11 -> 12 | (0) 1 -> 2: 2 12 | 2 12\n");
    CHECK(races_of("var v\n" + two_graphs("1 -> 2 : a do set v\n2 -> 3 : b\n3 -> 1 : /a",
                                          "11 -> 12 : a do set v\n12 -> 13 : b\n13 -> 11 : /a"))
              .empty());
}

TEST_CASE("a step that is entered at the moment in which it is left") {
    const std::string chart =
        "input a, b\ngraph G {\ninitial 1\ninitial 2\nstep 3\nstep 4\n"
        "1 -> 2 : a\n2 -> 3 : a\n3 -> 4 : b\n4 -> 1 : /b\n}\n";
    CHECK(races_of(chart, without_modes()).find("arrival: (0) 1 -> 2 | (1) 2 -> 3: 3 | ") !=
          std::string::npos);
}

TEST_CASE("an edge is there for all that wait for it") {
    CHECK(races_of(two_graphs("1 -> 2 : ↑a\n2 -> 3 : ↑a\n3 -> 1 : /a",
                              "11 -> 12 : ↑a\n12 -> 13 : b\n13 -> 11 : /b"))
              .empty());
    CHECK(races_of(two_graphs("1 -> 2 : ↑a\n2 -> 3 : b\n3 -> 1 : /b",
                              "11 -> 12 : ↑a . X1\n12 -> 13 : /a\n13 -> 11 : a")) ==
          "withdrawn: (0) 1 -> 2 | (3) 11 -> 12: 2 12 | 2 11\n");
}

TEST_CASE("a time condition that falls at the moment in which it is read") {
    CHECK(races_of(two_graphs("1 -> 2 : 1s/a . /a\n2 -> 3 : b\n3 -> 1 : /b",
                              "11 -> 12 : a\n12 -> 13 : b\n13 -> 11 : /b")) ==
          "withdrawn: time | (0) 1 -> 2: 2 12 | 1 12\n");
}

TEST_CASE("freezing and forcing by a step that is passed through") {
    const auto with_order = [](const std::string& order) {
        return "input a, b\ngraph G {\ninitial 1\nstep 2 : H{" + order +
               "}\nstep 3\n1 -> 2 : a\n2 -> 3 : 1\n3 -> 1 : /a\n}\n"
               "graph H {\ninitial 11\nstep 12\nstep 13\n"
               "11 -> 12 : a\n12 -> 13 : b\n13 -> 11 : /b\n}\n";
    };
    CHECK(races_of(with_order("*"), without_modes()) ==
          "withdrawn: (0) 1 -> 2 | (3) 11 -> 12: 3 12 | 3 12\n");
    CHECK(races_of(with_order("13"), without_modes()) ==
          "withdrawn: (0) 1 -> 2 | (3) 11 -> 12: 3 12 | 3 12\n");
}

TEST_CASE("a ring that another graph may stop in time, or not") {
    // Whether 11 -> 12 sees X2 depends on how often the ring has gone round; but it goes on until
    // it is stopped, so there is an end.
    const std::string chart =
        "input a\ngraph G {\ninitial 1\nstep 2\n1 -> 2 : a . X11\n"
        "2 -> 1 : X12\n}\n"
        "graph H {\ninitial 11\nstep 12\n11 -> 12 : X2\n12 -> 11 : X1\n}\n";
    const Grafcet grafcet = chart_of(chart);
    // The chart has no stable situation itself while a is 1: not a matter of order.
    CHECK(find_races(grafcet, {}).races.empty());
}

TEST_CASE("assumptions and lengths of delays exclude cases") {
    const std::string chart = two_graphs("1 -> 2 : a\n2 -> 3 : 1\n3 -> 1 : /a",
                                         "11 -> 12 : X2 . b\n12 -> 13 : X3\n13 -> 11 : X1");
    CHECK(!races_of(chart).empty());
    CHECK(races_of("assume /(a . b)\n" + chart).empty());

    // At 1 s step 11 has not been active for 5 s, unless an Init has brought step 1 back.
    const std::string timed = two_graphs("1 -> 2 : 1s/X1\n2 -> 3 : 1\n3 -> 1 : a . /a",
                                         "11 -> 12 : X2 . 5s/X11\n12 -> 13 : b\n13 -> 12 : /b");
    CHECK(races_of(timed, without_modes()).empty());
    CHECK(races_of(timed) == "withdrawn: (1) 2 -> 3 | (3) 11 -> 12: 3 12 | 3 11\n");
}

TEST_CASE("a bound ends the search, and the report says so") {
    const std::string chart = two_graphs("1 -> 2 : a\n2 -> 3 : b\n3 -> 1 : /a",
                                         "11 -> 12 : X2\n12 -> 13 : X3\n13 -> 11 : X1");
    const Grafcet grafcet = chart_of(chart);
    RaceOptions options;
    options.max_cases = 5;
    const RaceReport few = find_races(grafcet, options);
    CHECK(few.cases == 5);
    CHECK(!few.is_complete);
    options.max_cases = 0;
    int questions = 0;
    options.keep_going = [&] { return ++questions < 7; };
    const RaceReport stopped = find_races(grafcet, options);
    CHECK(!stopped.is_complete);
    CHECK(stopped.cases < find_races(grafcet, {}).cases);
}

TEST_CASE("more transitions at once than orders are gone through") {
    std::string chart = "input a\n";
    for (int i = 0; i < 12; ++i) {
        const std::string n = std::to_string(i);
        chart += "graph G" + n + " {\ninitial " + n + "1\nstep " + n + "2\n" + n + "1 -> " + n +
                 "2 : a\n}\n";
    }
    const RaceReport report = find_races(chart_of(chart), {});
    CHECK(report.races.empty());
    CHECK(!report.is_complete);
}

}  // namespace grafwire::testing
