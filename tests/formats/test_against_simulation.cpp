// The Verilog and SPICE that are written do in Icarus Verilog and ngspice what the netlist does in
// the product's own simulation, at every instant of the examples' stimuli.

#include <doctest/doctest.h>

#include <iterator>
#include <random>
#include <sstream>

#include "equations/equations.h"
#include "evolution/run.h"
#include "formats/verilog/write_verilog.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/styles/styles.h"
#include "simulate/simulate.h"
#include "support/files.h"
#include "support/tool_runner.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

Grafcet parsed(const std::string& name, const std::string& text) {
    Diagnostics diagnostics;
    std::optional<Grafcet> grafcet = parse_grafcet({name, text}, diagnostics);
    REQUIRE(grafcet.has_value());
    return std::move(*grafcet);
}

Netlist clocked_netlist(const Grafcet& grafcet) {
    Diagnostics diagnostics;
    const Equations equations = equations_from(grafcet, {CdxForm::transition, true});
    std::optional<Netlist> netlist = netlist_from(grafcet, equations, Style::clocked, diagnostics);
    REQUIRE(netlist.has_value());
    return std::move(*netlist);
}

/// Time conditions within others, with on- and off-delays.
Grafcet nested_times() {
    return parsed("nested", R"(
grafcet nested
input a, b
output busy, late
graph G1 {
  initial 0 : late if /20ms/(15ms/(a + X2)/35ms)/10ms
  step 1    : busy
  step 2    : late if 20ms/(15ms/(a + X2)/35ms)/10ms

  (0) 0 -> 1 : 30ms/(20ms/a/40ms + b)/10ms
  (1) 1 -> 2 : 25ms/(/(10ms/(5ms/(X1 . /b))/20ms))
  (2) 2 -> 0 : 10ms/(0ms/(20ms/a)/30ms)/5ms + 200ms/X2
}
)");
}

/// Both inputs change at random, at moments of which many are those of scans.
Stimuli restless_inputs() {
    Stimuli stimuli;
    std::minstd_rand random(7);
    constexpr Time pauses[] = {5, 10, 15, 20, 30, 45, 60, 100, 200};
    for (int i = 0; i < 60; ++i) {
        stimuli.end += pauses[random() % std::size(pauses)] * millisecond;
        const bool a = (random() >> 10U & 1U) != 0;
        const bool b = (random() >> 10U & 1U) != 0;
        stimuli.changes.push_back({stimuli.end, {{0, a}, {1, b}}, {}});
    }
    return stimuli;
}

/// The columns of a trace that are outputs of the netlist, as the test bench prints them.
std::string outputs_of(const Trace& trace, const Grafcet& grafcet, const Netlist& netlist) {
    const std::size_t first = grafcet.all_input_count();
    std::string text = "time_ms";
    for (const Port& port : netlist.outputs) text += ',' + port.name;
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        text += '\n' + format_milliseconds(trace.times[row]);
        for (std::size_t i = 0; i < netlist.outputs.size(); ++i) {
            const std::int64_t value = trace.values[row * trace.columns.size() + first + i];
            text += value == Trace::unknown ? ",x" : value == 1 ? ",1" : ",0";
        }
    }
    return text + '\n';
}

std::string in_icarus(const Netlist& netlist, const Bench& bench, Time scan,
                      const std::string& verilog) {
    ToolRunner tools;
    tools.write("netlist.v", verilog);
    tools.write("bench.v", write_verilog_bench(netlist, bench, scan));
    REQUIRE(tools.run("iverilog -o run bench.v netlist.v").status == 0);
    const auto result = tools.run("vvp -n run");
    CHECK(result.status == 0);
    return result.output;
}

std::string in_icarus(const Netlist& netlist, const Bench& bench, Time scan) {
    return in_icarus(netlist, bench, scan, write_verilog(netlist));
}

/// From 1 ps to 60 ns, for every gate; so hardly two changes fall on one moment, at which Icarus
/// has an order of its own.
DelaySchedule random_delays(const Netlist& netlist, std::mt19937& random) {
    DelaySchedule schedule;
    constexpr unsigned slowest[] = {500, 5'000, 60'000};
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const unsigned most = slowest[random() % std::size(slowest)];
        const auto rise = static_cast<Time>(1 + random() % most);
        const auto fall = static_cast<Time>(1 + random() % most);
        schedule.changes.push_back({0, netlist.cells.id_at(i), rise, fall});
    }
    return schedule;
}

