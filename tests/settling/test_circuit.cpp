#include <doctest/doctest.h>

#include "random_gates.h"
#include "settling/any_order.h"
#include "settling/circuit.h"
#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

CircuitState state_with(const Circuit& circuit, const Bits& before, const Bits& bits) {
    CircuitState state = state_of(bits);
    state.unanswered = circuit.edges_between(state_of(before).values, state.values);
    return state;
}

}  // namespace

TEST_CASE("circuit: a state is what its encoding says") {
    SmallNetlist small;
    small.input("a");
    small.timed(CellType::timer, "t", {"a"}, {second, 0, 0});
    small.timed(CellType::rise_pulse, "p", {"a"}, {0, nanosecond, 0});
    small.cell(CellType::nand_gate, "g", {"t", "p"});
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    CircuitState state = state_of({1, 0, 1, 0});
    state.values[index_of(small.net("g"))] = Logic::unknown;
    state.timers = {{TimerRun::begun, Logic::one}};
    state.unanswered = {3};
    CircuitState copy = state_of({1, 1, 0, 1});
    copy.timers.resize(1);
    copy.unanswered.resize(1);
    circuit.decode(circuit.encoded(state), copy);
    CHECK(copy == state);
}

TEST_CASE("circuit: a pulse answers an edge, and ends, at any time") {
    SmallNetlist small;
    small.input("a");
    small.timed(CellType::rise_pulse, "p", {"a"}, {0, nanosecond, 0});
    small.cell(CellType::or_gate, "seen", {"p", "seen"});
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    AnyOrder orders(circuit, {});
    // The pulse may be over before the gate behind has taken it.
    const Rests rests = orders.settle(state_with(circuit, {0, 0, 0}, {1, 0, 0}), false, enough);
    REQUIRE(rests.rests.size() == 2);
    CHECK(bits_of(rests.rests[0].state) == Bits{1, 0, 0});
    CHECK(bits_of(rests.rests[1].state) == Bits{1, 0, 1});
    CHECK(orders.settle(state_with(circuit, {1, 0, 0}, {0, 0, 0}), false, enough).states == 1);
}

TEST_CASE("circuit: a timer begins its delay with its operand, and gives it up with it") {
    SmallNetlist small;
    small.input("a");
    small.cell(CellType::buffer, "e", {"a"});
    small.timed(CellType::timer, "t", {"e"}, {second, 0, 0});
    const Circuit circuit(small.netlist, all_nets(small.netlist));
    AnyOrder orders(circuit, {});
    CircuitState rising = state_of({1, 0, 0});
    rising.timers.resize(1);
    Rests rests = orders.settle(rising, false, enough);
    REQUIRE(rests.rests.size() == 1);
    CHECK(rests.rests[0].state.timers[0] == TimerState{TimerRun::begun, Logic::one});
    CHECK(circuit.length_of(0, rests.rests[0].state) == second);

    CircuitState due = state_of({1, 1, 0});
    due.timers = {{TimerRun::ends, Logic::one}};
    rests = orders.settle(due, true, enough);
    REQUIRE(rests.rests.size() == 1);
    CHECK(bits_of(rests.rests[0].state) == Bits{1, 1, 1});
    CHECK(rests.rests[0].state.timers[0].run == TimerRun::idle);

    // The operand goes in the instant at which the delay would have ended.
    CircuitState too_late = state_of({0, 1, 0});
    too_late.timers = {{TimerRun::ends, Logic::one}};
    rests = orders.settle(too_late, true, enough);
    REQUIRE(rests.rests.size() == 1);
    CHECK(bits_of(rests.rests[0].state) == Bits{0, 0, 0});
    CHECK(rests.rests[0].state.timers[0].run == TimerRun::idle);
}

TEST_CASE("circuit: cells that do not count never fire") {
    SmallNetlist small;
    small.input("a");
    small.cell(CellType::inverter, "x", {"a"});
    small.cell(CellType::inverter, "y", {"a"});
    std::vector<std::uint8_t> relevant = all_nets(small.netlist);
    relevant[index_of(small.net("y"))] = 0;
    const Circuit circuit(small.netlist, relevant);
    CHECK(circuit.actions(state_of({1, 1, 1})).size() == 1);
    CHECK(circuit.readers(small.net("a")).size() == 1);
}
