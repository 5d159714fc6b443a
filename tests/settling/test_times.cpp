#include <doctest/doctest.h>

#include <algorithm>

#include "random/random_cases.h"
#include "random_gates.h"
#include "settling/any_order.h"
#include "settling/cell_bands.h"
#include "settling/timed_order.h"
#include "simulate/simulator.h"
#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

DelayModel bounds(std::string_view text) {
    return *delay_model_of(text);
}

/// An inverter chain of `stages` against one gate: whichever is first decides a latch.
SmallNetlist race_of(int stages) {
    SmallNetlist small;
    small.input("a");
    std::string last = "a";
    for (int stage = 0; stage < stages; ++stage) {
        const std::string name = "c" + std::to_string(stage);
        small.cell(CellType::buffer, name, {last});
        last = name;
    }
    small.cell(CellType::buffer, "quick", {"a"});
    // It catches a 1 if the quick one comes before the chain.
    small.cell(CellType::inverter, "not_yet", {last});
    small.cell(CellType::and_gate, "first", {"quick", "not_yet"});
    small.cell(CellType::or_gate, "caught", {"first", "caught"});
    return small;
}

bool is_caught_always(const SmallNetlist& race, const DelayModel& model) {
    SmallNetlist small = race;
    Bits bits(small.netlist.net_count());
    bits[index_of(small.net("a"))] = 1;
    bits[index_of(small.net("not_yet"))] = 1;
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    TimedOrder orders(circuit, cell_bands(small.netlist, model), {});
    const Rests rests = orders.settle(state_of(bits), false, enough);
    REQUIRE(!rests.is_too_large);
    return std::all_of(rests.rests.begin(), rests.rests.end(), [&](const Rest& rest) {
        return rest.kind == Rest::Kind::settles &&
               rest.state.values[index_of(small.net("caught"))] == Logic::one;
    });
}

/// Where a netlist at rest goes when its first input changes, with one delay for each edge of each
/// gate; nothing where it does not come to rest.
std::optional<Bits> simulated(const Netlist& netlist, const Bits& rest, const CellDelays& delays) {
    Simulator simulator(netlist, delays);
    SimulatorState state = simulator.save();
    state.values = state_of(rest).values;
    simulator.restore(state);
    const NetId input = netlist.inputs[0].net;
    simulator.set_input(input, rest[index_of(input)] == 0 ? Logic::one : Logic::zero);
    if (!simulator.settle().settled) return std::nullopt;
    CircuitState after;
    after.values = simulator.save().values;
    return bits_of(after);
}

/// A state at rest that the netlist finds from some values, if it finds one.
std::optional<Bits> rest_from(const Netlist& netlist, const Bits& start) {
    const Circuit circuit(netlist, all_nets(netlist));
    const Rests rests = AnyOrder(circuit, {}).settle(state_of(start), false, enough);
    for (const Rest& rest : rests.rests) {
        if (rest.kind == Rest::Kind::settles) return bits_of(rest.state);
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("times: a chain is beaten by one gate as long as the bounds let it be slower") {
    // quick and first (2 gates) against the chain and not_yet (stages + 1), and the pulse of
    // `first` has to last until `caught` has taken it.
    CHECK(is_caught_always(race_of(3), bounds("1..1")));
    CHECK(is_caught_always(race_of(3), bounds("1..1.3")));
    CHECK(!is_caught_always(race_of(3), bounds("1..2")));
    CHECK(is_caught_always(race_of(8), bounds("1..2")));
    CHECK(!is_caught_always(race_of(8), bounds("1..4")));
}

TEST_CASE("times: whatever delays within the bounds, a simulation ends where it can") {
    std::mt19937 random(5);
    int races = 0;
    int tried = 0;
    for (std::size_t number = 0; number < case_count(600); ++number) {
        CAPTURE(number);
        const std::size_t gates = 3 + random() % 6;
        const Netlist netlist = random_gates(random, gates);
        const auto rest = rest_from(netlist, random_bits(random, netlist));
        if (!rest) continue;
        Bits start = *rest;
        start[index_of(netlist.inputs[0].net)] ^= 1U;
        const Circuit circuit(netlist, all_nets(netlist));
        const Rests found = TimedOrder(circuit, cell_bands(netlist, bounds("1..3")), {})
                                .settle(state_of(start), false, enough);
        REQUIRE(!found.is_too_large);
        const Rests any = AnyOrder(circuit, {}).settle(state_of(start), false, enough);
        const auto can_rest = [](const Rests& rests, const Bits& bits) {
            return std::any_of(rests.rests.begin(), rests.rests.end(), [&](const Rest& one_rest) {
                return one_rest.kind == Rest::Kind::settles && bits_of(one_rest.state) == bits;
            });
        };
        const bool can_swing = std::any_of(
            found.rests.begin(), found.rests.end(),
            [](const Rest& one_rest) { return one_rest.kind == Rest::Kind::oscillates; });
        for (const Rest& one_rest : found.rests) {
            if (one_rest.kind != Rest::Kind::settles) continue;
            CHECK(can_rest(any, bits_of(one_rest.state)));
        }
        races += found.rests.size() > 1 ? 1 : 0;
        for (int circuit_number = 0; circuit_number < 20; ++circuit_number) {
            CellDelays delays = cell_delays(netlist, bounds("1..3"));
            for (Time& delay : delays.rise) delay = 1000 + static_cast<Time>(random() % 9) * 250;
            for (Time& delay : delays.fall) delay = 1000 + static_cast<Time>(random() % 9) * 250;
            const auto end = simulated(netlist, *rest, delays);
            ++tried;
            CHECK((end ? can_rest(found, *end) : can_swing));
        }
    }
    CHECK(races > 0);
    CHECK(tried > 0);
}
