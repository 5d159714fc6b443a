// Clocked timers as counters do, scan by scan, what the timers do.

#include <doctest/doctest.h>

#include <random>

#include "formats/benches.h"
#include "formats/sample_netlists.h"
#include "netlist/passes/counted_timers.h"
#include "simulate/simulator.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// `outer = o1/(o2/a/o3)/o4`, with the look-ahead in between.
Netlist nested_timers(const Timing& inner, const Timing& outer) {
    NetlistMaker maker("nested");
    maker.input("a").input("clk").output("inner").output("outer").output("inner$next");
    maker.cell(CellType::scan_timer, "inner", {"a", "clk"}, Logic::zero, inner)
        .cell(CellType::scan_timer_next, "inner$next", {"a", "inner", "clk"}, Logic::unknown, inner)
        .cell(CellType::scan_timer, "outer", {"inner$next", "clk"}, Logic::zero, outer);
    return maker.make();
}

/// The outputs before every rise of the clock, for an operand that changes at random.
std::string scans_of(const Netlist& netlist, Time period, std::uint32_t seed) {
    Simulator simulator(netlist, cell_delays(netlist, {}));
    std::minstd_rand random(seed);
    std::string rows;
    bool operand = false;
    simulator.set_input(netlist.clock, Logic::zero);
    for (int scan = 0; scan < 200; ++scan) {
        simulator.begin_instant(scan * period);
        if ((random() >> 8U) % 6 == 0) operand = !operand;
        simulator.set_input(netlist.inputs[0].net, operand ? Logic::one : Logic::zero);
        REQUIRE(simulator.settle().settled);
        for (const Port& port : netlist.outputs) {
            const Logic value = simulator.value(port.net);
            rows += value == Logic::unknown ? 'x' : value == Logic::one ? '1' : '0';
        }
        rows += ' ';
        REQUIRE(simulator.clock_cycle().settled);
    }
    return rows;
}

}  // namespace

TEST_CASE("counters do what clocked timers do, scan by scan") {
    std::minstd_rand random(5);
    const auto delay = [&] { return static_cast<Time>((random() >> 8U) % 60) / 2 * ms; };
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        const Time rise = delay();
        const Time fall = seed % 4 == 0 ? 0 : delay();
        const Time outer = delay();
        Netlist netlist = nested_timers({rise, fall, 0}, {outer, seed % 3 == 0 ? fall : 0, 1});
        netlist.clock = netlist.inputs[1].net;
        const Time period = seed % 2 == 0 ? 5 * ms : 3 * ms + 1;
        const CountedTimers counted = with_counted_timers(netlist, period);
        CAPTURE(write_netlist_text(netlist));
        CHECK(fault_of(counted.netlist) == "");
        CHECK_FALSE(has_scan_timers(counted.netlist));
        const std::string expected = scans_of(netlist, period, seed);
        CHECK(expected.find('1') != std::string::npos);
        CHECK(scans_of(counted.netlist, period, seed) == expected);
    }
}

TEST_CASE("the gates of a timer") {
    NetlistMaker maker("one");
    maker.input("a").input("clk").output("t").output("t$on");
    maker.cell(CellType::scan_timer, "t", {"a", "clk"}, Logic::zero, {25 * ms, 40 * ms, 0})
        .cell(CellType::inverter, "t$on", {"a"});
    const CountedTimers counted = with_counted_timers(maker.make(), 10 * ms);
    CHECK(counted.flip_flops == 4);
    CHECK(counted.longest == 4);
    CHECK(write_netlist_text(counted.netlist) == R"(netlist one
input a
input clk
output t = t
output t$on = t$on
module all
  t$after3 = and(t$count0, t$count1)
  t$risen = or(t, t$after3)
  t$not_risen = not(t$risen)
  t$on$ = and(a, t$risen)
  t$rising = and(a, t$not_risen)
  t$off = not(a)
  t$not_fallen = not(t$count2)
  t$falling = and(t$off, t, t$not_fallen)
  t$run = or(t$rising, t$falling)
  t$sum0 = not(t$count0)
  t$count0$next = and(t$run, t$sum0)
  t$count0 = dff(t$count0$next, clk) initially 0
  t$sum1 = xor(t$count1, t$count0)
  t$count1$next = and(t$run, t$sum1)
  t$count1 = dff(t$count1$next, clk) initially 0
  t$carry1 = and(t$count1, t$count0)
  t$sum2 = xor(t$count2, t$carry1)
  t$count2$next = and(t$run, t$sum2)
  t$count2 = dff(t$count2$next, clk) initially 0
  t$next = or(t$on$, t$falling)
  t = dff(t$next, clk) initially 0
  t$on = not(a)
)");
}

TEST_CASE("delays of hours take a few flip-flops more") {
    NetlistMaker maker("hours");
    maker.input("a").input("clk").output("t");
    maker.cell(CellType::scan_timer, "t", {"a", "clk"}, Logic::zero, {10 * 3600 * second, 0, 0});
    const CountedTimers counted = with_counted_timers(maker.make(), 10 * ms);
    CHECK(counted.longest == 3'600'000);
    CHECK(counted.flip_flops == 23);
}
