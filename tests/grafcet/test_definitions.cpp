// Names that stand for conditions and durations, and vars that steps hold.

#include <fmt/core.h>

#include "grafcet/messages.h"
#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// A chart with these declarations, whose transition 0 -> 1 has that condition and whose step 1 has
/// those actions.
std::string chart_with(const std::string& declarations, const std::string& condition,
                       const std::string& actions = "V") {
    return "input a, b\noutput V\n" + declarations +
           "\ngraph G {\n  initial 0\n  step 1 : " + actions + "\n  0 -> 1 : " + condition +
           "\n  1 -> 0 : a . b\n}\n";
}

std::string condition_of(const Grafcet& grafcet, std::size_t transition) {
    return write_expression(grafcet, grafcet.expressions,
                            grafcet.transitions.items()[transition].condition);
}

}  // namespace

TEST_CASE("a defined name reads as its condition, in any order of declaration") {
    const Grafcet grafcet = parsed(chart_with(
        "define both = some . /none\ndefine some = a + b\ndefine none = /a . /b\n", "both . b"));
    CHECK(condition_of(grafcet, 0) == "((a + b)./(/a./b)).b");
    CHECK(grafcet.vars.empty());
}

TEST_CASE("what only unread names hold is not in the model") {
    const Grafcet grafcet =
        parsed(chart_with("define unread = ↑a . 5s/b . other\ndefine other = ↓b", "a"));
    CHECK(grafcet.expressions.edges().empty());
    CHECK(grafcet.expressions.time_conditions().empty());
    CHECK(messages_of(
              chart_with("define unread = ↑a . other\ndefine other = ↓b\ntime T = 5s", "a")) ==
          "3:8 warning: the condition 'unread' is defined and never used\n"
          "4:8 warning: the condition 'other' is defined and never used\n"
          "5:6 warning: the duration 'T' is declared and never used\n");
}

TEST_CASE("a named duration stands on both sides of a time condition") {
    const Grafcet grafcet = parsed(chart_with("time T3 = 300ms\ntime T4 = 1.5s", "T3/X0/T4"));
    CHECK(condition_of(grafcet, 0) == "300ms/X0/1.5s");
}

TEST_CASE("names that stand for each other") {
    CHECK(messages_of(chart_with("define p = q . a\ndefine q = r\ndefine r = p + b", "p")) ==
          "3:8 error: names stand for one another in a circle: 'p → q → r → p'; write one of them "
          "out\n");
    CHECK(messages_of(chart_with("define p = /p", "p")) ==
          "3:8 error: names stand for one another in a circle: 'p → p'; write one of them out\n");
    CHECK(messages_of(chart_with("var m", "m", "m if m")) ==
          "3:5 error: names stand for one another in a circle: 'm → m'; write one of them out\n");
}

TEST_CASE("a name that doubles with each other is bounded") {
    std::string declarations = "define d0 = a . b";
    for (int i = 1; i < 60; ++i) {
        declarations += fmt::format("\ndefine d{} = d{} . d{}", i, i - 1, i - 1);
    }
    const std::string messages = messages_of(chart_with(declarations, "d59"));
    CHECK(messages.find("stands for an expression of more than 10000 parts") != messages.npos);
}

TEST_CASE("names in a chain as long as the file likes") {
    std::string declarations = "define d0 = a";
    for (int i = 1; i < 20000; ++i) declarations += fmt::format("\ndefine d{} = /d{}", i, i - 1);
    const std::string messages = messages_of(chart_with(declarations, "d19999"));
    CHECK(messages.find("error") != messages.npos);  // too deep, and no crash
}

TEST_CASE("what a name stands for must suit its place") {
    CHECK(messages_of(chart_with("define edge = ↑a", "a", "V if edge")) ==
          "6:17 error: 'edge' stands for a condition with an edge, which cannot stand in the "
          "condition of a continuous action; use it in a transition condition or after 'on'\n"
          "  3:8 note: it stands for this\n");
    CHECK(messages_of(chart_with("define edge = ↑a", "edge", "V if 5s/edge")) == "");
    CHECK(messages_of(chart_with("define active = X1\nassume /(active . a)", "active")) ==
          "4:10 error: 'active' stands for more than inputs, and an assumption is over inputs and "
          "control inputs alone\n"
          "  3:8 note: it stands for this\n");
    CHECK(messages_of(chart_with("define both = a . b\nassume /both", "a")) == "");
}

TEST_CASE("names that are something else") {
    CHECK(messages_of(chart_with("define a = b", "a")) ==
          "3:8 error: the variable 'a' exists already; rename one of the two\n  1:7 note: it is "
          "first declared here\n");
    CHECK(messages_of(chart_with("time T = 5s", "T . a")) ==
          "7:14 error: expected '/' after the duration, as in 5s/X13, got '.'\n");
    CHECK(messages_of(chart_with("define c = a", "5s/a/c")) ==
          "7:17 error: 'c' is no duration; declare one with time, as in time T3 = 300ms\n");
    CHECK(messages_of(chart_with("define c = a", "c", "c, set c")) ==
          "6:12 error: 'c' is a defined name, which no action changes; declare a var instead\n"
          "6:19 error: 'c' is a defined name, which no action changes; declare a var instead\n");
}

TEST_CASE("a var that steps hold is the OR over them, and is read in place") {
    const Grafcet grafcet = parsed(
        "input a\nvar m, AUTO\ngraph G {\n  initial 0 : set m\n  step 1 : AUTO\n  step 2 : AUTO if "
        "a . m\n"
        "  0 -> 1 : a\n  1 -> 2 : AUTO\n  2 -> 0 : ↓AUTO\n}\n");
    CHECK(grafcet.vars.size() == 2);
    CHECK_FALSE(grafcet.vars.items()[0].is_held());
    REQUIRE(grafcet.vars.items()[1].is_held());
    CHECK(write_expression(grafcet, grafcet.expressions, grafcet.vars.items()[1].held) ==
          "X1 + X2.(a.m)");
    CHECK(condition_of(grafcet, 1) == "X1 + X2.(a.m)");
    CHECK(condition_of(grafcet, 2) == "↓(X1 + X2.(a.m))");
    CHECK(write_grafcet(parsed(write_grafcet(grafcet))) == write_grafcet(grafcet));
}
