#include <doctest/doctest.h>

#include <algorithm>

#include "all_orders.h"
#include "random/random_cases.h"
#include "random_gates.h"
#include "settling/any_order.h"
#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

Outcomes outcomes_of(const Rests& rests) {
    Outcomes outcomes;
    for (const Rest& rest : rests.rests) {
        if (rest.kind == Rest::Kind::oscillates) {
            outcomes.can_go_on_for_ever = true;
        } else {
            outcomes.rests.insert(bits_of(rest.state));
        }
    }
    return outcomes;
}

/// A latch of two NAND gates, at 1 and 1, whose inputs have just gone.
SmallNetlist released_latch() {
    SmallNetlist small;
    small.input("s");
    small.input("r");
    small.cell(CellType::nand_gate, "x", {"s", "q"});
    small.cell(CellType::nand_gate, "q", {"r", "x"});
    return small;
}

}  // namespace

TEST_CASE("orders: a latch released from both inputs falls either way, or swings") {
    SmallNetlist small = released_latch();
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    AnyOrder orders(circuit, {});
    const Rests rests = orders.settle(state_of({1, 1, 1, 1}), true, enough);
    REQUIRE(rests.rests.size() == 3);
    CHECK(!rests.is_too_large);
    CHECK(bits_of(rests.rests[0].state) == Bits{1, 1, 0, 1});
    CHECK(bits_of(rests.rests[1].state) == Bits{1, 1, 1, 0});
    const Rest& swinging = rests.rests[2];
    CHECK(swinging.kind == Rest::Kind::oscillates);
    CHECK(swinging.firings.empty());
    // Both fall together, both rise together.
    REQUIRE(swinging.turn.size() == 2);
    CHECK(swinging.turn[0].size() == 2);
    CHECK(swinging.turn[1].size() == 2);
    CHECK(swinging.changing == std::vector<NetId>{small.net("x"), small.net("q")});
}

TEST_CASE("orders: gates that keep one another excited need not be told apart") {
    // Twenty chains of three inverters side by side: one way to rest, and few states.
    SmallNetlist small;
    small.input("a");
    for (int chain = 0; chain < 20; ++chain) {
        const std::string name = "c" + std::to_string(chain);
        small.cell(CellType::inverter, name + "0", {"a"});
        small.cell(CellType::inverter, name + "1", {name + "0"});
        small.cell(CellType::inverter, name + "2", {name + "1"});
    }
    Bits bits(small.netlist.net_count());
    for (const Cell& cell : small.netlist.cells) {
        const bool is_middle = small.netlist.names[cell.output].back() == '1';
        bits[index_of(cell.output)] = is_middle ? 0 : 1;
    }
    bits[index_of(small.net("a"))] = 1;
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    AnyOrder orders(circuit, {});
    const Rests rests = orders.settle(state_of(bits), true, enough);
    REQUIRE(rests.rests.size() == 1);
    CHECK(rests.states == 61);
    CHECK(rests.rests[0].firings.size() == 60);
}

TEST_CASE("orders: a search that is given too few states says so") {
    SmallNetlist small = released_latch();
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    AnyOrder orders(circuit, {});
    CHECK(orders.settle(state_of({1, 1, 1, 1}), true, 2).is_too_large);
    AnyOrder stopped(circuit, [] { return false; });
    CHECK(stopped.settle(state_of({1, 1, 1, 1}), true, enough).broken_off);
}

TEST_CASE("orders: what is found is what the definition says, on random netlists") {
    std::mt19937 random(7);
    int races = 0;
    int endless = 0;
    for (std::size_t number = 0; number < case_count(1500); ++number) {
        CAPTURE(number);
        // Going by the definition takes four times as long for each gate more.
        const std::size_t gates = 2 + random() % (number % 20 == 0 ? 7 : 5);
        const Netlist netlist = random_gates(random, gates);
        const Bits start = random_bits(random, netlist);
        const Outcomes expected = outcomes_by_definition(netlist, start);
        const Circuit circuit(netlist, all_nets(netlist));
        AnyOrder orders(circuit, {});
        for (const bool with_firings : {true, false}) {
            const Outcomes found =
                outcomes_of(orders.settle(state_of(start), with_firings, enough));
            CHECK(found.rests == expected.rests);
            CHECK(found.can_go_on_for_ever == expected.can_go_on_for_ever);
        }
        races += expected.rests.size() > 1 ? 1 : 0;
        endless += expected.can_go_on_for_ever ? 1 : 0;
    }
    CHECK(races > 0);
    CHECK(endless > 0);
}

TEST_CASE("orders: the firings that are told lead where they are said to") {
    std::mt19937 random(11);
    for (std::size_t number = 0; number < case_count(300); ++number) {
        CAPTURE(number);
        const Netlist netlist = random_gates(random, 3 + random() % 6);
        const Circuit circuit(netlist, all_nets(netlist));
        AnyOrder orders(circuit, {});
        const Bits start = random_bits(random, netlist);
        const Rests rests = orders.settle(state_of(start), true, enough);
        for (const Rest& rest : rests.rests) {
            CircuitState state = state_of(start);
            for (const Firing& firing : rest.firings) circuit.perform(firing, state);
            CHECK(state == rest.state);
            for (const Firing& firing : rest.turn) circuit.perform(firing, state);
            CHECK(state == rest.state);
            const bool is_endless = rest.kind == Rest::Kind::oscillates;
            CHECK(rest.turn.empty() != is_endless);
            CHECK(circuit.actions(state).empty() != is_endless);
        }
    }
}