/// The Verilog of a netlist of gates alone, each with its own delays.
std::string verilog_with(const Netlist& netlist, const DelaySchedule& schedule) {
    std::string text = write_verilog(netlist);
    for (const DelayChange& change : schedule.changes) {
        const NetId net = netlist.cells[change.cell].output;
        const std::string delay = "#GATE_NS ";
        const std::string instance = std::string(netlist.names[net]) + "$g (";
        const std::size_t at = text.find(delay + instance);
        REQUIRE(at != std::string::npos);
        text.replace(
            at, delay.size(),
            "#(" + format_nanoseconds(change.rise) + ", " + format_nanoseconds(change.fall) + ") ");
    }
    return text;
}

}  // namespace

TEST_CASE("examples in Icarus Verilog") {
    for (const std::string name :
         {"manipulator", "manipulator-modes", "positioning-axis", "nine-steps"}) {
        CAPTURE(name);
        Diagnostics diagnostics;
        const Grafcet grafcet = parsed(name, example_text(name + ".grafcet"));
        const std::optional<Stimuli> stimuli =
            parse_stimuli({name, example_text(name + ".stim")}, grafcet, diagnostics);
        REQUIRE(stimuli.has_value());
        for (const bool modes : {true, false}) {
            CAPTURE(modes);
            const Equations equations = equations_from(grafcet, {CdxForm::successor, modes});
            const std::optional<Netlist> netlist =
                netlist_from(grafcet, equations, Style::nand, diagnostics);
            REQUIRE(netlist.has_value());
            const SimulateResult result =
                simulate(grafcet, *netlist, cell_delays(*netlist, {}), *stimuli, {});
            REQUIRE_FALSE(result.unsettled_at.has_value());
            const Bench bench = bench_from(*netlist, *stimuli, result.trace.times);
            CHECK(in_icarus(*netlist, bench, millisecond) ==
                  outputs_of(result.trace, grafcet, *netlist));
        }
        const Netlist clocked = clocked_netlist(grafcet);
        const Time scan = 20 * millisecond;
        const Trace trace = run_scans(grafcet, *stimuli, scan).trace;
        CHECK(in_icarus(clocked, bench_from(clocked, *stimuli, trace.times), scan) ==
              outputs_of(trace, grafcet, clocked));
    }
}

TEST_CASE("gates that take times of their own in Icarus Verilog") {
    std::mt19937 random(31);
    std::size_t compared = 0;
    std::size_t lost = 0;
    for (const std::string name : {"single-sequence", "selection-divergence", "rule-5"}) {
        CAPTURE(name);
        Diagnostics diagnostics;
        const Grafcet grafcet = parsed(name, example_text(name + ".grafcet"));
        const std::optional<Stimuli> stimuli =
            parse_stimuli({name, example_text(name + ".stim")}, grafcet, diagnostics);
        REQUIRE(stimuli.has_value());
        const Trace reference = run_until_stable(grafcet, *stimuli).trace;
        const Equations equations = equations_from(grafcet, {CdxForm::successor, true});
        for (const Style style : {Style::gates, Style::nand, Style::nand}) {
            const std::optional<Netlist> netlist =
                netlist_from(grafcet, equations, style, diagnostics);
            REQUIRE(netlist.has_value());
            SimulateOptions options;
            options.schedule = random_delays(*netlist, random);
            const SimulateResult result =
                simulate(grafcet, *netlist, cell_delays(*netlist, {}), *stimuli, options);
            if (result.unsettled_at) continue;
            const Bench bench = bench_from(*netlist, *stimuli, result.trace.times);
            const std::string verilog = verilog_with(*netlist, options.schedule);
            CHECK(in_icarus(*netlist, bench, millisecond, verilog) ==
                  outputs_of(result.trace, grafcet, *netlist));
            ++compared;
            if (result.trace.values != reference.values) ++lost;
        }
    }
    CHECK(compared >= 6);
    // Some of these wirings do not do what their charts say.
    CHECK(lost > 0);
}

TEST_CASE("time conditions within time conditions in Icarus Verilog, and as logic in Yosys") {
    const Grafcet grafcet = nested_times();
    const Stimuli stimuli = restless_inputs();
    const Netlist netlist = clocked_netlist(grafcet);
    for (const Time scan : {5 * millisecond, 7 * millisecond, 10 * millisecond}) {
        CAPTURE(scan);
        const Trace trace = run_scans(grafcet, stimuli, scan).trace;
        CHECK(in_icarus(netlist, bench_from(netlist, stimuli, trace.times), scan) ==
              outputs_of(trace, grafcet, netlist));
    }
    ToolRunner tools;
    tools.write("netlist.v", write_verilog(netlist));
    const auto yosys = tools.run(
        "yosys -q -p 'read_verilog netlist.v; hierarchy -check -top nested; proc; flatten; check "
        "-assert; synth; check -assert'");
    CHECK(yosys.output == "");
    CHECK(yosys.status == 0);
}
