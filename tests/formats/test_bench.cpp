#include <doctest/doctest.h>

#include "formats/benches.h"
#include "formats/sample_netlists.h"
#include "formats/shared/bench.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// Events as text: "20ms a=1 row 2".
std::string described(const Netlist& netlist, const std::vector<BenchEvent>& events) {
    std::string text;
    for (const BenchEvent& event : events) {
        text += format_duration(event.at);
        for (const Stimuli::Assignment& item : event.assignments) {
            text += ' ' + netlist.inputs[item.input].name + (item.value ? "=1" : "=0");
        }
        if (event.row != BenchEvent::no_row) text += " row " + std::to_string(event.row);
        text += '\n';
    }
    return text;
}

}  // namespace

TEST_CASE("a bench starts with Init, and only changes are events") {
    const Netlist netlist = nand_sequencer();  // a, b, c, Init
    Bench bench;
    bench.stimuli.changes = {
        {0, {{0, true}, {0, true}}}, {10 * ms, {{0, true}, {1, true}}}, {15 * ms, {{1, false}}}};
    bench.instants = {0, 10 * ms, 20 * ms};
    CHECK(starting_inputs(netlist, bench) == std::vector<bool>{true, false, false, true});
    CHECK(described(netlist, bench_events(netlist, bench)) ==
          "0s Init=0 row 0\n10ms b=1 row 1\n15ms b=0\n20ms row 2\n");
}

TEST_CASE("Init may stay, and the first instant may come late") {
    const Netlist netlist = nand_sequencer();
    Bench bench;
    bench.stimuli.changes = {{0, {{3, true}}}, {5 * ms, {{3, false}}}};
    bench.instants = {3 * ms};
    CHECK(described(netlist, bench_events(netlist, bench)) == "0s\n3ms row 0\n");
}

TEST_CASE("samples are taken before the next instant") {
    Bench bench;
    bench.instants = {0, 10 * microsecond, ms};
    CHECK(sampling_delay(bench, 0) == 9 * microsecond);
    CHECK(sampling_delay(bench, 1) == 100 * microsecond);
    CHECK(sampling_delay(bench, 2) == 100 * microsecond);
    CHECK(longest_sampling_delay(bench, 1) == 891 * microsecond);
    CHECK(longest_sampling_delay(bench, 2) == never);
}

TEST_CASE("a bench from stimuli") {
    Stimuli stimuli;
    stimuli.changes = {{10 * ms, {{0, true}, {3, true}}, {}}, {20 * ms, {{4, true}}, {}}};
    stimuli.end = 30 * ms;
    // In a netlist without modes the numbers of the controls are past the inputs, or the clock's.
    NetlistMaker maker("m");
    const Netlist netlist = maker.input("a").input("b").input("c").input("clk").make();
    Bench bench = bench_from(netlist, stimuli);
    CHECK(bench.instants == std::vector<Time>{0, 10 * ms, 20 * ms, 30 * ms});
    CHECK(described(netlist, bench_events(netlist, bench)) ==
          "0s row 0\n10ms a=1 row 1\n20ms row 2\n30ms row 3\n");
    bench = bench_from(netlist, stimuli, {20 * ms, 0, 20 * ms});
    CHECK(bench.instants == std::vector<Time>{0, 20 * ms});
}
