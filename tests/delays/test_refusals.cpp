// What the handshake style refuses: each construct with its place and its reason.

#include <doctest/doctest.h>

#include "netlist/styles/messages.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

/// The messages, each behind its line.
std::string refused(const std::string& chart, bool modes = true) {
    const Grafcet grafcet = grafcet_of(chart);
    Diagnostics diagnostics;
    const Equations equations = equations_from(grafcet, {CdxForm::successor, modes});
    const auto netlist = netlist_from(grafcet, equations, Style::handshake, diagnostics);
    CHECK(netlist.has_value() == diagnostics.items().empty());
    std::string text;
    for (const Diagnostic& item : diagnostics.items()) {
        CHECK(item.code == code::unsupported_by_style);
        CHECK_FALSE(item.message.french.empty());
        text += std::to_string(item.where.line) + ": " + item.message.english + "\n";
    }
    return text;
}

/// A loop of three steps, its steps on lines 3 to 5, its transitions on lines 6 to 8.
std::string one_graph(const std::string& declarations, const std::string& steps_and_transitions) {
    return declarations + "\ngraph G {\n" + steps_and_transitions + "\n}\n";
}

const std::string back = "\n2 -> 3 : a\n3 -> 1 : /a";

}  // namespace

TEST_CASE("selections") {
    CHECK(refused(one_graph("input a, b",
                            "initial 1\nstep 2\nstep 3\n1 -> 2 : a\n1 -> 3 : b" + back)) ==
          "7: transitions (0) and (1) can be enabled and true at once: in the handshake style the "
          "faster one takes the token; make the receptivities exclude each other, or say with "
          "'assume' that they do\n");
    CHECK(refused(one_graph("input a, b\nassume /(a . b)",
                            "initial 1\nstep 2\nstep 3\n1 -> 2 : a\n1 -> 3 : b" + back)) == "");
}

TEST_CASE("edges and sources") {
    const auto first = [](const std::string& condition) {
        return refused(
            one_graph("input a, b", "initial 1\nstep 2\nstep 3\n1 -> 2 : " + condition + back));
    };
    CHECK(first("↑(a . b)") ==
          "6: the handshake style has only edges of inputs, not ↑(a.b); wait for its level in two "
          "steps\n");
    CHECK(first("↑a") == "");
    CHECK(refused(
              one_graph("input a, b", "initial 1\nstep 2\nstep 3\n1 -> 2 : a\n-> 2 : b" + back)) ==
          "7: the handshake style has sources on a single edge only: on a level, transition (1) "
          "would be cleared again and again; write ↑ before the input\n");
}

TEST_CASE("time conditions") {
    const auto first = [](const std::string& condition) {
        return refused(
            one_graph("input a, b", "initial 1\nstep 2\nstep 3\n1 -> 2 : " + condition + back));
    };
    const std::string only =
        "6: the handshake style has time conditions of a product of inputs and steps only, with an "
        "on-delay and no off-delay, not ";
    CHECK(first("1s/(a + b)") == only + "1s/(a + b)\n");
    CHECK(first("1s/a/2s") == only + "1s/a/2s\n");
    CHECK(first("1s/(a . /X3)") == "");
}

TEST_CASE("a receptivity that reads what it activates") {
    CHECK(
        refused(one_graph("input a, b", "initial 1\ninitial 2\nstep 3\n1 -> 2 : X2 . b" + back)) ==
        "6: the handshake style has no X2 in a receptivity: step 2 may be entered while it is "
        "active, or be active together with a step beside it\n"
        "6: in the handshake style a transition cannot read X2, which it activates itself\n");
    // Where a step can never be active together with the one before, the answer is known.
    CHECK(refused(one_graph("input a, b", "initial 1\nstep 2\nstep 3\n1 -> 2 : /X2 . b" + back)) ==
          "");
}

TEST_CASE("stored actions") {
    const auto second = [](const std::string& action, bool modes) {
        return refused(one_graph("input a, b\noutput o",
                                 "initial 1\nstep 2 : " + action + "\nstep 3\n1 -> 2 : b" + back),
                       modes);
    };
    CHECK(second("set o, reset o on ↑a", true) ==
          "5: the handshake style writes o on activation, deactivation or clearing only, not on an "
          "event\n");
    CHECK(second("o := a", true) ==
          "5: the handshake style sets and resets o, but gives it no other value\n");
    CHECK(second("set o on deactivation", true) ==
          "5: the handshake style writes o where a transition is cleared; step 2 is also "
          "deactivated by Init, AUdur or an order\n");
    CHECK(second("set o on deactivation", false) == "");
    CHECK(second("set o", true) == "");
}

TEST_CASE("orders and enclosures") {
    const std::string inner = "graph H {\nstep 11\nstep 12\n11 -> 12 : b\n12 -> 11 : /b\n}\n";
    CHECK(refused(one_graph("input a, b", "initial 1\nstep 2 : H{11}\nstep 3\n1 -> 2 : b" + back) +
                  inner +
                  "graph K {\ninitial 21\nstep 22 : H{}\n21 -> 22 : a\n22 -> 21 : /a\n}\n") ==
          "18: steps 2 and 22 can force graph H at once: in the handshake style the slower order "
          "would win\n");
    CHECK(
        refused(one_graph("input a, b",
                          "initial 1\nstep 2 encloses H{11}\nstep 3\n1 -> 2 : b\n2 -> 3 : X12\n"
                          "3 -> 1 : 1") +
                inner) ==
        "4: step 2 may be left and entered again in one evolution: in the handshake style nothing "
        "tells that the graph it encloses has been emptied in between\n");
}

}  // namespace grafwire::testing
