#include <doctest/doctest.h>

#include "text/version.h"
#include "two_steps.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

SimulateResult run(SmallNetlist& small, const Grafcet& grafcet, std::string_view stimuli,
                   const SimulateOptions& options = {}) {
    return simulate(grafcet, small.netlist, cell_delays(small.netlist, {}),
                    stimuli_of(stimuli, grafcet), options);
}

constexpr std::string_view stimuli_text = R"(
0ms   : a=0
1ms   : a=1
2ms   : a=0 AUdoux=1
10ms  : a=1
11ms  : a=0 b=1
12ms  : b=0
20ms  : end
)";

}  // namespace

TEST_CASE("ports are found by their names") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(false);
    const PortMap ports = map_ports(grafcet, small.netlist);
    CHECK(ports.inputs ==
          std::vector<NetId>{small.net("a"), small.net("b"), no_net, no_net, no_net});
    CHECK(ports.steps == std::vector<NetId>{small.net("X0"), small.net("X1")});
    CHECK(ports.outputs == std::vector<NetId>{small.net("V")});
    small.netlist.outputs.erase(small.netlist.outputs.begin());
    CHECK(map_ports(grafcet, small.netlist).steps == std::vector<NetId>{no_net, small.net("X1")});
}

TEST_CASE("a chart of two steps, one row per instant, ends of delays included") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(true);
    const SimulateResult result = run(small, grafcet, stimuli_text);
    CHECK_FALSE(result.unsettled_at.has_value());
    CHECK(result.oscillating.empty());
    CHECK(result.events > 20);
    CHECK(result.waveform.vcd.empty());
    CHECK(traced(result) == R"(time_ms,a,b,Init,AUdur,AUdoux,X0,X1,V,k,c
0,0,0,0,0,0,1,0,0,0,-2
1,1,0,0,0,0,0,1,1,1,1
2,0,0,0,0,1,0,1,0,1,1
4,0,0,0,0,1,1,0,0,1,0
10,1,0,0,0,1,0,1,0,1,1
11,0,1,0,0,1,1,0,0,1,0
12,0,0,0,0,1,1,0,0,1,0
20,0,0,0,0,1,1,0,0,1,0
)");
}

TEST_CASE("without modes the steps start at the initial situation") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(false);
    // a is 1 since always, and so is no edge; the transition is cleared at the first instant.
    const SimulateResult result = run(small, grafcet, "0ms : a=1\n4ms : a=0 Init=1\n");
    CHECK(traced(result) == R"(time_ms,a,b,Init,AUdur,AUdoux,X0,X1,V,k,c
0,1,0,0,0,0,0,1,1,1,1
3,1,0,0,0,0,0,1,1,1,1
4,0,0,1,0,0,0,1,1,1,1
)");
}

TEST_CASE("what the netlist lacks or does not know is unknown") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(true);
    small.netlist.outputs.erase(small.netlist.outputs.begin());
    small.netlist.vars.clear();
    small.input("elsewhere");
    small.netlist.counters[0].bits.push_back(small.net("elsewhere"));
    CHECK(traced(run(small, grafcet, "1ms : a=1\n")) == R"(time_ms,a,b,Init,AUdur,AUdoux,X0,X1,V,k,c
0,0,0,0,0,0,x,0,0,x,x
1,1,0,0,0,0,x,1,1,x,x
)");
}

TEST_CASE("the first instant that does not settle ends the run") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(true);
    small.cell(CellType::nand_gate, "ring", {"b", "ring"});
    const SimulateResult result = run(small, grafcet, "1ms : a=1\n2ms : a=0 b=1\n3ms : b=0\n");
    REQUIRE(result.unsettled_at.has_value());
    CHECK(*result.unsettled_at == 2 * millisecond);
    CHECK(result.oscillating == std::vector<NetId>{small.net("ring")});
    CHECK(result.trace.row_count() == 2);
}

TEST_CASE("a netlist that does not settle at the start has no row at all") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(true);
    small.cell(CellType::nand_gate, "ring", {"Init", "ring"});
    small.starts_at("ring", true);
    const SimulateResult result = run(small, grafcet, "1ms : a=1\n");
    CHECK(result.unsettled_at == Time{0});
    CHECK(result.oscillating == std::vector<NetId>{small.net("ring")});
    CHECK(result.trace.row_count() == 0);
}

