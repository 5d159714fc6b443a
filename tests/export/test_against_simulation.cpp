// The Verilog and SPICE that are written do in Icarus Verilog and ngspice what the netlist does in
// the product's own simulation, at every instant of the examples' stimuli.

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "equations/equations.h"
#include "evolution/run.h"
#include "export/tool_runner.h"
#include "export/write_verilog.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/netlist_from.h"
#include "simulate/simulate.h"

using namespace grafwire;

namespace {

std::string file_text(const std::string& path) {
    std::ifstream in(std::string(GRAFWIRE_ROOT) + "/" + path);
    REQUIRE(in.good());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
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

std::string in_icarus(const Netlist& netlist, const Bench& bench, Time scan) {
    ToolRunner tools;
    tools.write("netlist.v", write_verilog(netlist));
    tools.write("bench.v", write_verilog_testbench(netlist, bench, scan));
    REQUIRE(tools.run("iverilog -o run bench.v netlist.v").status == 0);
    const auto result = tools.run("vvp -n run");
    CHECK(result.status == 0);
    return result.output;
}

}  // namespace

TEST_CASE("examples in Icarus Verilog") {
    for (const std::string name :
         {"manipulator", "manipulator-modes", "positioning-axis", "nine-steps"}) {
        CAPTURE(name);
        Diagnostics diagnostics;
        const std::optional<Grafcet> grafcet =
            parse_grafcet({name, file_text("examples/" + name + ".grafcet")}, diagnostics);
        REQUIRE(grafcet.has_value());
        const std::optional<Stimuli> stimuli =
            parse_stimuli({name, file_text("examples/" + name + ".stim")}, *grafcet, diagnostics);
        REQUIRE(stimuli.has_value());
        for (const bool modes : {true, false}) {
            CAPTURE(modes);
            Equations equations = equations_from(*grafcet, {CdxForm::successor, modes});
            const std::optional<Netlist> netlist =
                netlist_from(equations, Style::nand, diagnostics);
            REQUIRE(netlist.has_value());
            const SimulateResult result =
                simulate(*grafcet, *netlist, unit_delays(*netlist), *stimuli, {});
            REQUIRE_FALSE(result.unsettled_at.has_value());
            const Bench bench = bench_from(*netlist, *stimuli, result.trace.times);
            CHECK(in_icarus(*netlist, bench, millisecond) ==
                  outputs_of(result.trace, *grafcet, *netlist));
        }
        Equations equations = equations_from(*grafcet, {CdxForm::transition, true});
        const std::optional<Netlist> clocked = netlist_from(equations, Style::clocked, diagnostics);
        REQUIRE(clocked.has_value());
        const Time scan = 20 * millisecond;
        const Trace trace = run_scans(*grafcet, *stimuli, scan).trace;
        CHECK(in_icarus(*clocked, bench_from(*clocked, *stimuli, trace.times), scan) ==
              outputs_of(trace, *grafcet, *clocked));
    }
}
