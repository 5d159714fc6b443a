#include "two_steps.h"

#include <doctest/doctest.h>

namespace grafwire::testing {

Grafcet grafcet_of(std::string_view text) {
    const SourceFile source{"two.grafcet", std::string(text)};
    Diagnostics diagnostics;
    auto grafcet = parse_grafcet(source, diagnostics);
    INFO(format_diagnostics(diagnostics, source));
    REQUIRE(grafcet.has_value());
    return *std::move(grafcet);
}

Stimuli stimuli_of(std::string_view text, const Grafcet& grafcet) {
    const SourceFile source{"two.stim", std::string(text)};
    Diagnostics diagnostics;
    auto stimuli = parse_stimuli(source, grafcet, diagnostics);
    INFO(format_diagnostics(diagnostics, source));
    REQUIRE(stimuli.has_value());
    return *std::move(stimuli);
}

SmallNetlist two_steps_netlist(bool modes) {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    small.netlist.has_modes = modes;
    if (modes) {
        for (const char* name : {"Init", "AUdur", "AUdoux"}) small.input(name);
        small.cell(CellType::inverter, "/AUdoux", {"AUdoux"});
        small.cell(CellType::inverter, "/Init", {"Init"});
    } else {
        small.cell(CellType::low, "Init", {});
        small.cell(CellType::high, "/AUdoux", {});
        small.cell(CellType::high, "/Init", {});
    }
    small.cell(CellType::and_gate, "s1", {"X0", "a", "/Init"});
    small.timed(CellType::timer, "t", {"X1"}, {3 * millisecond, 0, 0}, zero);
    small.cell(CellType::or_gate, "b+t", {"b", "t"});
    small.cell(CellType::and_gate, "s0", {"X1", "b+t"});
    small.cell(CellType::or_gate, "set0", {"s0", "Init"});
    small.cell(CellType::or_gate, "reset1", {"s0", "Init"});
    small.cell(CellType::latch, "X0", {"set0", "s1"});
    small.cell(CellType::latch, "X1", {"s1", "reset1"});
    small.cell(CellType::and_gate, "V", {"X1", "/AUdoux"});
    small.timed(CellType::rise_pulse, "up1", {"X1"}, {0, 5 * nanosecond, 0});
    small.cell(CellType::low, "never", {});
    small.cell(CellType::latch, "k", {"up1", "never"}, zero);
    for (const char* name : {"X0", "X1", "V"}) small.output(name);
    small.netlist.step_count = 2;
    small.netlist.vars.push_back({"k", {small.net("k")}, 0});
    small.netlist.counters.push_back({"c", {small.net("X1"), small.net("k")}, -2});
    return small;
}

SmallNetlist two_steps_clocked() {
    SmallNetlist small;
    small.input("a");
    small.clock("clk");
    small.netlist.has_modes = false;
    small.timed(CellType::scan_timer, "t", {"d1", "clk"}, {3 * millisecond, 0, 0}, zero);
    small.cell(CellType::inverter, "/a", {"a"});
    small.cell(CellType::inverter, "/t", {"t"});
    small.cell(CellType::and_gate, "s1", {"X0", "a"});
    small.cell(CellType::and_gate, "h1", {"X1", "/t"});
    small.cell(CellType::or_gate, "d1", {"s1", "h1"});
    small.cell(CellType::and_gate, "s0", {"X1", "t"});
    small.cell(CellType::and_gate, "h0", {"X0", "/a"});
    small.cell(CellType::or_gate, "d0", {"s0", "h0"});
    small.cell(CellType::flip_flop, "X0", {"d0", "clk"}, one);
    small.cell(CellType::flip_flop, "X1", {"d1", "clk"}, zero);
    small.output("X0");
    small.output("X1");
    small.netlist.step_count = 2;
    return small;
}

std::string traced(const SimulateResult& result) {
    return write_csv(result.trace);
}

}  // namespace grafwire::testing