TEST_CASE("edges of the control inputs see no change in the first instant") {
    const Grafcet grafcet = grafcet_of(two_steps_text);
    SmallNetlist small = two_steps_netlist(true);
    small.timed(CellType::fall_pulse, "p1", {"Init"}, {0, 5 * nanosecond, 0});
    small.timed(CellType::rise_pulse, "p2", {"AUdur"}, {0, 5 * nanosecond, 0});
    small.cell(CellType::latch, "m1", {"p1", "never"}, zero);
    small.cell(CellType::latch, "m2", {"p2", "never"}, zero);
    small.netlist.counters[0] = {"c", {small.net("m1"), small.net("m2")}, 0};
    const auto row_of_c = [&](std::string_view stimuli) {
        std::string text;
        const SimulateResult result = run(small, grafcet, stimuli);
        const std::size_t columns = result.trace.columns.size();
        for (std::size_t row = 0; row < result.trace.row_count(); ++row) {
            text += std::to_string(result.trace.values[row * columns + columns - 1]);
        }
        return text;
    };
    CHECK(row_of_c("0ms : AUdur=1\n1ms : AUdur=0\n2ms : AUdur=1\n") == "002");
    CHECK(row_of_c("0ms : Init=1\n1ms : Init=0\n") == "01");
    CHECK(row_of_c("1ms : Init=1\n2ms : Init=0\n") == "001");
}

TEST_CASE("the waveform shows every net, from instant 0 on") {
    const Grafcet grafcet = grafcet_of("input a\noutput V\ngraph G { initial 0 : V if a }\n");
    SmallNetlist small;
    small.netlist.name = "one";
    small.netlist.has_modes = false;
    small.input("a");
    small.cell(CellType::latch, "X0", {"low", "low"}, one);
    small.cell(CellType::low, "low", {});
    small.cell(CellType::and_gate, "V", {"X0", "a"});
    small.output("X0");
    small.output("V");
    SimulateOptions options;
    options.waveform = true;
    CHECK(run(small, grafcet, "1us : a=1\n2us : a=0\n3us : end\n", options).waveform.vcd ==
          "$version " + program_and_version() + R"( $end
$timescale 1 ns $end
$scope module one $end
$var wire 1 ! a $end
$var wire 1 " X0 $end
$var wire 1 # low $end
$var wire 1 $ V $end
$upscope $end
$enddefinitions $end
#0
0!
1"
0#
0$
#1000
1!
#1001
1$
#2000
0!
#2001
0$
#3000
)");
    // A moment that is no whole nanosecond.
    const SimulateResult fine =
        simulate(grafcet, small.netlist, CellDelays{{1, 1, 1500}, {1, 1, 1500}},
                 stimuli_of("1us : a=1\n", grafcet), options);
    CHECK(fine.waveform.vcd.find("$timescale 1 ps $end") != std::string::npos);
    CHECK(fine.waveform.vcd.find("#1000000\n1!\n#1001500\n1$\n") != std::string::npos);
}

TEST_CASE("one time of half a nanosecond is enough for a waveform in picoseconds") {
    const Grafcet grafcet = grafcet_of("input a\ngraph G { initial 0 }\n");
    const auto timescale = [&](Time rise, Time fall, Time width, Time on_delay,
                               std::string_view stimuli) {
        SmallNetlist small;
        small.netlist.has_modes = false;
        small.input("a");
        small.cell(CellType::high, "X0", {});
        small.timed(CellType::rise_pulse, "p", {"a"}, {0, width, 0});
        small.timed(CellType::timer, "t", {"a"}, {on_delay, 0, 0}, zero);
        small.output("X0");
        SimulateOptions options;
        options.waveform = true;
        const CellDelays delays{{1000, rise, 1000}, {1000, fall, 1000}};
        const std::string vcd =
            simulate(grafcet, small.netlist, delays, stimuli_of(stimuli, grafcet), options)
                .waveform.vcd;
        const std::size_t from = vcd.find("$timescale ") + 11;
        return vcd.substr(from, vcd.find(" $end", from) - from);
    };
    CHECK(timescale(1000, 2000, 3000, 4000, "1us : a=1\n") == "1 ns");
    CHECK(timescale(1500, 2000, 3000, 4000, "1us : a=1\n") == "1 ps");
    CHECK(timescale(1000, 1500, 3000, 4000, "1us : a=1\n") == "1 ps");
    CHECK(timescale(1000, 2000, 1500, 4000, "1us : a=1\n") == "1 ps");
    CHECK(timescale(1000, 2000, 3000, 1500, "1us : a=1\n") == "1 ps");
    CHECK(timescale(1000, 2000, 3000, 4000, "0.0015us : a=1\n1us : end\n") == "1 ps");
    CHECK(timescale(1000, 2000, 3000, 4000, "1us : a=1\n1.0005us : end\n") == "1 ps");
}
