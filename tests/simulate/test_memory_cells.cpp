#include <doctest/doctest.h>

#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// The row of a truth table: what a cell shows with its pins at a and b, having held `held`.
Logic shown(CellType type, Logic a, Logic b, Logic held) {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    small.cell(type, "q", {"a", "b"}, held);
    Bench bench(small);
    bench.simulator.power_up();
    bench.set("a", a);
    bench.set("b", b);
    REQUIRE(bench.simulator.settle().settled);
    return bench.get("q");
}

std::string row(CellType type, Logic held) {
    std::string text;
    for (const Logic a : all_values) {
        for (const Logic b : all_values) {
            const Logic value = shown(type, a, b, held);
            text += value == unknown ? 'x' : value == one ? '1' : '0';
        }
        text += ' ';
    }
    text.pop_back();
    return text;
}

}  // namespace

// Rows: set or data = 0, 1, x; within each, reset or enable = 0, 1, x.

TEST_CASE("truth table of the latch: set wins") {
    CHECK(row(CellType::latch, zero) == "000 111 xxx");
    CHECK(row(CellType::latch, one) == "10x 111 1xx");
    CHECK(row(CellType::latch, unknown) == "x0x 111 xxx");
}

TEST_CASE("truth table of the hold latch") {
    CHECK(row(CellType::hold_latch, zero) == "000 01x 0xx");
    CHECK(row(CellType::hold_latch, one) == "10x 111 1xx");
    CHECK(row(CellType::hold_latch, unknown) == "x0x x1x xxx");
}

TEST_CASE("the latch holds over time") {
    SmallNetlist small;
    small.input("s");
    small.input("r");
    small.cell(CellType::latch, "q", {"s", "r"}, zero);
    Bench bench(small);
    bench.set("r", zero);
    bench.step("s", zero);
    bench.simulator.power_up();
    bench.set("r", zero);
    bench.step("s", one);
    CHECK(bench.get("q") == one);
    bench.step("s", zero);
    CHECK(bench.get("q") == one);
    bench.step("r", one);
    CHECK(bench.get("q") == zero);
    bench.step("s", one);
    CHECK(bench.get("q") == one);
    bench.step("s", zero);
    CHECK(bench.get("q") == zero);
}

TEST_CASE("the flip-flop takes its data at the rise of the clock, and in doubt nothing is known") {
    // What a flip-flop holding `held` shows with data d when its clock goes from one value to
    // another.
    const auto taken = [](Logic d, Logic from, Logic to, Logic held) {
        SmallNetlist small;
        small.input("d");
        small.input("c");
        small.cell(CellType::flip_flop, "q", {"d", "c"}, held);
        Bench bench(small);
        bench.simulator.power_up();
        bench.set("d", d);
        bench.set("c", from);
        bench.simulator.settle();
        // From power-up on the clock was unknown: it may have risen.
        {
            Preparation preparation(bench.simulator);
            preparation.hold(small.net("q"), held);
            bench.simulator.settle();
        }
        bench.simulator.settle();
        bench.step("c", to);
        return bench.get("q");
    };
    for (const Logic d : all_values) {
        for (const Logic held : all_values) {
            const Logic doubtful = d == held ? held : unknown;
            CHECK(taken(d, zero, one, held) == d);
            CHECK(taken(d, one, zero, held) == held);
            // While it is unknown, the clock may fall and rise as often as it likes.
            CHECK(taken(d, zero, unknown, held) == doubtful);
            CHECK(taken(d, unknown, one, held) == doubtful);
            CHECK(taken(d, one, unknown, held) == doubtful);
            CHECK(taken(d, unknown, zero, held) == doubtful);
        }
    }
}

TEST_CASE("data that changes at the moment of the clock's rise comes too late") {
    SmallNetlist small;
    small.input("d");
    small.input("c");
    small.cell(CellType::flip_flop, "q", {"d", "c"}, zero);
    small.cell(CellType::flip_flop, "self", {"c", "c"}, one);
    for (const bool data_first : {true, false}) {
        Bench bench(small);
        bench.set("c", zero);
        bench.step("d", one);
        bench.set(data_first ? "d" : "c", data_first ? zero : one);
        bench.set(data_first ? "c" : "d", data_first ? one : zero);
        bench.simulator.settle();
        CHECK(bench.get("q") == one);
        CHECK(bench.get("self") == zero);
    }
}

TEST_CASE("a shift register moves one place per clock cycle") {
    SmallNetlist small;
    small.clock("clk");
    small.input("d");
    small.cell(CellType::flip_flop, "q1", {"d", "clk"}, zero);
    small.cell(CellType::flip_flop, "q2", {"q1", "clk"}, one);
    small.cell(CellType::flip_flop, "q3", {"q2", "clk"}, zero);
    Bench bench(small);
    bench.set("clk", zero);
    bench.step("d", one);
    std::string seen;
    for (int cycle = 0; cycle < 5; ++cycle) {
        for (const char* q : {"q1", "q2", "q3"}) seen += bench.get(q) == one ? '1' : '0';
        seen += ' ';
        CHECK(bench.simulator.clock_cycle().settled);
        bench.set("d", zero);
    }
    CHECK(seen == "010 101 010 001 000 ");
    CHECK(bench.get("clk") == zero);
}

TEST_CASE("a clock cycle settles the inputs first") {
    SmallNetlist small;
    small.clock("clk");
    small.input("a");
    small.cell(CellType::inverter, "n", {"a"});
    small.cell(CellType::inverter, "m", {"n"});
    small.cell(CellType::flip_flop, "q", {"m", "clk"}, zero);
    Bench bench(small);
    bench.set("clk", zero);
    bench.step("a", zero);
    bench.set("a", one);
    bench.record("clk");
    const Settling cycle = bench.simulator.clock_cycle();
    CHECK(bench.get("q") == one);
    CHECK(bench.changes == "1@3 0@5");
    CHECK(cycle.events == 6);  // a, n, m, clk twice, q
}
