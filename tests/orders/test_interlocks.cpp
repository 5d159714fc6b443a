// The interlocks that cure races, and those that would change what the chart does.

#include <doctest/doctest.h>

#include "grafcet/write_grafcet.h"
#include "orders/interlock.h"
#include "orders/two_graphs.h"

namespace grafwire::testing {

namespace {

/// `NAME: CONDITION: RECEPTIVITY`, in one line an interlock; then what is left.
std::string interlocks_of(const std::string& chart, RaceOptions options = {}) {
    const Grafcet original = chart_of(chart);
    const InterlockedChart interlocked =
        with_interlocks(original, find_races(original, options), options);
    const Grafcet& grafcet = interlocked.grafcet;
    const auto text_of = [&](ExprId id) {
        return write_expression(grafcet, grafcet.expressions, id);
    };
    std::string text;
    for (const Interlock& interlock : interlocked.interlocks) {
        const Transition& waiting = grafcet.transitions[interlock.waiting];
        text += waiting.name + ": " + text_of(interlock.condition) + ": " +
                text_of(waiting.condition) + "\n";
    }
    if (!interlocked.left.races.empty()) text += "left\n";
    CHECK(!interlocked.left.unlike);
    CHECK(interlocked.left.is_complete);
    return text;
}

}  // namespace

TEST_CASE("the step that is passed through waits for its reader") {
    CHECK(interlocks_of(two_graphs("1 -> 2 : a\n2 -> 3 : 1\n3 -> 1 : /a",
                                   "11 -> 12 : X2\n12 -> 13 : X3\n13 -> 11 : X1")) ==
          "1: /X11: /X11\n");
}

TEST_CASE("each further literal of the reader is a reason not to wait") {
    CHECK(interlocks_of(two_graphs("1 -> 2 : a\n2 -> 3 : a + b\n3 -> 1 : /a",
                                   "11 -> 12 : X2 . b\n12 -> 13 : X3\n13 -> 11 : X1")) ==
          "1: /X11 + /b: (a + b).(/X11 + /b)\n");
    CHECK(interlocks_of(two_graphs("1 -> 2 : a\n2 -> 3 : 1\n3 -> 1 : /a",
                                   "11 -> 12 : X2 . (b + 1s/X11) . /X3\n12 -> 13 : X3\n"
                                   "13 -> 11 : X1")) ==
          "1: /X11 + /b./1s/X11: /X11 + /b./1s/X11\n");
}

TEST_CASE("a step read by two graphs waits for both") {
    const std::string chart = two_graphs("1 -> 2 : a\n2 -> 3 : 1\n3 -> 1 : /a",
                                         "11 -> 12 : X2\n12 -> 13 : X3\n13 -> 11 : X1") +
                              "graph K {\ninitial 21\nstep 22\nstep 23\n21 -> 22 : X2\n"
                              "22 -> 23 : X3\n23 -> 21 : X1\n}\n";
    CHECK(interlocks_of(chart) == "1: /X11: /X11./X21\n1: /X21: /X11./X21\n");
}

TEST_CASE("of two writes the one that counts waits") {
    CHECK(interlocks_of("var v\n" +
                        two_graphs("1 -> 2 : a do set v\n2 -> 3 : b\n3 -> 1 : /a",
                                   "11 -> 12 : a do reset v\n12 -> 13 : b\n13 -> 11 : /a")) ==
          "3: /X1 + /a: a.(/X1 + /a)\n");
}

TEST_CASE("no interlock where both would wait for each other") {
    CHECK(interlocks_of(two_graphs("1 -> 2 : a . X11\n2 -> 3 : b\n3 -> 1 : /b",
                                   "11 -> 12 : a . X1\n12 -> 13 : b\n13 -> 11 : /b")) == "left\n");
}

TEST_CASE("no interlock against time") {
    CHECK(interlocks_of(two_graphs("1 -> 2 : 1s/a . /a\n2 -> 3 : b\n3 -> 1 : /b",
                                   "11 -> 12 : a\n12 -> 13 : b\n13 -> 11 : /b")) == "left\n");
}

TEST_CASE("two charts that differ are told apart") {
    const Grafcet one = chart_of(two_graphs("1 -> 2 : a\n2 -> 3 : b\n3 -> 1 : /b",
                                            "11 -> 12 : a\n12 -> 13 : b\n13 -> 11 : /b"));
    Grafcet other = one;
    other.transitions[TransitionId{1}].condition = waiting_condition(
        other, TransitionId{1}, TransitionId{4});  // 2 -> 3 while 12 -> 13 cannot be
    RaceOptions options;
    options.like = &one;
    const RaceReport report = find_races(other, options);
    REQUIRE(report.unlike);
    CHECK(write_stimuli(*report.unlike, one) == "0s : a=1\n0s : end\n");
    CHECK(!find_races(one, options).unlike);
}

}  // namespace grafwire::testing
