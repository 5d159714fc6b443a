#include <doctest/doctest.h>

#include <algorithm>

#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string names(const SmallNetlist& small, const std::vector<NetId>& nets) {
    std::string text;
    for (const NetId net : nets) {
        if (!text.empty()) text += ' ';
        text += small.netlist.names[net];
    }
    return text;
}

/// Three inverters in a ring once `go` is 1, and a bystander.
void add_ring(SmallNetlist& small, const std::string& prefix) {
    small.cell(CellType::nand_gate, prefix + "1", {"go", prefix + "3"});
    small.cell(CellType::inverter, prefix + "2", {prefix + "1"});
    small.cell(CellType::inverter, prefix + "3", {prefix + "2"});
}

}  // namespace

TEST_CASE("a ring of three inverters oscillates, and its nets are named") {
    SmallNetlist small;
    small.input("go");
    small.cell(CellType::buffer, "calm", {"go"});
    add_ring(small, "r");
    Bench bench(small);
    bench.step("go", zero);
    CHECK(bench.get("r3") == one);
    bench.set("go", one);
    const Settling settling = bench.simulator.settle();
    CHECK_FALSE(settling.settled);
    CHECK(names(small, settling.oscillating) == "r1 r3 r2");  // in the order of their ids
    CHECK(settling.events > 0);
    // The state before can be put back.
    bench.simulator.power_up();
    bench.set("go", zero);
    CHECK(bench.simulator.settle().settled);
    CHECK(bench.get("r3") == one);
}

TEST_CASE("of long rings all nets are named, and none that has changed but once") {
    for (const int length : {31, 63, 65, 101}) {
        CAPTURE(length);
        SmallNetlist small;
        small.input("go");
        std::vector<NetId> rings;
        for (int ring = 0; ring < 8; ++ring) {
            const auto name = [&](int i) {
                return "r" + std::to_string(ring) + '.' + std::to_string(i);
            };
            small.cell(CellType::nand_gate, name(0), {"go", name(length - 1)});
            for (int i = 1; i < length; ++i) {
                small.cell(CellType::inverter, name(i), {name(i - 1)});
            }
            for (int i = 0; i < length; ++i) rings.push_back(small.net(name(i)));
        }
        // An edge that runs along a line, and for longer than it takes to suspect an oscillation.
        std::string last = "go";
        for (int i = 0; i < 10 * length; ++i) {
            const std::string name = "line" + std::to_string(i);
            small.cell(CellType::buffer, name, {last});
            last = name;
        }
        Bench bench(small);
        bench.step("go", zero);
        bench.set("go", one);
        const Settling settling = bench.simulator.settle();
        CHECK_FALSE(settling.settled);
        CHECK(bench.get(last) == one);
        std::sort(rings.begin(), rings.end());
        CHECK(names(small, settling.oscillating) == names(small, rings));
    }
}

TEST_CASE("a clock cycle does not settle if any part of it does not") {
    // A ring that runs before the rise of the clock, or between rise and fall, and then stops.
    for (const bool before_rise : {true, false}) {
        SmallNetlist small;
        small.clock("clk");
        small.input("a");
        small.cell(CellType::flip_flop, "q", {"a", "clk"}, zero);
        small.cell(CellType::inverter, "n", {"q"});
        if (before_rise) small.cell(CellType::and_gate, "go", {"a", "n"});
        if (!before_rise) small.cell(CellType::and_gate, "go", {"a", "clk"});
        add_ring(small, "r");
        Bench bench(small);
        bench.set("clk", zero);
        bench.step("a", zero);
        CHECK(bench.simulator.clock_cycle().settled);
        bench.set("a", one);
        const Settling cycle = bench.simulator.clock_cycle();
        CHECK_FALSE(cycle.settled);
        CHECK(names(small, cycle.oscillating) == "r1 r3 r2");
    }
}

TEST_CASE("a ring of inverters at power-up without a known value stays unknown, and settles") {
    SmallNetlist small;
    small.cell(CellType::inverter, "a", {"c"});
    small.cell(CellType::inverter, "b", {"a"});
    small.cell(CellType::inverter, "c", {"b"});
    Bench bench(small);
    CHECK(bench.simulator.settle().settled);
    CHECK(bench.get("a") == unknown);
}

TEST_CASE("cross-coupled NOR gates released together oscillate with equal delays only") {
    SmallNetlist small;
    small.input("s");
    small.input("r");
    small.cell(CellType::nor_gate, "q", {"r", "nq"});
    small.cell(CellType::nor_gate, "nq", {"s", "q"});
    CellDelays delays = cell_delays(small.netlist, {});
    const auto release = [&] {
        Bench bench(small, delays);
        bench.set("s", one);
        bench.step("r", one);
        bench.set("s", zero);
        bench.set("r", zero);
        const Settling settling = bench.simulator.settle();
        return settling.settled ? std::string("settled") : names(small, settling.oscillating);
    };
    CHECK(release() == "q nq");
    delays.rise[1] = 1001;
    CHECK(release() == "settled");
    delays.rise[0] = 1001;
    CHECK(release() == "q nq");
    delays.fall[0] = 300;
    delays.fall[1] = 300;
    CHECK(release() == "q nq");
}

