#include <doctest/doctest.h>

#include <memory>

#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// Rising and falling pulses of 10 ns on input a.
struct PulseBench {
    SmallNetlist small;
    std::unique_ptr<Bench> bench;

    explicit PulseBench(Time delay = nanosecond, Time inverter_delay = nanosecond) {
        small.input("a");
        small.input("b");
        small.timed(CellType::rise_pulse, "up", {"a"}, {0, 10 * nanosecond, 0});
        small.timed(CellType::fall_pulse, "down", {"a"}, {0, 10 * nanosecond, 0});
        small.cell(CellType::inverter, "n", {"b"});
        CellDelays delays = cell_delays(small.netlist, {});
        delays.rise[0] = delay;
        delays.rise[2] = inverter_delay;
        bench = std::make_unique<Bench>(small, delays);
        const Preparation preparation(bench->simulator);
        bench->set("b", zero);
        bench->step("a", zero);
    }
    /// The changes of a net when a takes these values, each as soon as all has settled.
    std::string seen(const char* net, std::initializer_list<Logic> values) {
        bench->record(net);
        for (const Logic value : values) bench->step("a", value);
        return bench->changes;
    }
};

/// An input that changes while the pulse runs, made by an XOR of slow buffers.
struct Shaped {
    SmallNetlist small;
    /// What a pulse cell shows whose input rises 1 ns after these moments begin and toggles 1 ns
    /// after each of them, in nanoseconds.
    std::string seen(std::initializer_list<Time> toggles, CellType type = CellType::rise_pulse,
                     Logic last = zero) {
        small.input("a");
        small.input("v");
        std::vector<std::string> taps{"a"};
        std::vector<Time> buffer_delays;
        for (const Time toggle : toggles) {
            const std::string name = "t" + std::to_string(toggle);
            small.cell(CellType::buffer, name, {"a"});
            buffer_delays.push_back(toggle * nanosecond);
            taps.push_back(name);
        }
        if (last == unknown) {
            // The last toggle gives way to unknown.
            small.cell(CellType::and_gate, "doubt", {taps.back(), "v"});
            taps.back() = "doubt";
        }
        small.cell(CellType::xor_gate, "x", taps);
        small.timed(type, "p", {"x"}, {0, 10 * nanosecond, 0});
        CellDelays delays = cell_delays(small.netlist, {});
        for (std::size_t i = 0; i < buffer_delays.size(); ++i) {
            delays.rise[i] = delays.fall[i] = buffer_delays[i];
        }
        Bench bench(small, delays);
        {
            const Preparation preparation(bench.simulator);
            bench.set("v", last);
            bench.step("a", zero);
        }
        bench.record("p");
        bench.step("a", one);
        return bench.changes;
    }
};

}  // namespace

TEST_CASE("a pulse begins after the cell's delay and lasts its width") {
    CHECK(PulseBench().seen("up", {one}) == "1@1 0@11");
    CHECK(PulseBench().seen("down", {one}) == "");
    CHECK(PulseBench().seen("down", {one, zero}) == "1@12 0@22");
    CHECK(PulseBench(3 * nanosecond).seen("up", {one}) == "1@3 0@13");
    CHECK(PulseBench(3 * nanosecond, 7).seen("up", {one}) == "1@3 0@13");
}

TEST_CASE("a new edge begins the width again") {
    // x rises at 1 and 5 and falls at 3 and 7.
    CHECK(Shaped().seen({2, 4, 6}) == "1@2 0@16");
    CHECK(Shaped().seen({2, 4, 6}, CellType::fall_pulse) == "1@4 0@18");
    // Rises at 1 and 11: the second pulse begins as the first ends.
    CHECK(Shaped().seen({2, 10, 12}) == "1@2 0@22");
    CHECK(Shaped().seen({2, 11, 13}) == "1@2 0@12 1@13 0@23");
}

TEST_CASE("as long as the input is unknown there may be a pulse at any moment") {
    CHECK(PulseBench().seen("up", {unknown}) == "x@1");
    // As it becomes 1 at 2 ns it may rise once more; as it becomes 0 the last rise was before.
    CHECK(PulseBench().seen("up", {unknown, one}) == "x@1 0@13");
    CHECK(PulseBench().seen("up", {unknown, zero}) == "x@1 0@12");
    // Before it falls again it has to rise.
    CHECK(PulseBench().seen("down", {unknown}) == "x@2");
    CHECK(PulseBench().seen("down", {unknown, zero}) == "x@2 0@13");
    CHECK(PulseBench().seen("down", {one, unknown}) == "x@12");
    // Certain from the rise at 1, perhaps a second time from 6 on.
    CHECK(Shaped().seen({2, 4}, CellType::rise_pulse, unknown) == "1@2 x@12");
}

