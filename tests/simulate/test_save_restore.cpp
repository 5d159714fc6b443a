#include <doctest/doctest.h>

#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// A latch of NAND gates, a latch, a flip-flop, a pulse cell and a timer.
SmallNetlist mixed() {
    SmallNetlist small;
    for (const char* name : {"s", "r", "d", "c"}) small.input(name);
    small.cell(CellType::nand_gate, "q", {"s", "nq"});
    small.cell(CellType::nand_gate, "nq", {"r", "q"});
    small.cell(CellType::latch, "l", {"d", "r"}, zero);
    small.cell(CellType::flip_flop, "f", {"d", "c"}, zero);
    small.timed(CellType::rise_pulse, "p", {"d"}, {0, 6 * nanosecond, 0});
    small.timed(CellType::timer, "t", {"l"}, {3 * millisecond, 0, 0}, zero);
    small.cell(CellType::xor_gate, "y", {"q", "l", "f", "p", "t"});
    return small;
}

void settle_with(Bench& bench, std::initializer_list<Logic> s_r_d_c) {
    const char* const names[] = {"s", "r", "d", "c"};
    std::size_t i = 0;
    for (const Logic value : s_r_d_c) bench.set(names[i++], value);
    REQUIRE(bench.simulator.settle().settled);
}

}  // namespace

TEST_CASE("what follows a restored state is what followed the saved one") {
    for (const Time odd : {1000, 1500}) {
        SmallNetlist small = mixed();
        CellDelays delays = cell_delays(small.netlist, {});
        delays.fall[0] = odd;
        Bench bench(small, delays);
        settle_with(bench, {zero, one, zero, zero});
        settle_with(bench, {one, one, one, zero});
        CHECK(bench.get("q") == one);
        CHECK(bench.simulator.is_running(0));
        const SimulatorState saved = bench.simulator.save();

        const auto follow = [&] {
            bench.record("y");
            settle_with(bench, {one, zero, one, one});
            settle_with(bench, {one, one, zero, zero});
            settle_with(bench, {one, one, one, zero});
            if (bench.simulator.due(0) <= saved.now + 3 * millisecond) {
                bench.simulator.end_delay(0, one);
            }
            settle_with(bench, {one, zero, zero, zero});
            bench.simulator.observe({});
            return bench.changes;
        };
        const std::string first = follow();
        CHECK(first.size() > 20);
        const SimulatorState end = bench.simulator.save();
        CHECK(end.values != saved.values);

        bench.simulator.restore(saved);
        const SimulatorState again = bench.simulator.save();
        CHECK(again.values == saved.values);
        CHECK(again.due == saved.due);
        CHECK(again.towards == saved.towards);
        CHECK(again.now == saved.now);
        CHECK(bench.simulator.settle().events == 0);
        CHECK(follow() == first);
        CHECK(bench.simulator.save().values == end.values);
        CHECK(bench.simulator.save().due == end.due);
    }
}

TEST_CASE("a restored pulse cell or flip-flop sees no edge in the restoring") {
    SmallNetlist small = mixed();
    Bench bench(small);
    settle_with(bench, {zero, one, zero, zero});
    const SimulatorState low = bench.simulator.save();
    settle_with(bench, {zero, one, one, zero});
    settle_with(bench, {zero, one, one, one});
    CHECK(bench.get("f") == one);
    const SimulatorState high = bench.simulator.save();
    bench.simulator.restore(low);
    settle_with(bench, {zero, one, one, zero});
    bench.simulator.restore(high);
    bench.record("p");
    CHECK(bench.simulator.settle().events == 0);
    settle_with(bench, {zero, one, one, one});
    CHECK(bench.changes == "");
    CHECK(bench.get("f") == one);
}

TEST_CASE("a state can be restored in the midst of an oscillation") {
    SmallNetlist small;
    small.input("go");
    small.timed(CellType::rise_pulse, "p", {"y"}, {0, 2 * nanosecond, 0});
    small.cell(CellType::nand_gate, "y", {"go", "y"});
    for (const Time odd : {1000, 1500}) {
        CellDelays delays = cell_delays(small.netlist, {});
        delays.fall[1] = odd;
        Bench bench(small, delays);
        bench.step("go", zero);
        const SimulatorState saved = bench.simulator.save();
        bench.set("go", one);
        CHECK_FALSE(bench.simulator.settle().settled);
        bench.simulator.restore(saved);
        const Settling settling = bench.simulator.settle();
        CHECK(settling.settled);
        CHECK(settling.events == 0);
        CHECK(bench.get("y") == one);
        CHECK(bench.get("p") == zero);
    }
}

TEST_CASE("a pulse that an oscillation has begun is not there in a restored state") {
    SmallNetlist small;
    small.input("go");
    small.input("k");
    small.timed(CellType::rise_pulse, "p", {"d"}, {0, 100 * nanosecond, 0});
    small.cell(CellType::xor_gate, "d", {"n", "k"});
    small.cell(CellType::nor_gate, "n", {"p", "stop"});
    small.cell(CellType::inverter, "stop", {"go"});
    Bench bench(small);
    {
        const Preparation preparation(bench.simulator);
        bench.step("go", zero);
        bench.step("k", one);
    }
    const SimulatorState saved = bench.simulator.save();
    bench.step("k", zero);
    bench.set("go", one);
    REQUIRE_FALSE(bench.simulator.settle().settled);
    bench.simulator.restore(saved);
    bench.record("p");
    bench.step("k", zero);  // a fall, which gives no pulse
    CHECK(bench.changes == "");
    CHECK(bench.get("p") == zero);
}

TEST_CASE("two simulations of one netlist do not disturb each other") {
    SmallNetlist small = mixed();
    Bench a(small);
    Bench b(small);
    settle_with(a, {zero, one, zero, zero});
    settle_with(b, {one, zero, zero, zero});
    settle_with(a, {one, one, zero, zero});
    settle_with(b, {one, one, zero, zero});
    CHECK(a.get("q") == one);
    CHECK(b.get("q") == zero);
}