TEST_CASE("two rings of different periods come back together") {
    SmallNetlist small;
    small.input("go");
    add_ring(small, "a");
    add_ring(small, "b");
    small.cell(CellType::and_gate, "both", {"a1", "b1"});
    CellDelays delays = cell_delays(small.netlist, {});
    delays.rise = {700, 700, 700, 1100, 1300, 1700, 1000};
    delays.fall = {900, 700, 700, 1100, 1300, 1700, 1000};
    Bench bench(small, delays);
    bench.step("go", zero);
    bench.set("go", one);
    const Settling settling = bench.simulator.settle();
    CHECK_FALSE(settling.settled);
    CHECK(settling.oscillating.size() == 7);
}

TEST_CASE("a pulse that sets itself off again oscillates") {
    SmallNetlist small;
    small.input("go");
    small.timed(CellType::rise_pulse, "p", {"n"}, {0, 10 * nanosecond, 0});
    small.cell(CellType::nor_gate, "n", {"p", "stop"});
    small.cell(CellType::inverter, "stop", {"go"});
    Bench bench(small);
    {
        const Preparation preparation(bench.simulator);
        bench.step("go", zero);
    }
    CHECK(bench.get("n") == zero);
    bench.set("go", one);
    const Settling settling = bench.simulator.settle();
    CHECK_FALSE(settling.settled);
    CHECK(names(small, settling.oscillating) == "p n");
}

TEST_CASE("a cascade may be long without being an oscillation") {
    // A token runs through 200 000 phase modules, over one input that lets all pass.
    SmallNetlist small;
    small.input("a");
    constexpr int steps = 200'000;
    const auto x = [](int i) { return "x" + std::to_string(i); };
    small.cell(CellType::low, "s0", {});
    small.cell(CellType::low, x(steps), {});
    for (int i = 0; i < steps; ++i) {
        const std::string n = std::to_string(i);
        if (i > 0) small.cell(CellType::and_gate, "s" + n, {x(i - 1), "a"});
        small.cell(CellType::inverter, "n" + n, {x(i + 1)});
        small.cell(CellType::and_gate, "h" + n, {"n" + n, x(i)});
        small.cell(CellType::or_gate, x(i), {"s" + n, "h" + n});
    }
    for (const Time odd : {1000, 1500}) {
        CellDelays delays = cell_delays(small.netlist, {});
        delays.rise[0] = odd;
        Bench bench(small, delays);
        {
            Preparation preparation(bench.simulator);
            for (int i = 0; i < steps; ++i) {
                preparation.hold(small.net(x(i)), i == 0 ? one : zero);
            }
            bench.step("a", zero);
        }
        REQUIRE(bench.simulator.settle().settled);
        bench.set("a", one);
        const Settling settling = bench.simulator.settle();
        CHECK(settling.settled);
        CHECK(settling.events > 8 * (steps - 2));
        CHECK(bench.get(x(steps - 1)) == one);
        CHECK(bench.get(x(steps - 2)) == zero);
    }
}

TEST_CASE("a counter of gates runs through all its states before it comes back") {
    // A ripple of toggling flip-flops, the first clocked by a ring: the period is that of the last.
    SmallNetlist small;
    small.input("go");
    add_ring(small, "r");
    std::string clock = "r1";
    constexpr int bits = 8;
    for (int i = 0; i < bits; ++i) {
        const std::string q = "q" + std::to_string(i);
        small.cell(CellType::flip_flop, q, {"n" + q, clock}, zero);
        small.cell(CellType::inverter, "n" + q, {q});
        clock = "n" + q;
    }
    Bench bench(small);
    // The first clock edge after power-up is none that is known of.
    {
        Preparation preparation(bench.simulator);
        for (int i = 0; i < bits; ++i) preparation.hold(small.net("q" + std::to_string(i)), zero);
        bench.step("go", zero);
    }
    CHECK(bench.get("q7") == zero);
    bench.set("go", one);
    const Settling settling = bench.simulator.settle();
    CHECK_FALSE(settling.settled);
    CHECK(settling.oscillating.size() == 3 + 2 * bits);
}

TEST_CASE("a cascade that is broken off stops where it is") {
    SmallNetlist small;
    small.input("a");
    std::string before = "a";
    for (int i = 0; i < 5000; ++i) {
        const std::string name = "b" + std::to_string(i);
        small.cell(CellType::buffer, name, {before});
        before = name;
    }
    for (const Time odd : {1000, 1500}) {
        CellDelays delays = cell_delays(small.netlist, {});
        delays.rise[0] = odd;
        Bench bench(small, delays);
        bench.step("a", zero);
        CHECK(bench.get("b4999") == zero);
        int asked = 0;
        bench.simulator.ask([&] { return ++asked < 2; });
        bench.set("a", one);
        const Settling settling = bench.simulator.settle();
        CHECK_FALSE(settling.settled);
        CHECK(settling.broken_off);
        CHECK(settling.oscillating.empty());
        CHECK(asked == 2);
        CHECK(bench.get("b1000") == one);
        CHECK(bench.get("b4999") == zero);
    }
}
