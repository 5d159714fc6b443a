// The handshake style under any delay of its gates, construct by construct, on fixed charts.

#include <doctest/doctest.h>

#include "delays/chart_orders.h"
#include "delays/delay_cases.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

/// Explores a chart; cases in which the chart itself depends on the order are left out.
DelayReport explored(const std::string& chart, DelayOptions options = {}, bool modes = true) {
    const Grafcet grafcet = grafcet_of(chart);
    const Netlist netlist = netlist_of(grafcet, Style::handshake, modes);
    REQUIRE(GateOrders::why_not(netlist) == "");
    ChartOrders orders(grafcet);
    options.is_ordered = [&](const ChartCase& item) { return orders.depends_on_order(item); };
    return explore_delays(grafcet, netlist, options);
}

/// So many cases, all of them right, in all orders of single gates.
void check_right(const std::string& chart, std::size_t cases, std::size_t ordered = 0) {
    const DelayReport report = explored(chart);
    INFO(chart);
    CHECK(report.first_wrong == "");
    CHECK(report.is_complete);
    CHECK(report.right == cases);
    CHECK(report.cases == cases);
    CHECK(report.ordered == ordered);
}

/// The same where gates may fire at the same instant.
void check_several(const std::string& chart) {
    DelayOptions options;
    options.firing = Firing::several_gates;
    const DelayReport report = explored(chart, options);
    INFO(chart);
    CHECK(report.first_wrong == "");
    CHECK(report.right == report.cases);
}

std::string graph(const std::string& body, const std::string& name = "G") {
    return "graph " + name + " {\n" + body + "\n}\n";
}

const std::string loop = "initial 1\nstep 2\nstep 3\n1 -> 2 : a\n2 -> 3 : b\n3 -> 1 : /a";

}  // namespace

TEST_CASE("a sequence, without and with modes") {
    const std::string chart =
        "input a, b\noutput o\n" + graph(
                                       "initial 1\nstep 2 : o\nstep 3 : o if /a\n"
                                       "1 -> 2 : a\n2 -> 3 : b\n3 -> 1 : /a");
    CHECK(explored(chart, {}, false).first_wrong == "");
    check_right(chart, 221);
    check_several(chart);
}

TEST_CASE("a loop of two steps has a hidden one") {
    check_right("input a, b\n" + graph("initial 1\nstep 2\n1 -> 2 : a\n2 -> 1 : b"), 195);
    check_several("input a\n" + graph("initial 1\nstep 2\n1 -> 2 : a\n2 -> 1 : /a"));
}

TEST_CASE("several steps to several have a hidden one between them") {
    check_right("input a, b, c\n" + graph("initial 1\nstep 2\nstep 3\nstep 4\nstep 5\n"
                                          "1 -> 2, 3 : a\n2, 3 -> 4, 5 : b\n4, 5 -> 1 : c"),
                521);
}

TEST_CASE("X of steps in receptivities, and the interlock of a step that is passed through") {
    const std::string reader = graph(
        "initial 11\nstep 12\nstep 13\n11 -> 12 : X2\n12 -> 13 : X3\n"
        "13 -> 11 : X1",
        "H");
    const auto passed = [&](const std::string& condition) {
        return "input a\n" +
               graph("initial 1\nstep 2\nstep 3\n1 -> 2 : a\n2 -> 3 : " + condition +
                     "\n3 -> 1 : /a") +
               reader;
    };
    check_right(passed("/X11"), 81);
    check_several(passed("/X11"));
    CHECK(explored(passed("1")).ordered > 0);
}

TEST_CASE("a sink") {
    check_right("input a, b, c\n" + graph("initial 1\nstep 2\nstep 3\nstep 4\n1 -> 2, 4 : a\n"
                                          "2 -> 3 : b\n3 -> 1 : /a\n4 -> : c"),
                601);
}

TEST_CASE("a source on an edge, and steps that are entered while they are active") {
    check_right("input r, b\n" + graph("step 1\nstep 2\n-> 1 : ↑r\n1 -> 2 : b\n2 -> : /b"), 201);
    check_right(
        "input r, b, c\n" +
            graph("initial 1\nstep 2\nstep 3\n1 -> 2 : b\n2 -> 3 : c\n3 -> 1 : /b\n-> 2 : ↑r"),
        577);
}

TEST_CASE("two tokens side by side, and two that become one") {
    check_right("input a, b\n" + graph("initial 1\ninitial 2\nstep 3\nstep 4\n1 -> 2 : a\n"
                                       "2 -> 3 : b\n3 -> 4 : /a\n4 -> 1 : /b"),
                279, 2);
    check_right("input a, b, c\n" +
                    graph("initial 1\nstep 2\nstep 3\nstep 4\nstep 5\n1 -> 2, 3 : a\n2 -> 4 : b\n"
                          "3 -> 4 : c\n4 -> 5 : a . b . c\n5 -> 1 : /a"),
                677, 8);
}

TEST_CASE("freezing") {
    check_right("input a, b, f\n" + graph(loop) +
                    graph("initial 11\nstep 12 : G{*}\nstep 13\n11 -> 12 : f\n12 -> 13 : /f\n"
                          "13 -> 11 : f",
                          "H"),
                669, 4);
}

