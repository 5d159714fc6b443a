// Whether a net can change more often than it may within an instant.

#include <doctest/doctest.h>

#include <algorithm>

#include "all_orders.h"
#include "random/random_cases.h"
#include "random_gates.h"
#include "settling/any_order.h"
#include "settling/any_wire.h"
#include "settling/cell_bands.h"
#include "settling/timed_order.h"
#include "simulate/simulator.h"
#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

using Answer = Pulsing::Answer;

/// y = a.b + /a.c, with b.c as well where it is asked for.
SmallNetlist selection(bool with_consensus) {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    small.input("c");
    small.cell(CellType::inverter, "not_a", {"a"});
    small.cell(CellType::and_gate, "first", {"a", "b"});
    small.cell(CellType::and_gate, "second", {"not_a", "c"});
    std::vector<std::string> terms{"first", "second"};
    if (with_consensus) {
        small.cell(CellType::and_gate, "both", {"b", "c"});
        terms.emplace_back("both");
    }
    small.cell(CellType::or_gate, "y", terms);
    return small;
}

/// At rest with these nets at 1. One that the netlist does not have yet is added to it.
Bits at_one(SmallNetlist& small, const std::vector<std::string>& names) {
    std::vector<NetId> nets;
    for (const std::string& name : names) nets.push_back(small.net(name));
    Bits bits(small.netlist.net_count());
    for (const NetId net : nets) bits[index_of(net)] = 1;
    return bits;
}

Pulsing under(std::string_view delays, const Netlist& netlist, const Bits& start,
              const WatchedNet& watched) {
    const Circuit circuit(netlist, all_nets(netlist));
    const auto model = make_settling_model(*delay_model_of(delays), circuit, {});
    return model->pulsing(state_of(start), watched, enough);
}

/// How often a net changes when these are fired one after the other; all is at rest then.
unsigned changes_by(const Netlist& netlist, const Bits& start, NetId net,
                    const std::vector<Firing>& firings) {
    const Circuit circuit(netlist, all_nets(netlist));
    CircuitState state = state_of(start);
    unsigned changes = 0;
    for (const Firing& firing : firings) {
        const Logic before = state.values[index_of(net)];
        circuit.perform(firing, state);
        changes += state.values[index_of(net)] != before ? 1 : 0;
    }
    CHECK(circuit.actions(state).empty());
    return changes;
}

}  // namespace

TEST_CASE("pulses: a.b + /a.c can fall for a moment as a changes, and not with b.c beside them") {
    for (const bool rises : {false, true}) {
        CAPTURE(rises);
        SmallNetlist bare = selection(false);
        SmallNetlist covered = selection(true);
        // Just after the change of a.
        const std::vector<std::string> fallen{"b", "c", "first", "y", "both"};
        const std::vector<std::string> risen{"a", "b", "c", "not_a", "second", "y", "both"};
        const Bits with_hazard = at_one(bare, rises ? risen : fallen);
        const WatchedNet y{bare.net("y"), 0};
        const Bits start(with_hazard.begin(),
                         with_hazard.begin() + static_cast<std::ptrdiff_t>(index_of(y.net)) + 1);
        for (const char* delays : {"any", "any-wire", "1..4"}) {
            CAPTURE(delays);
            const Pulsing found = under(delays, selection(false).netlist, start, y);
            REQUIRE(found.answer == Answer::shown);
            CHECK(changes_by(selection(false).netlist, start, y.net, found.firings) > 0);
            CHECK(under(delays, covered.netlist, at_one(covered, rises ? risen : fallen),
                        {covered.net("y"), 0})
                      .answer == Answer::never);
        }
        // With equal gates only the fall of a shows it, by the gate more on the way of the other.
        CHECK(under("1..1", selection(false).netlist, start, y).answer ==
              (rises ? Answer::never : Answer::shown));
    }
}

TEST_CASE("pulses: a dynamic hazard is one change that comes as three") {
    // y = (a + /a.b) . (slow way of a): it is to rise once.
    SmallNetlist small;
    small.input("a");
    small.cell(CellType::inverter, "n1", {"a"});
    small.cell(CellType::inverter, "n2", {"n1"});
    small.cell(CellType::and_gate, "pulse", {"a", "n1"});
    small.cell(CellType::or_gate, "y", {"pulse", "n2"});
    const Bits start = at_one(small, {"a", "n1"});
    const NetId y = small.net("y");
    CHECK(changes_by_definition(small.netlist, start, y, 9) == 3);
    CHECK(under("any", small.netlist, start, {y, 1}).answer == Answer::shown);
    CHECK(under("any", small.netlist, start, {y, 3}).answer == Answer::never);
    CHECK(under("1..9", small.netlist, start, {y, 1}).answer == Answer::shown);
    CHECK(under("1..1", small.netlist, start, {y, 1}).answer == Answer::never);
}

