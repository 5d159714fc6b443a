#include <doctest/doctest.h>

#include <memory>
#include <random>

#include "simulate/delay_ends.h"
#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

constexpr Timing five_up_two_down{5 * millisecond, 2 * millisecond, 0};

/// t is `5ms/e/2ms` of the inverse of the inverse of a.
struct TimerBench {
    SmallNetlist small;
    std::unique_ptr<Bench> bench;
    std::unique_ptr<DelayEnds> delay_ends;
    explicit TimerBench(Timing timing = five_up_two_down) {
        small.input("a");
        small.cell(CellType::inverter, "n", {"a"});
        small.cell(CellType::inverter, "e", {"n"});
        small.timed(CellType::timer, "t", {"e"}, timing, zero);
        small.cell(CellType::buffer, "y", {"t"});
        bench = std::make_unique<Bench>(small);
        delay_ends = std::make_unique<DelayEnds>(small.netlist);
        const Preparation preparation(bench->simulator);
        bench->step("a", zero);
    }
    Simulator& simulator() { return bench->simulator; }
    /// An instant at so many milliseconds at which a takes a value.
    void instant(Time at, Logic a) {
        simulator().begin_instant(at * millisecond);
        bench->set("a", a);
        delay_ends->take_effect(simulator(), at * millisecond);
        delay_ends->settle(simulator(), at * millisecond);
    }
    Logic y() { return bench->get("y"); }
    /// The end of the running delay in milliseconds, -1 for none.
    Time due() {
        CHECK(simulator().is_running(0) == (simulator().next_due() != never));
        return simulator().is_running(0) ? simulator().next_due() / millisecond : -1;
    }
};

}  // namespace

TEST_CASE("a timer's delay counts from the instant, not from when the gates had done") {
    TimerBench timer;
    CHECK(timer.due() == -1);
    CHECK(timer.simulator().timers() == std::vector<CellId>{CellId{2}});
    timer.instant(10, one);
    CHECK(timer.simulator().now() == 10 * millisecond + 2 * nanosecond);
    CHECK(timer.simulator().next_due() == 15 * millisecond);
    CHECK(timer.y() == zero);
    timer.bench->record("t");
    timer.instant(15, one);
    CHECK(timer.bench->changes.find("1@4999998") == 0);  // the very moment the delay ends
    CHECK(timer.y() == one);
    CHECK(timer.due() == -1);
    timer.instant(20, zero);
    CHECK(timer.due() == 22);
    timer.instant(21, zero);
    CHECK(timer.y() == one);
    timer.instant(22, zero);
    CHECK(timer.y() == zero);
}

TEST_CASE("the return of the operand ends a timer's delay") {
    TimerBench timer;
    timer.instant(10, one);
    timer.instant(14, zero);
    CHECK(timer.due() == -1);
    timer.instant(15, zero);
    CHECK(timer.y() == zero);
    timer.instant(16, one);
    CHECK(timer.due() == 21);
}

TEST_CASE("settling never ends a delay, end_delay always does") {
    TimerBench timer;
    timer.instant(10, one);
    timer.simulator().begin_instant(1000 * millisecond);
    timer.simulator().settle();
    CHECK(timer.y() == zero);
    CHECK(timer.due() == 15);
    timer.simulator().begin_instant(1001 * millisecond);
    timer.simulator().end_delay(0, one);
    timer.simulator().settle();
    CHECK(timer.y() == one);
    CHECK(timer.due() == -1);
    timer.simulator().end_delay(0, zero);
    timer.simulator().settle();
    CHECK(timer.y() == one);
}

TEST_CASE("a delay whose operand returns at its end does not end") {
    TimerBench timer;
    timer.instant(10, one);
    timer.instant(15, zero);
    CHECK(timer.y() == zero);
    CHECK(timer.due() == -1);
    timer.instant(20, one);
    timer.instant(25, one);
    timer.instant(30, zero);
    CHECK(timer.due() == 32);
    timer.instant(32, one);
    CHECK(timer.y() == one);
    CHECK(timer.due() == -1);
}

TEST_CASE("a delay that may or may not end leaves the output unknown") {
    TimerBench timer;
    timer.instant(10, one);
    timer.instant(15, unknown);
    CHECK(timer.y() == unknown);
}

