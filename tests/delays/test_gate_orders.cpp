// The explorer of all orders itself, on circuits whose behaviour is known.

#include <doctest/doctest.h>

#include "delays/delay_cases.h"
#include "delays/gate_orders.h"
#include "netlist/netlist_builder.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

/// Two cross-coupled NAND gates with inputs s and r, 0 sets and resets.
Netlist latch_of_nands() {
    NetlistBuilder builder("latch", InnerNames::by_unused_role);
    const CellPlace place(builder.add_module("latch"),
                          builder.add_origin(Origin::Kind::other, "latch", {}));
    const NetId s = builder.add_net("s");
    const NetId r = builder.add_net("r");
    const NetId q = builder.add_net("q");
    const NetId p = builder.add_net("p");
    builder.add_input("s", s);
    builder.add_input("r", r);
    builder.add_output("q", q);
    builder.drive(place, q, CellType::nand_gate, std::vector{s, p});
    builder.drive(place, p, CellType::nand_gate, std::vector{r, q});
    return builder.finish();
}

NetValues values(const Netlist& netlist, const std::vector<const char*>& ones) {
    NetValues result;
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        for (const char* name : ones) {
            if (netlist.names[static_cast<NetId>(i)] == name)
                result.set(static_cast<NetId>(i), true);
        }
    }
    return result;
}

}  // namespace

TEST_CASE("a latch that is set has one outcome") {
    const Netlist netlist = latch_of_nands();
    const auto outcomes =
        GateOrders(netlist).outcomes(values(netlist, {"r", "p"}), Firing::one_gate, 100);
    REQUIRE(outcomes.stable.size() == 1);
    CHECK(outcomes.stable[0] == values(netlist, {"r", "q"}));
    CHECK_FALSE(outcomes.may_oscillate);
    CHECK(outcomes.states == 3);
}

TEST_CASE(
    "a latch released from both sides has two, and keeps changing where gates are equally fast") {
    const Netlist netlist = latch_of_nands();
    const NetValues released = values(netlist, {"s", "r", "q", "p"});
    const GateOrders orders(netlist);
    const auto one = orders.outcomes(released, Firing::one_gate, 100);
    CHECK(one.stable.size() == 2);
    CHECK_FALSE(one.may_oscillate);
    const auto several = orders.outcomes(released, Firing::several_gates, 100);
    CHECK(several.stable.size() == 2);
    CHECK(several.may_oscillate);
}

TEST_CASE("a ring of inverters oscillates, and a cycle that a gate has to leave does not count") {
    NetlistBuilder builder("ring", InnerNames::by_unused_role);
    const CellPlace place(builder.add_module("ring"),
                          builder.add_origin(Origin::Kind::other, "ring", {}));
    const NetId a = builder.add_net("a");
    const NetId b = builder.add_net("b");
    const NetId stop = builder.add_net("stop");
    builder.add_input("a", a);
    builder.drive(place, stop, CellType::buffer, std::vector{a});
    builder.drive(place, b, CellType::nor_gate, std::vector{stop, b});
    const Netlist netlist = builder.finish();
    const GateOrders orders(netlist);
    CHECK(orders.outcomes(NetValues(), Firing::one_gate, 100).may_oscillate);
    const auto stopped = orders.outcomes(values(netlist, {"a"}), Firing::one_gate, 100);
    CHECK_FALSE(stopped.may_oscillate);
    CHECK(stopped.stable.size() == 1);
}

TEST_CASE("nets that nothing sets at power-up are unknown") {
    const Netlist netlist = latch_of_nands();
    const GateOrders orders(netlist);
    std::vector<NetId> unknown;
    orders.power_up(values(netlist, {"s", "r"}), unknown);
    CHECK(unknown.size() == 2);
    unknown.clear();
    CHECK(orders.power_up(values(netlist, {"r"}), unknown) == values(netlist, {"r", "q"}));
    CHECK(unknown.empty());
}

TEST_CASE("what the explorer cannot run") {
    const char* edge =
        "input a\ngraph G { initial 0\n step 1\n step 2\n 0 -> 1 : ↑a\n 1 -> 2 : a\n 2 -> 0 : a }";
    CHECK(GateOrders::why_not(netlist_of(grafcet_of(edge), Style::gates)) ==
          "a cell of type rise_pulse");
    CHECK(GateOrders::why_not(latch_of_nands()).empty());
}

// A loop of three steps: the separate-gate module is right under equal delays, and fails here.
TEST_CASE("the module of the course depends on the delays") {
    const Grafcet grafcet = grafcet_of(
        "input a, b, c\noutput lamp\ngraph G { initial 0\n step 1 : lamp\n step 2\n 0 -> 1 : a\n 1 "
        "-> 2 : b\n 2 -> 0 : c }");
    for (const Style style : {Style::gates, Style::nand}) {
        const DelayReport report = explore_delays(grafcet, netlist_of(grafcet, style, false));
        CHECK(report.cases > report.right);
        CHECK(report.right > 0);
    }
    const DelayReport report = explore_delays(grafcet, netlist_of(grafcet, Style::gates, false));
    CHECK(report.first_wrong == "in { 0 }, a changes: X1 can be 0, expected 1");
}

}  // namespace grafwire::testing