TEST_CASE("forcing, by steps that stay and by one that is passed through") {
    check_right("input a, b, f\n" + graph(loop) +
                    graph("initial 11\nstep 12 : G{2}\nstep 13 : G{}\nstep 14 : G{INIT}\n"
                          "11 -> 12 : f\n12 -> 13 : /f\n13 -> 14 : f\n14 -> 11 : /f",
                          "H"),
                601);
    check_right("input a, b, f\n" + graph(loop) +
                    graph("initial 11\nstep 12 : G{3}\nstep 13\n11 -> 12 : f\n12 -> 13 : 1\n"
                          "13 -> 11 : /f",
                          "H"),
                525, 4);
}

TEST_CASE("time conditions") {
    check_right("input a, b\noutput o\n" +
                    graph("initial 1\nstep 2 : o if 3s/X2\nstep 3\n1 -> 2 : a\n2 -> 3 : 2s/X2\n"
                          "3 -> 1 : 1s/X3 . b"),
                353);
    // A step that is left and entered again in one evolution does not fire on its old timer.
    check_right("input a\n" + graph("initial 1\nstep 2\nstep 3\n1 -> 2 : 1s/X1\n2 -> 3 : 1\n"
                                    "3 -> 1 : 1"),
                105);
    check_right("input a, b\n" + graph("initial 1\nstep 2\nstep 3\n1 -> 2 : 1s/a\n"
                                       "2 -> 3 : /(1s/a) . b\n3 -> 1 : 2s/(/b)"),
                629);
    check_right("input a, b, c\n" + graph("initial 1\nstep 2\nstep 3\nstep 4\nstep 5\n"
                                          "1 -> 2, 3 : 1s/X1 . a\n2 -> 4 : b\n3 -> 5 : 1s/X3\n"
                                          "4, 5 -> 1 : 1s/X5 . 2s/X4"),
                1409);
}

TEST_CASE("a step that is left by time or by an input") {
    check_right("input a, b\n" + graph("initial 1\nstep 2\nstep 3\nstep 4\n1 -> 2 : a\n2 -> 3 : b\n"
                                       "2 -> 4 : 2s/X2\n3 -> 1 : /a\n4 -> 1 : /a"),
                245);
}

TEST_CASE("edges of inputs") {
    check_right("input a, b\n" + graph("initial 1\nstep 2\nstep 3\n1 -> 2 : ↑a\n2 -> 3 : ↑a . b\n"
                                       "3 -> 1 : ↓a + /b"),
                251);
}

TEST_CASE("stored actions") {
    check_right("input a, b\noutput o\n" +
                    graph("initial 1\nstep 2 : set o\nstep 3\nstep 4 : reset o\n1 -> 2 : a\n"
                          "2 -> 3 : o . b\n3 -> 4 : /a\n4 -> 1 : /o . /b"),
                421);
    check_right("input a, b, c\nvar v\noutput w\n" +
                    graph("initial 1\nstep 2 : set v, set w\nstep 3 : set v\nstep 4 : reset v\n"
                          "step 5 : reset w\n1 -> 2, 3 : ↑a\n2 -> 4 : b . w\n3 -> 5 : c . v\n"
                          "4, 5 -> 1 : /w . /v"),
                2129, 8);
    check_right("input a, b\nvar v\n" +
                    graph("initial 1\nstep 2\nstep 3\n1 -> 2 : a do set v\n2 -> 3 : b\n"
                          "3 -> 1 : /a do reset v") +
                    graph("initial 11\nstep 12\nstep 13\n11 -> 12 : v . X2\n12 -> 13 : /v\n"
                          "13 -> 11 : X1",
                          "H"),
                393, 8);
}

TEST_CASE("an enclosing step") {
    check_right("input a, b, c\n" +
                    graph("initial 1\nstep 2 encloses H{11, 14}\nstep 3\n1 -> 2 : a\n2 -> 3 : b\n"
                          "3 -> 1 : /a . /b") +
                    graph("step 11\nstep 12\nstep 13\nstep 14\n11 -> 12 : c\n12 -> 13 : /c\n"
                          "13 -> 11 : c . X14",
                          "H") +
                    graph("initial 21\nstep 22\nstep 23\n21 -> 22 : X12\n22 -> 23 : /X12\n"
                          "23 -> 21 : /X2",
                          "K"),
                597, 4);
    check_right("input a, b, c\n" +
                    graph("initial 1 encloses H{12}\nstep 2\nstep 3\nstep 4\n1 -> 2, 4 : a\n"
                          "2 -> 3 : b\n3, 4 -> 1 : /a") +
                    graph("initial 11\nstep 12\nstep 13\n11 -> 12, 13 : c\n12 -> 11 : /c", "H"),
                577);
}

// A netlist that lacks one guard fails, and the explorer says so.
TEST_CASE("without the input that tells that the arrival is complete") {
    const Grafcet grafcet = grafcet_of("input a, b\n" + graph(loop));
    Netlist netlist = netlist_of(grafcet, Style::handshake);
    std::size_t left_out = 0;
    for (Cell& cell : netlist.cells) {
        if (netlist.names[cell.output] != "T1$give") continue;
        for (std::uint32_t i = 0; i < cell.pin_count; ++i) {
            NetId& pin = netlist.pins[cell.first_pin + i];
            if (netlist.names[pin] == "T0$give") {
                pin = netlist.pins[cell.first_pin];
                ++left_out;
            }
        }
    }
    REQUIRE(left_out == 1);
    CHECK(explore_delays(grafcet, netlist).first_wrong != "");
}

}  // namespace grafwire::testing
