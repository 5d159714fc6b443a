#include <doctest/doctest.h>

#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// y follows a after 5 ns up and 3 ns down.
struct SlowBuffer {
    SmallNetlist small;
    CellDelays delays;
    SlowBuffer() {
        small.input("a");
        small.input("b");
        small.cell(CellType::buffer, "y", {"a"});
        small.cell(CellType::buffer, "fast", {"b"});
        delays = {{5000, 1000}, {3000, 1000}};
    }
};

}  // namespace

TEST_CASE("with unit delays every gate takes a nanosecond") {
    SmallNetlist small;
    small.input("a");
    small.cell(CellType::inverter, "n1", {"a"});
    small.cell(CellType::inverter, "n2", {"n1"});
    small.cell(CellType::and_gate, "glitch", {"a", "n1"});
    small.cell(CellType::inverter, "n3", {"n2"});
    Bench bench(small);
    bench.step("a", zero);
    CHECK(bench.simulator.now() == 3 * nanosecond);
    bench.record("n3");
    const Settling settling = bench.simulator.settle();
    CHECK(settling.events == 0);
    bench.step("a", one);
    CHECK(bench.changes == "0@3");
    bench.record("glitch");
    bench.at(20);
    bench.step("a", zero);
    bench.at(40);
    bench.set("a", one);
    // a itself, n1, n2, n3, and the glitch up and down.
    CHECK(bench.simulator.settle().events == 6);
    CHECK(bench.changes == "1@35 0@36");
}

TEST_CASE("changes of one moment are one change") {
    SmallNetlist small;
    small.input("a");
    small.cell(CellType::buffer, "b", {"a"});
    small.cell(CellType::inverter, "c", {"a"});
    small.cell(CellType::xor_gate, "same", {"b", "c"});
    Bench bench(small);
    bench.step("a", zero);
    bench.record("same");
    bench.step("a", one);
    bench.step("a", zero);
    CHECK(bench.changes == "");
    CHECK(bench.get("same") == one);
}

TEST_CASE("rise and fall have delays of their own") {
    SlowBuffer slow;
    Bench bench(slow.small, slow.delays);
    bench.step("a", zero);
    CHECK(bench.simulator.now() == 3 * nanosecond);
    bench.record("y");
    bench.step("a", one);
    bench.step("a", zero);
    CHECK(bench.changes == "1@5 0@8");
}

TEST_CASE("a pulse shorter than the delay is swallowed, one exactly as long passes") {
    SmallNetlist small;
    small.input("a");
    // A pulse on p of as many nanoseconds as the chain of buffers is long.
    small.cell(CellType::buffer, "d1", {"a"});
    small.cell(CellType::buffer, "d2", {"d1"});
    small.cell(CellType::inverter, "n", {"d2"});
    small.cell(CellType::and_gate, "p", {"a", "n"});
    small.cell(CellType::buffer, "y", {"p"});
    const auto changes = [&](Time rise, Time fall) {
        CellDelays delays = cell_delays(small.netlist, {});
        delays.rise[4] = rise;
        delays.fall[4] = fall;
        Bench bench(small, delays);
        bench.step("a", zero);
        bench.record("y");
        bench.step("a", one);
        return bench.changes;
    };
    CHECK(changes(1000, 1000) == "1@2 0@5");
    CHECK(changes(3000, 1000) == "1@4 0@5");
    CHECK(changes(3001, 1000) == "");
    CHECK(changes(4000, 1000) == "");
    CHECK(changes(2500, 700) == "1@3.500 0@4.700");
    // Far beyond the lists of the wheel.
    CHECK(changes(1, 1'000'000'000) == "1@1.1 0@1000004");
}

TEST_CASE("a change that is taken back and made again starts its delay anew") {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    // q falls for a nanosecond within a second of a's rise.
    small.cell(CellType::buffer, "b1", {"a"});
    small.cell(CellType::buffer, "b2", {"b1"});
    small.cell(CellType::inverter, "n", {"b2"});
    small.cell(CellType::xor_gate, "q", {"b1", "b2", "a"});
    small.cell(CellType::buffer, "y", {"q"});
    CellDelays delays = cell_delays(small.netlist, {});
    delays.rise[4] = 6000;
    delays.fall[4] = 2000;
    Bench bench(small, delays);
    bench.step("a", zero);
    bench.record("q");
    bench.step("a", one);
    // a rises at 0, b1 at 1, b2 at 2: the sum is odd, even, odd.
    CHECK(bench.changes == "1@1 0@2 1@3");
    bench.step("a", zero);
    bench.at(100);
    bench.record("y");
    bench.step("a", one);
    CHECK(bench.changes == "1@9");
}

TEST_CASE("unknown comes no later than the known value it may replace") {
    SlowBuffer slow;
    slow.small.cell(CellType::and_gate, "z", {"a", "fast"});
    slow.delays.rise.push_back(4000);
    slow.delays.fall.push_back(4000);
    Bench bench(slow.small, slow.delays);
    bench.set("b", one);
    bench.step("a", zero);
    bench.record("z");
    // The AND is on its way to 1 at 4 ns when its other input turns unknown at 1 ns.
    bench.set("a", one);
    bench.set("b", unknown);
    bench.simulator.settle();
    CHECK(bench.changes == "x@4");
    bench.record("z");
    bench.step("b", one);
    CHECK(bench.changes == "1@5");
}

TEST_CASE("unknown comes when the output may have changed, and goes once it must have") {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    small.cell(CellType::buffer, "a1", {"a"});
    small.cell(CellType::buffer, "b2", {"b"});
    small.cell(CellType::or_gate, "y", {"a1", "b2"});
    Bench bench(small, {{1000, 2000, 4000}, {1000, 2000, 4000}});
    bench.set("b", zero);
    bench.step("a", zero);
    bench.record("y");
    bench.set("a", unknown);
    bench.step("b", one);
    // From the rise of a1 at 1 ns, if it is one, or else from that of b2 at 2 ns.
    CHECK(bench.changes == "x@5 1@6");
    bench.set("a", zero);
    bench.step("b", zero);
    bench.record("y");
    // Back at its value before anything was seen: nothing happens.
    bench.set("b", zero);
    bench.set("a", unknown);
    bench.set("a", zero);
    bench.simulator.settle();
    CHECK(bench.changes == "");
}

TEST_CASE("the clock moves with the instants unless the gates are ahead") {
    SlowBuffer slow;
    Bench bench(slow.small, slow.delays);
    bench.simulator.power_up();
    bench.step("a", zero);
    CHECK(bench.simulator.now() == 3 * nanosecond);
    bench.at(2);
    CHECK(bench.simulator.now() == 3 * nanosecond);
    bench.simulator.begin_instant(7 * nanosecond + 1);
    CHECK(bench.simulator.now() == 7 * nanosecond + 1);
    bench.record("y");
    bench.step("a", one);
    CHECK(bench.simulator.now() == 12 * nanosecond + 1);
    CHECK(bench.changes == "1@5");
    { const Preparation preparation(bench.simulator); }
    CHECK(bench.simulator.now() == 0);
    bench.record("y");
    bench.step("a", zero);
    CHECK(bench.changes == "0@3");
    CHECK(bench.simulator.now() == 3 * nanosecond);
}