TEST_CASE("edges within the delay of a pulse cell have a pulse each") {
    SmallNetlist small;
    small.input("a");
    // x rises at 1 and 4 and falls at 2.
    for (const char* tap : {"t1", "t3"}) small.cell(CellType::buffer, tap, {"a"});
    small.cell(CellType::xor_gate, "x", {"a", "t1", "t3"});
    small.timed(CellType::rise_pulse, "p", {"x"}, {0, 2 * nanosecond, 0});
    Bench bench(small, {{1000, 3000, 1000, 7000}, {1000, 3000, 1000, 7000}});
    {
        const Preparation preparation(bench.simulator);
        bench.step("a", zero);
    }
    bench.record("p");
    bench.step("a", one);
    CHECK(bench.changes == "1@8 0@10 1@11 0@13");
}

TEST_CASE("a pulse cell at rest with an unknown input is unknown, after a restoring as well") {
    PulseBench rest;
    Simulator& simulator = rest.bench->simulator;
    SimulatorState held;
    {
        const Preparation preparation(simulator);
        rest.bench->step("a", unknown);
        // Since always as it is: no edge.
        CHECK(rest.bench->get("down") == zero);
        held = simulator.save();
    }
    rest.bench->record("down");
    CHECK(simulator.settle().settled);
    CHECK(rest.bench->changes == "x@1");
    const SimulatorState open = simulator.save();
    simulator.restore(held);
    CHECK(simulator.settle().settled);
    CHECK(rest.bench->get("down") == unknown);
    rest.bench->step("a", zero);
    CHECK(rest.bench->get("down") == zero);
    simulator.restore(open);
    CHECK(simulator.settle().events == 0);
    CHECK(rest.bench->get("down") == unknown);
    rest.bench->record("down");
    SUBCASE("closed while pulses fire") {
        rest.bench->step("a", zero);
        CHECK(rest.bench->changes == "0@11");
    }
    SUBCASE("closed while they are held") {
        const Preparation preparation(simulator);
        rest.bench->step("a", zero);
        CHECK(rest.bench->changes == "0@1");
    }
}

TEST_CASE("held pulses do not fire, and compare with what they see when they are let go") {
    PulseBench held;
    {
        const Preparation preparation(held.bench->simulator);
        CHECK(held.seen("up", {one, zero, unknown, one}) == "");
    }
    CHECK(held.seen("up", {one}) == "");
    CHECK(held.seen("down", {zero}) == "1@1 0@11");
}

TEST_CASE("what a pulse cell is told to remember outlives the time it is held") {
    PulseBench held;
    Simulator& simulator = held.bench->simulator;
    {
        Preparation preparation(simulator);
        preparation.power_up_again();
        held.bench->step("b", zero);
        held.bench->step("a", one);
    }
    held.bench->record("up");
    // Remembered was 0: the fall back to it is no edge, nor was the rise while held.
    held.bench->step("a", zero);
    CHECK(held.bench->changes == "");
    CHECK(held.bench->get("down") == zero);
    CHECK(held.seen("up", {one}) == "1@1 0@11");
}

TEST_CASE("powering up is no edge: there is no pulse, and nothing that one would set is set") {
    for (const CellType type : {CellType::rise_pulse, CellType::fall_pulse}) {
        for (const Logic value : {zero, one}) {
            SmallNetlist small;
            small.input("a");
            small.timed(type, "p", {"a"}, {0, 10 * nanosecond, 0});
            small.cell(CellType::low, "never", {});
            small.cell(CellType::latch, "q", {"p", "never"});
            Bench bench(small);
            bench.record("p");
            {
                const Preparation preparation(bench.simulator);
                bench.step("a", value);
            }
            bench.simulator.settle();
            CHECK(bench.get("p") == zero);
            CHECK(bench.get("q") == unknown);
            CHECK(bench.changes.empty());
        }
    }
}