TEST_CASE("pulses: a search that is given too few states says so") {
    SmallNetlist small = selection(false);
    const Bits start = at_one(small, {"a", "b", "c", "not_a", "second", "y"});
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    CHECK(AnyOrder(circuit, {}).pulsing(state_of(start), {small.net("y"), 2}, 1).answer ==
          Answer::open);
    CHECK(AnyOrder(circuit, [] { return false; })
              .pulsing(state_of(start), {small.net("y"), 2}, enough)
              .answer == Answer::open);
}

TEST_CASE("pulses: what is found is what the definition says, on random netlists") {
    std::mt19937 random(23);
    int pulses = 0;
    int quiet = 0;
    for (std::size_t number = 0; number < case_count(1200); ++number) {
        CAPTURE(number);
        const std::size_t gates = 3 + random() % (number % 20 == 0 ? 6 : 4);
        const Netlist netlist = random_gates(random, gates);
        const Bits start = random_bits(random, netlist);
        if (outcomes_by_definition(netlist, start).can_go_on_for_ever) continue;
        const NetId net = netlist.cells.items()[random() % gates].output;
        const auto most = static_cast<std::uint8_t>(random() % 3);
        const bool expected = changes_by_definition(netlist, start, net, most + 1U) > most;
        const Pulsing found = under("any", netlist, start, {net, most});
        CHECK(found.answer == (expected ? Answer::shown : Answer::never));
        if (found.answer == Answer::shown) {
            CHECK(changes_by(netlist, start, net, found.firings) > most);
        }
        (expected ? pulses : quiet) += 1;
    }
    CHECK(pulses > 0);
    CHECK(quiet > 0);
}

TEST_CASE(
    "pulses: between bounds no simulation shows what cannot be, and what can be is possible") {
    std::mt19937 random(29);
    int pulses = 0;
    int quiet = 0;
    for (std::size_t number = 0; number < case_count(400); ++number) {
        CAPTURE(number);
        const Netlist netlist = random_gates(random, 3 + random() % 5);
        const Circuit circuit(netlist, all_nets(netlist));
        const Rests rests =
            AnyOrder(circuit, {}).settle(state_of(random_bits(random, netlist)), false, enough);
        const bool rests_here = !rests.rests.empty() && rests.rests[0].kind == Rest::Kind::settles;
        if (!rests_here) continue;
        const Bits rest = bits_of(rests.rests[0].state);
        Bits start = rest;
        start[index_of(netlist.inputs[0].net)] ^= 1U;
        if (outcomes_by_definition(netlist, start).can_go_on_for_ever) continue;
        const NetId net = netlist.cells.items()[random() % netlist.cells.size()].output;
        const auto most = static_cast<std::uint8_t>(random() % 2);
        const Pulsing found = under("1..3", netlist, start, {net, most});
        if (found.answer == Answer::shown) {
            CHECK(changes_by_definition(netlist, start, net, most + 1U) > most);
            CHECK(changes_by(netlist, start, net, found.firings) > most);
            ++pulses;
        }
        if (found.answer != Answer::never) continue;
        ++quiet;
        for (int circuit_number = 0; circuit_number < 20; ++circuit_number) {
            CellDelays delays = cell_delays(netlist, *delay_model_of("1..3"));
            for (Time& delay : delays.rise) delay = 1000 + static_cast<Time>(random() % 9) * 250;
            for (Time& delay : delays.fall) delay = 1000 + static_cast<Time>(random() % 9) * 250;
            Simulator simulator(netlist, delays);
            SimulatorState state = simulator.save();
            state.values = state_of(rest).values;
            simulator.restore(state);
            unsigned changes = 0;
            simulator.observe([&](Time, NetId changed, Logic) { changes += changed == net; });
            simulator.set_input(netlist.inputs[0].net,
                                static_cast<Logic>(start[index_of(netlist.inputs[0].net)]));
            simulator.settle();
            CHECK(changes <= most);
        }
    }
    CHECK(pulses > 0);
    CHECK(quiet > 0);
}