TEST_CASE("what another timer ends with is read, memories are read as they are") {
    // outer is 1ms/(2ms/a . q), q a latch of NAND gates set by b: b = 1 at the end sets it too
    // late.
    SmallNetlist small;
    for (const char* input : {"a", "b"}) small.input(input);
    small.timed(CellType::timer, "outer", {"both"}, {millisecond, 0, 0}, zero);
    small.timed(CellType::timer, "inner", {"a"}, {2 * millisecond, 0, 0}, zero);
    small.cell(CellType::and_gate, "both", {"inner", "q"});
    small.cell(CellType::inverter, "nb", {"b"});
    small.cell(CellType::nand_gate, "q", {"nb", "nq"});
    small.cell(CellType::nand_gate, "nq", {"q", "q"});
    small.starts_at("q", false);
    Bench bench(small);
    DelayEnds delay_ends(small.netlist);
    const auto instant = [&](Time at, Logic a, Logic b) {
        bench.simulator.begin_instant(at * millisecond);
        bench.set("a", a);
        bench.set("b", b);
        delay_ends.take_effect(bench.simulator, at * millisecond);
        delay_ends.settle(bench.simulator, at * millisecond);
    };
    instant(0, one, zero);
    CHECK(bench.get("q") == zero);
    instant(2, one, one);
    CHECK(bench.get("inner") == one);
    CHECK(bench.get("q") == one);
    CHECK(bench.simulator.due(0) == 3 * millisecond);
    instant(3, zero, one);  // inner falls at once, and with it what outer waits for
    CHECK(bench.get("outer") == zero);
    CHECK(bench.simulator.due(0) == never);
}

TEST_CASE("a delay of 0 is that of a gate") {
    TimerBench timer({5 * millisecond, 0, 0});
    timer.instant(10, one);
    timer.instant(15, one);
    CHECK(timer.y() == one);
    timer.bench->record("t");
    timer.instant(16, zero);
    CHECK(timer.y() == zero);
    CHECK(timer.due() == -1);
}

TEST_CASE("an operand that is unknown puts the output in doubt when its delay ends") {
    TimerBench timer;
    timer.instant(10, unknown);
    CHECK(timer.y() == zero);
    CHECK(timer.due() == 15);
    SUBCASE("still unknown then") {
        timer.instant(15, unknown);
        CHECK(timer.y() == unknown);
        CHECK(timer.due() == -1);
        timer.instant(16, one);
        CHECK(timer.due() == 21);
        timer.instant(21, one);
        CHECK(timer.y() == one);
    }
    SUBCASE("0 in time") {
        timer.instant(14, zero);
        CHECK(timer.due() == -1);
        timer.instant(15, zero);
        CHECK(timer.y() == zero);
    }
    SUBCASE("known only later: the delay may have begun at either instant") {
        timer.instant(12, one);
        CHECK(timer.y() == unknown);
        CHECK(timer.due() == 17);
        timer.instant(17, one);
        CHECK(timer.y() == one);
    }
    SUBCASE("known at the same instant: no doubt at all") {
        timer.bench->step("a", one);
        CHECK(timer.due() == 15);
        timer.instant(15, one);
        CHECK(timer.y() == one);
    }
    SUBCASE("a certain delay that may have been broken off") {
        timer.bench->step("a", one);
        timer.instant(12, unknown);
        CHECK(timer.due() == 15);
        timer.instant(15, unknown);
        CHECK(timer.y() == unknown);
    }
}

namespace {

struct ScanTimerBench {
    SmallNetlist small;
    std::unique_ptr<Bench> bench;
    Logic next = unknown;  ///< what the look-ahead showed before the last rise of the clock
    explicit ScanTimerBench(Timing timing) {
        small.clock("clk");
        small.input("a");
        small.timed(CellType::scan_timer, "t", {"a", "clk"}, timing, zero);
        small.cell(CellType::flip_flop, "q", {"t", "clk"}, zero);
        small.timed(CellType::scan_timer_next, "next", {"a", "t", "clk"}, timing);
        bench = std::make_unique<Bench>(small);
        const Preparation preparation(bench->simulator);
        bench->set("clk", zero);
        bench->step("a", zero);
    }
    /// One scan at so many milliseconds; t and q after it.
    std::string scan(Time at, Logic a) {
        bench->simulator.begin_instant(at * millisecond);
        bench->step("a", a);
        next = bench->get("next");
        REQUIRE(bench->simulator.clock_cycle().settled);
        std::string shown;
        for (const char* net : {"t", "q"}) {
            shown += bench->get(net) == unknown ? 'x' : bench->get(net) == one ? '1' : '0';
        }
        return shown;
    }
};

}  // namespace

TEST_CASE("a clocked timer looks at its operand and its delay at the rise of the clock") {
    ScanTimerBench timer(five_up_two_down);
    CHECK(timer.scan(0, zero) == "00");
    CHECK(timer.scan(10, one) == "00");
    CHECK(timer.bench->simulator.next_due() == 15 * millisecond);
    timer.bench->step("a", zero);  // between two rises: unseen
    CHECK(timer.scan(14, one) == "00");
    CHECK(timer.scan(16, one) == "10");
    CHECK(timer.scan(17, one) == "11");
    CHECK(timer.scan(18, zero) == "11");
    CHECK(timer.scan(19, one) == "11");
    CHECK(timer.scan(20, zero) == "11");
    CHECK(timer.scan(22, zero) == "01");
    CHECK(timer.scan(23, zero) == "00");
}

