#include <doctest/doctest.h>

#include "two_steps.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

constexpr std::string_view text = R"(
input a
graph G {
  initial 0
  step 1
  0 -> 1 : a
  1 -> 0 : 3ms/X1
}
)";

SimulateResult run(SmallNetlist& small, std::string_view stimuli, Time period) {
    const Grafcet grafcet = grafcet_of(text);
    SimulateOptions options;
    options.scan_period = period;
    return simulate(grafcet, small.netlist, cell_delays(small.netlist, {}),
                    stimuli_of(stimuli, grafcet), options);
}

}  // namespace

TEST_CASE("scan by scan: a row per clock cycle, which sees the changes up to its time") {
    SmallNetlist small = two_steps_clocked();
    CHECK(traced(run(small, "2ms : a=1\n3ms : a=0\n11ms : end\n", 2 * millisecond)) ==
          R"(time_ms,a,Init,AUdur,AUdoux,X0,X1
0,0,0,0,0,1,0
2,1,0,0,0,0,1
4,0,0,0,0,0,1
6,0,0,0,0,0,1
8,0,0,0,0,1,0
10,0,0,0,0,1,0
)");
}

TEST_CASE("until stable: a row per instant, the ends of delays included") {
    SmallNetlist small = two_steps_clocked();
    CHECK(traced(run(small, "2ms : a=1\n3ms : a=0\n11ms : end\n", 0)) ==
          R"(time_ms,a,Init,AUdur,AUdoux,X0,X1
0,0,0,0,0,1,0
2,1,0,0,0,0,1
3,0,0,0,0,0,1
5,0,0,0,0,1,0
11,0,0,0,0,1,0
)");
}

TEST_CASE("until stable takes as many clock cycles as are needed") {
    SmallNetlist small;
    small.clock("clk");
    small.input("a");
    small.netlist.has_modes = false;
    std::string before = "a";
    for (int i = 0; i < 100; ++i) {
        const std::string name = "q" + std::to_string(i);
        small.cell(CellType::flip_flop, name, {before, "clk"}, zero);
        before = name;
    }
    small.cell(CellType::inverter, "X0", {before});
    small.cell(CellType::buffer, "X1", {before});
    small.output("X0");
    small.output("X1");
    CHECK(traced(run(small, "1ms : a=1\n2ms : a=0\n", 0)) ==
          R"(time_ms,a,Init,AUdur,AUdoux,X0,X1
0,0,0,0,0,1,0
1,1,0,0,0,0,1
2,0,0,0,0,1,0
)");
}

TEST_CASE("clock cycles that come back to a state do not settle") {
    SmallNetlist small;
    small.clock("clk");
    small.input("a");
    small.netlist.has_modes = false;
    // A ring of three flip-flops behind a run-in, and one that stays.
    small.cell(CellType::inverter, "X0", {"q"});
    small.cell(CellType::xor_gate, "d", {"X1", "a"});
    small.cell(CellType::flip_flop, "p", {"d", "clk"}, zero);
    small.cell(CellType::flip_flop, "q", {"p", "clk"}, zero);
    small.cell(CellType::flip_flop, "X1", {"q", "clk"}, zero);
    small.cell(CellType::flip_flop, "calm", {"a", "clk"}, zero);
    small.output("X0");
    small.output("X1");
    const SimulateResult result = run(small, "1ms : a=1\n2ms : a=0\n", 0);
    CHECK(result.unsettled_at == Time{1} * millisecond);
    CHECK(result.trace.row_count() == 1);
    CHECK(result.oscillating == std::vector<NetId>{small.net("X0"), small.net("q"), small.net("d"),
                                                   small.net("X1"), small.net("p")});
    // Scan by scan there is nothing wrong with it.
    CHECK_FALSE(run(small, "1ms : a=1\n2ms : a=0\n", millisecond).unsettled_at.has_value());
}

TEST_CASE("flip-flops without an initial value are initialised by a cycle with Init") {
    SmallNetlist small;
    small.clock("clk");
    for (const char* name : {"a", "Init", "AUdur", "AUdoux"}) small.input(name);
    small.cell(CellType::inverter, "/Init", {"Init"});
    small.cell(CellType::and_gate, "s1", {"a", "X0"});
    small.cell(CellType::or_gate, "1", {"s1", "X1"});
    small.cell(CellType::and_gate, "d1", {"1", "/Init"});
    small.cell(CellType::inverter, "d0", {"d1"});
    small.cell(CellType::flip_flop, "X0", {"d0", "clk"});
    small.cell(CellType::flip_flop, "X1", {"d1", "clk"});
    small.output("X0");
    small.output("X1");
    CHECK(traced(run(small, "1ms : a=1\n", 0)) == R"(time_ms,a,Init,AUdur,AUdoux,X0,X1
0,0,0,0,0,1,0
1,1,0,0,0,0,1
)");
}
