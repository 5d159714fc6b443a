#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

#include "support/small_netlist.h"
#include "two_steps.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// x and y follow a, y through x.
struct TwoBuffers {
    SmallNetlist small;
    CellId x;
    CellId y;
    TwoBuffers() {
        small.input("a");
        x = small.cell(CellType::buffer, "x", {"a"});
        y = small.cell(CellType::buffer, "y", {"x"});
    }
    /// What y does where a rises at 10 ns and falls at 30 ns.
    std::string seen(const DelaySchedule& schedule) {
        Bench bench(small, cell_delays(small.netlist, {}), schedule);
        bench.step("a", zero);
        bench.at(10);
        bench.record("y");
        bench.step("a", one);
        bench.at(30);
        bench.step("a", zero);
        return bench.changes;
    }
};

}  // namespace

TEST_CASE("delays of a schedule hold from their moment on") {
    TwoBuffers two;
    CHECK(two.seen({}) == "1@2 0@22");
    CHECK(two.seen({{{0, two.x, 3000, 5000}}}) == "1@4 0@26");
    CHECK(two.seen({{{-7, two.x, 3000, 5000}}}) == "1@4 0@26");
    CHECK(two.seen({{{0, two.x, 3000, 5000}, {20'000, two.y, 1, 2}}}) == "1@4 0@25.2");
    // At the beginning of the instant of the rise, and just after it.
    CHECK(two.seen({{{10'000, two.x, 3000, 5000}}}) == "1@4 0@26");
    CHECK(two.seen({{{10'001, two.x, 3000, 5000}}}) == "1@2 0@26");
    CHECK(two.seen({{{10'000, two.x, 3000, 5000}, {10'000, two.x, 4000, 6000}}}) == "1@5 0@27");
    // Within the instant: x rises at 11 ns, and y is evaluated at that time.
    CHECK(two.seen({{{11'000, two.y, 7000, 1000}}}) == "1@8 0@22");
    CHECK(two.seen({{{11'001, two.y, 7000, 1000}}}) == "1@2 0@22");
    CHECK(two.seen({{{11'000, two.y, 7000, 1000}, {30'500, two.y, 8000, 4000}}}) == "1@8 0@25");
}

TEST_CASE("a change that is under way keeps its delay") {
    TwoBuffers two;
    const DelaySchedule schedule{{{0, two.x, 9000, 9000}, {12'000, two.x, 1000, 2000}}};
    CHECK(two.seen(schedule) == "1@10 0@23");
}

TEST_CASE("a schedule has delays from a picosecond to seconds") {
    TwoBuffers two;
    const Time long_delay = 3 * second;
    CHECK(two.seen({{{0, two.x, 1, 1}, {0, two.y, 1, 1}}}) == "1@0.2 0@20.2");
    CHECK(two.seen({{{0, two.x, 1, 1}, {10'001, two.y, long_delay, 1}}}) ==
          "1@3000000000.1 0@3000000000.3");
}

TEST_CASE("a state that is put back brings the delays of its moment along") {
    TwoBuffers two;
    Bench bench(two.small, cell_delays(two.small.netlist, {}),
                {{{20'000, two.x, 5000, 5000}, {40'000, two.x, 7000, 7000}}});
    bench.step("a", zero);
    bench.at(10);
    const SimulatorState early = bench.simulator.save();
    bench.at(20);
    const SimulatorState late = bench.simulator.save();
    bench.at(50);
    bench.record("y");
    bench.step("a", one);
    CHECK(bench.changes == "1@8");
    bench.simulator.restore(late);
    bench.record("y");
    bench.step("a", one);
    CHECK(bench.changes == "1@6");
    bench.simulator.restore(early);
    bench.record("y");
    bench.step("a", one);
    CHECK(bench.changes == "1@2");
    bench.simulator.power_up();
    bench.record("y");
    bench.step("a", one);
    CHECK(bench.changes == "1@2");
}

TEST_CASE("before the first instant only the delays of the start hold") {
    TwoBuffers two;
    Bench bench(two.small, cell_delays(two.small.netlist, {}),
                {{{0, two.x, 2000, 2000}, {1, two.y, 5000, 5000}}});
    bench.record("y");
    {
        const Preparation preparation(bench.simulator);
        bench.step("a", one);
        CHECK(bench.changes == "1@3");
        bench.step("a", zero);
        CHECK(bench.changes == "1@3 0@6");
    }
    bench.record("y");
    bench.step("a", one);
    CHECK(bench.changes == "1@7");
}

TEST_CASE("pulses take their delay and their width from a schedule") {
    SmallNetlist small;
    small.input("a");
    const CellId p = small.timed(CellType::rise_pulse, "p", {"a"}, {0, 4000, 0});
    const auto seen = [&](const DelaySchedule& schedule) {
        Bench bench(small, cell_delays(small.netlist, {}), schedule);
        {
            const Preparation preparation(bench.simulator);
            bench.step("a", zero);
        }
        bench.record("p");
        bench.step("a", one);
        bench.at(20);
        bench.step("a", zero);
        bench.step("a", one);
        return bench.changes;
    };
    CHECK(seen({}) == "1@1 0@5 1@21 0@25");
    CHECK(seen({{{0, p, 2500, 1}}}) == "1@2.500 0@6.500 1@22.500 0@26.500");
    CHECK(seen({{{0, p, 2000, 1, 6000}}}) == "1@2 0@8 1@22 0@28");
    CHECK(seen({{{10'000, p, 2000, 1, 700}}}) == "1@1 0@5 1@22 0@22.700");
    CHECK(seen({{{10'000, p, 2000, 1}}}) == "1@1 0@5 1@22 0@26");
}

TEST_CASE("a pulse whose delay has become shorter comes before those that are under way") {
    SmallNetlist small;
    small.input("a");
    // An edge at 0 ns, one at 4 ns.
    small.cell(CellType::buffer, "b1", {"a"});
    small.cell(CellType::buffer, "b2", {"a"});
    small.cell(CellType::xor_gate, "x", {"a", "b1", "b2"});
    const CellId p = small.timed(CellType::rise_pulse, "p", {"x"}, {0, 2000, 0});
    const auto seen = [&](Time later_delay) {
        Bench bench(small, {{1000, 3000, 1000, 20'000}, {1000, 3000, 1000, 20'000}},
                    {{{2000, p, later_delay, 1}}});
        {
            const Preparation preparation(bench.simulator);
            bench.step("a", zero);
        }
        bench.record("p");
        bench.step("a", one);
        return bench.changes;
    };
    // x rises at 1 ns and at 4 ns.
    CHECK(seen(20'000) == "1@21 0@23 1@24 0@26");
    CHECK(seen(1000) == "1@5 0@7 1@21 0@23");
    CHECK(seen(16'000) == "1@20 0@23");
    CHECK(seen(17'000) == "1@21 0@23");
}

TEST_CASE("a netlist does not settle only under delays that stay") {
    SmallNetlist small;
    small.input("a");
    const CellId q = small.cell(CellType::nor_gate, "q", {"a", "r"});
    small.cell(CellType::nor_gate, "r", {"a", "q"});
    const auto settling = [&](const DelaySchedule& schedule) {
        Bench bench(small, cell_delays(small.netlist, {}), schedule);
        bench.step("a", one);
        bench.set("a", zero);
        return bench.simulator.settle();
    };
    CHECK_FALSE(settling({}).settled);
    CHECK_FALSE(settling({{{0, q, 1000, 1000}}}).settled);
    CHECK(settling({{{0, q, 2000, 2000}}}).settled);
    CHECK(settling({{{1'000'000, q, 2000, 2000}}}).settled);
    const Settling other = settling({{{1'000'000, q, 1000, 1000}}});
    CHECK_FALSE(other.settled);
    CHECK(other.oscillating == std::vector<NetId>{small.net("q"), small.net("r")});
    // The hour is over long after the netlist has been given up.
    CHECK_FALSE(settling({{{hour, q, 2000, 2000}}}).settled);
}

TEST_CASE("a run plays a schedule") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(true);
    const Stimuli stimuli = stimuli_of("0ms : a=0\n1ms : a=1\n10ms : end\n", grafcet);
    SimulateOptions options;
    options.waveform = true;
    const auto run = [&](const CellDelays& delays) {
        return simulate(grafcet, small.netlist, delays, stimuli, options);
    };
    const CellDelays unit = cell_delays(small.netlist, {});
    CellDelays random = unit;
    std::mt19937 source(5);
    for (std::size_t i = 0; i < random.rise.size(); ++i) {
        random.rise[i] = static_cast<Time>(1 + source() % 5000);
        random.fall[i] = static_cast<Time>(1 + source() % 5000);
    }
    const SimulateResult wanted = run(random);
    for (std::size_t i = 0; i < random.rise.size(); ++i) {
        options.schedule.changes.push_back(
            {0, small.netlist.cells.id_at(i), random.rise[i], random.fall[i]});
    }
    const SimulateResult played = run(unit);
    CHECK(traced(played) == traced(wanted));
    CHECK(played.waveform.vcd == wanted.waveform.vcd);
    CHECK(played.waveform.vcd.find("1 ps") != std::string::npos);
    CHECK(played.events == wanted.events);
}

// Random netlists under random schedules, against a simulation that looks at every cell at every
// nanosecond.

namespace {

SmallNetlist random_gates(std::mt19937& random) {
    constexpr CellType types[] = {CellType::buffer,    CellType::inverter, CellType::and_gate,
                                  CellType::nand_gate, CellType::or_gate,  CellType::xor_gate};
    SmallNetlist small;
    std::vector<std::string> nets{"a", "b"};
    for (const std::string& input : nets) small.input(input);
    const std::size_t cells = 3 + random() % 12;
    for (std::size_t i = 0; i < cells; ++i) {
        const CellType type = types[random() % std::size(types)];
        std::vector<std::string> pins;
        const std::size_t count = row_of(type).max_pins == 1 ? 1 : 2 + random() % 2;
        while (pins.size() < count) pins.push_back(nets[random() % nets.size()]);
        nets.push_back("g" + std::to_string(i));
        small.cell(type, nets.back(), pins);
    }
    return small;
}

DelaySchedule random_schedule(std::mt19937& random, std::size_t cells) {
    DelaySchedule schedule;
    const std::size_t count = 1 + random() % 30;
    for (std::size_t i = 0; i < count; ++i) {
        DelayChange change;
        change.at = static_cast<Time>(random() % 300) * nanosecond;
        change.cell = static_cast<CellId>(random() % cells);
        change.rise = static_cast<Time>(1 + random() % 9) * nanosecond;
        change.fall = static_cast<Time>(1 + random() % 9) * nanosecond;
        schedule.changes.push_back(change);
    }
    std::stable_sort(schedule.changes.begin(), schedule.changes.end(),
                     [](const DelayChange& a, const DelayChange& b) { return a.at < b.at; });
    return schedule;
}

bool gate_output(const Netlist& netlist, const Cell& cell, const std::vector<bool>& values) {
    std::size_t ones = 0;
    for (const NetId pin : netlist.pins_of(cell)) ones += values[index_of(pin)] ? 1 : 0;
    switch (cell.type) {
        case CellType::inverter:
            return ones == 0;
        case CellType::and_gate:
            return ones == cell.pin_count;
        case CellType::nand_gate:
            return ones < cell.pin_count;
        case CellType::xor_gate:
            return ones % 2 == 1;
        default:
            return ones > 0;
    }
}

/// What every net is from one nanosecond to the next.
using History = std::vector<std::vector<bool>>;

/// From rest; `toggles`: the inputs that change at a moment.
History plain_history(const Netlist& netlist, const DelaySchedule& schedule,
                      std::vector<bool> values, const std::map<Time, NetId>& toggles, Time end) {
    History history;
    CellDelays delays = cell_delays(netlist, {});
    std::vector<Time> due(netlist.cells.size(), never);
    for (Time at = 0; at < end; at += nanosecond) {
        for (const DelayChange& change : schedule.changes) {
            if (change.at != at) continue;
            delays.rise[index_of(change.cell)] = change.rise;
            delays.fall[index_of(change.cell)] = change.fall;
        }
        if (toggles.contains(at)) values[index_of(toggles.at(at))].flip();
        for (std::size_t i = 0; i < due.size(); ++i) {
            if (due[i] != at) continue;
            values[index_of(netlist.cells[netlist.cells.id_at(i)].output)].flip();
            due[i] = never;
        }
        for (std::size_t i = 0; i < due.size(); ++i) {
            const Cell& cell = netlist.cells[netlist.cells.id_at(i)];
            const bool target = gate_output(netlist, cell, values);
            if (target == values[index_of(cell.output)]) {
                due[i] = never;
            } else if (due[i] == never) {
                due[i] = at + (target ? delays.rise : delays.fall)[i];
            }
        }
        history.push_back(values);
    }
    return history;
}

}  // namespace

TEST_CASE("random netlists under random schedules do what their definition says") {
    std::mt19937 random(1207);
    std::size_t flips = 0;
    for (int round = 0; round < 400; ++round) {
        CAPTURE(round);
        SmallNetlist small = random_gates(random);
        const Netlist& netlist = small.netlist;
        const DelaySchedule schedule = random_schedule(random, netlist.cells.size());
        Simulator simulator(netlist, cell_delays(netlist, {}), schedule);
        {
            const Preparation preparation(simulator);
            for (const Port& input : netlist.inputs) simulator.set_input(input.net, zero);
            simulator.settle();
        }
        std::vector<bool> values;
        for (std::size_t net = 0; net < netlist.net_count(); ++net) {
            values.push_back(simulator.value(static_cast<NetId>(net)) == one);
        }
        // Far enough apart for the gates to have settled.
        constexpr Time apart = 150 * nanosecond;
        const Time end = 3 * apart;
        const std::map<Time, NetId> toggles{
            {0, small.net("a")}, {apart, small.net("b")}, {2 * apart, small.net("a")}};
        const History wanted = plain_history(netlist, schedule, values, toggles, end);

        History seen(wanted.size(), values);
        simulator.observe([&](Time at, NetId net, Logic value) {
            ++flips;
            for (auto moment = static_cast<std::size_t>(at / nanosecond); moment < seen.size();
                 ++moment) {
                seen[moment][index_of(net)] = value == one;
            }
        });
        for (const auto& [at, input] : toggles) {
            simulator.begin_instant(at);
            simulator.set_input(input, ~simulator.value(input));
            REQUIRE(simulator.settle().settled);
        }
        REQUIRE(seen == wanted);
    }
    CHECK(flips > 5000);
}