TEST_CASE("a clocked timer without a delay acts at that very rise") {
    ScanTimerBench timer({0, 2 * millisecond, 0});
    CHECK(timer.scan(1, one) == "10");
    CHECK(timer.scan(2, zero) == "11");
    CHECK(timer.bench->simulator.next_due() == 4 * millisecond);
}

TEST_CASE("a clocked timer ended before the clock shows the value it was running to") {
    ScanTimerBench timer(five_up_two_down);
    CHECK(timer.scan(10, one) == "00");
    Simulator& simulator = timer.bench->simulator;
    simulator.begin_instant(15 * millisecond);
    simulator.end_delay(0, one);
    simulator.end_delay(1, one);
    timer.bench->set("a", zero);  // not seen by the timer before the next rise
    CHECK(timer.bench->get("t") == one);
    simulator.settle();
    CHECK(timer.bench->get("t") == one);
    CHECK(simulator.next_due() == never);
    simulator.clock_cycle();
    CHECK(timer.bench->get("q") == one);
    CHECK(simulator.next_due() == 17 * millisecond);
}

TEST_CASE("a clocked timer with an unknown operand") {
    ScanTimerBench timer(five_up_two_down);
    CHECK(timer.scan(10, unknown) == "00");
    CHECK(timer.scan(14, unknown) == "00");
    CHECK(timer.scan(15, unknown) == "x0");
    CHECK(timer.scan(16, zero) == "xx");
    CHECK(timer.scan(18, zero) == "0x");
}

TEST_CASE("the look-ahead of a clocked timer shows what that takes at the next rise") {
    std::minstd_rand random(11);
    std::size_t changes = 0;
    for (const Timing& timing :
         {five_up_two_down, Timing{0, 4 * millisecond, 0}, Timing{3 * millisecond, 0, 0}}) {
        for (const bool has_unknown : {false, true}) {
            ScanTimerBench timer(timing);
            Time at = 0;
            Logic shown = zero;
            for (int i = 0; i < 400; ++i) {
                at += 1 + static_cast<Time>(random() % 3);
                const auto choice = random() >> 8U & 15U;
                const bool is_unknown = has_unknown && choice == 15;
                timer.scan(at, is_unknown                               ? unknown
                               : (choice % 4 != 0) == (i / 10 % 2 != 0) ? one
                                                                        : zero);
                const Logic taken = timer.bench->get("t");
                const bool is_doubtful = timer.next == unknown || taken == unknown;
                CHECK((timer.next == taken || (has_unknown && is_doubtful)));
                if (taken != shown) ++changes;
                shown = taken;
            }
        }
    }
    CHECK(changes > 100);
}

TEST_CASE("a look-ahead knows when its timer is ended before the clock") {
    ScanTimerBench timer(five_up_two_down);
    CHECK(timer.scan(10, one) == "00");
    Simulator& simulator = timer.bench->simulator;
    CHECK(simulator.is_running(1));
    simulator.begin_instant(15 * millisecond);
    simulator.end_delay(0, one);
    simulator.end_delay(1, one);
    timer.bench->set("a", zero);
    simulator.settle();
    CHECK(timer.bench->get("next") == one);  // the fall takes a delay of its own
    CHECK(timer.scan(16, zero) == "11");
    CHECK(timer.scan(18, zero) == "01");
    CHECK(timer.next == zero);
}

TEST_CASE(
    "of timers that end together the one that another reads comes first, wherever it stands") {
    // outer is `1s/(a . /(2s/b))`, and ends just when inner puts its operand out: it does not.
    for (const bool inner_is_first : {true, false}) {
        SmallNetlist small;
        small.input("a");
        small.input("b");
        const auto add = [&](bool inner) {
            if (inner) small.timed(CellType::timer, "inner", {"b"}, {2 * second, 0, 0}, zero);
            if (!inner) small.timed(CellType::timer, "outer", {"op"}, {1 * second, 0, 1}, zero);
        };
        add(inner_is_first);
        add(!inner_is_first);
        small.cell(CellType::inverter, "not", {"inner"});
        small.cell(CellType::and_gate, "op", {"a", "not"});
        Bench bench(small);
        DelayEnds delay_ends(small.netlist);
        {
            const Preparation preparation(bench.simulator);
            bench.step("a", zero);
            bench.step("b", zero);
        }
        const auto at = [&](Time moment) {
            bench.simulator.begin_instant(moment);
            delay_ends.take_effect(bench.simulator, moment);
            CHECK(delay_ends.settle(bench.simulator, moment).settled);
        };
        bench.set("b", one);
        at(0);
        bench.set("a", one);
        at(1 * second);
        CHECK(bench.get("op") == one);
        bench.record("outer");
        at(2 * second);
        CHECK(bench.get("inner") == one);
        CHECK(bench.get("outer") == zero);
        CHECK(bench.changes.empty());
        bench.simulator.settle();
        CHECK(bench.simulator.next_due() == never);
    }
}
