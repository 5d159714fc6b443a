// What is read off the gates of a step is what its equation says, in every style.

#include <filesystem>
#include <fstream>
#include <sstream>

#include "explain/compare_functions.h"
#include "explain/explained.h"
#include "formats/blif/read_blif.h"
#include "formats/yosys/read_yosys_json.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

std::string text_of_file(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Count {
    std::size_t same = 0;
    std::size_t unread = 0;
};

void compare_all(const Grafcet& grafcet, const StyleRow& style, Count& count) {
    const Equations equations = equations_from(grafcet, {style.default_cdx, true});
    Diagnostics diagnostics;
    const auto netlist = netlist_from(grafcet, equations, style.style, diagnostics);
    if (!netlist) return;  // counters need the clocked style
    const NetReader reader(grafcet, *netlist);
    if (style.style == Style::handshake) {  // its gates wait for each other
        for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
            const auto comparison = compare_step(reader, equations, grafcet.steps.id_at(i));
            CHECK(comparison.fault == Explanation::Fault::unread);
        }
        return;
    }
    const auto note = [&](const FunctionComparison& comparison, const std::string& name) {
        if (comparison.fault == Explanation::Fault::unread) {
            ++count.unread;
            return;
        }
        ++count.same;
        // Deactivation wins in the memory of NOR gates.
        const bool is_nor = style.style == Style::nor;
        const bool is_right = comparison.fault == Explanation::Fault::no_fault ||
                              (is_nor && comparison.fault == Explanation::Fault::priority);
        if (!is_right) {
            std::string texts;
            for (const auto& pair : comparison.equations) {
                texts += pair.name + " = " + pair.expected + " | " + pair.got + "\n";
            }
            FAIL_CHECK(grafcet.name << " " << style.name << " " << name << "\n" << texts);
        }
    };
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const StepId step = grafcet.steps.id_at(i);
        note(compare_step(reader, equations, step), "X" + grafcet.steps[step].name);
    }
    for (std::size_t i = 0; i < grafcet.outputs.size(); ++i) {
        const OutputId output = grafcet.outputs.id_at(i);
        note(compare_output(reader, equations, output), grafcet.outputs[output].name);
    }
}

/// X0 that nothing resets, and `lamp` out of what some cells make of `a` and `b`: net 5.
Netlist lamp_of(const std::string& cells) {
    const std::string text = R"({"modules": {"m": {"ports": {
      "a": {"direction": "input", "bits": [2]}, "b": {"direction": "input", "bits": [3]},
      "X0": {"direction": "output", "bits": [6]}, "lamp": {"direction": "output", "bits": [4]}},
      "cells": {
      "memory": {"type": "$_OR_", "connections": {"A": [6], "B": [6], "Y": [6]}},
      "lit": {"type": "$_AND_", "connections": {"A": [6], "B": [5], "Y": [4]}}, )" +
                             cells + "}}}}";
    Diagnostics diagnostics;
    auto netlist = read_yosys_json({"lamp.json", text}, diagnostics);
    REQUIRE(netlist);
    return std::move(*netlist);
}

FunctionComparison compared_lamp(const std::string& chart, const Netlist& netlist) {
    const Grafcet grafcet = grafcet_of(chart);
    return compare_output(NetReader(grafcet, netlist),
                          equations_from(grafcet, {CdxForm::successor, false}), OutputId{0});
}

/// Wired by hand; `m` remembers what `a` was in the scan before.
const std::string edge_wiring = R"(.model edge
.inputs a clk
.outputs X0 X1
.latch a m re clk 0
.names a m e
10 1
.names X1 a X0 e n0
10-- 1
--10 1
.names X0 e X1 a n1
11-- 1
--11 1
.latch n0 X0 re clk 1
.latch n1 X1 re clk 0
.end
)";

}  // namespace

TEST_CASE("an exclusive OR is read as one") {
    const FunctionComparison lamp =
        compared_lamp("input a, b output lamp graph G { initial 0 : lamp if a ⊕ b }",
                      lamp_of(R"("g": {"type": "$_XOR_",
                                       "connections": {"A": [2], "B": [3], "Y": [5]}})"));
    CHECK(lamp.fault == Explanation::Fault::no_fault);
    REQUIRE(lamp.equations.size() == 1);
    std::vector<std::string> operands;
    for (const auto& operand : lamp.equations[0].operands) operands.push_back(operand.name);
    CHECK(operands == std::vector<std::string>{"X0", "a", "b"});
}

TEST_CASE(
    "what the netlist lacks may be made by its gates if the GRAFCET makes it, not if it is an "
    "input") {
    // a + /a decides nothing, and may stand for anything.
    const Netlist netlist = lamp_of(R"("n": {"type": "$_NOT_", "connections": {"A": [2], "Y": [7]}},
                   "g": {"type": "$_OR_", "connections": {"A": [2], "B": [7], "Y": [5]}})");
    CHECK(compared_lamp("input a, b var v output lamp graph G { initial 0 : lamp if v }", netlist)
              .fault == Explanation::Fault::unread);
    CHECK(
        compared_lamp("input a, c output lamp graph G { initial 0 : lamp if c }", netlist).fault ==
        Explanation::Fault::equation);
}

TEST_CASE("an edge that is seen two scans late is not taken for the edge") {
    const Grafcet grafcet = grafcet_of(R"(
input a
graph G { initial 0 step 1
  0 -> 1 : ↑a
  1 -> 0 : /a })");
    const Equations equations = equations_from(grafcet, {CdxForm::transition, false});
    const auto fault_of_step_1 = [&](const std::string& wiring) {
        Diagnostics diagnostics;
        const auto netlist = read_blif({"edge.blif", wiring}, diagnostics);
        REQUIRE(netlist);
        return compare_step(NetReader(grafcet, *netlist), equations, StepId{1}).fault;
    };
    CHECK(fault_of_step_1(edge_wiring) == Explanation::Fault::no_fault);
    CHECK(fault_of_step_1(
              replaced(edge_wiring, ".names a m e", ".latch m late re clk 0\n.names a late e")) ==
          Explanation::Fault::unread);
}

TEST_CASE("the gates of every example say what the equations say") {
    Count count;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(GRAFWIRE_ROOT) + "/examples")) {
        if (entry.path().extension() != ".grafcet") continue;
        const Grafcet grafcet = grafcet_of(text_of_file(entry.path()));
        for (const StyleRow& style : style_table) compare_all(grafcet, style, count);
    }
    MESSAGE(count.same << " compared, " << count.unread << " not to be read");
    CHECK(count.same > 6 * count.unread);
}

}  // namespace grafwire::testing
