#include <doctest/doctest.h>

#include "formats/exporters.h"
#include "formats/golden.h"
#include "formats/sample_netlists.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string exported(const Netlist& netlist, std::string_view format) {
    const Exporter* exporter = exporter_named(format);
    REQUIRE(exporter != nullptr);
    Diagnostics diagnostics;
    std::string text = exporter->write(netlist, {}, diagnostics);
    CHECK(diagnostics.items().empty());
    return text;
}

}  // namespace

TEST_CASE("the table of formats") {
    std::string names;
    for (const std::string_view name : exporter_names()) names += std::string(name) + ' ';
    CHECK(names == "verilog spice blif json dot stats text ");
    CHECK(exporter_named("edif") == nullptr);
    CHECK(nearest_name("verlog", exporter_names()) == "verilog");
    for (const Exporter& exporter : exporters()) {
        CHECK(exporter.extension.starts_with('.'));
        CHECK_FALSE(exporter.description.empty());
    }
}

TEST_CASE("golden files") {
    CHECK(exported(nand_sequencer(), "verilog") == golden("sequencer.v"));
    CHECK(exported(nand_sequencer(), "blif") == golden("sequencer.blif"));
    CHECK(exported(nand_sequencer(), "json") == golden("sequencer.json"));
    CHECK(exported(nand_sequencer(), "spice") == golden("sequencer.cir"));
    CHECK(exported(nand_sequencer(), "dot") == golden("sequencer.dot"));
    CHECK(exported(nand_sequencer(), "stats") == golden("sequencer.txt"));
    CHECK(exported(all_asynchronous_cells(), "verilog") == golden("all_cells.v"));
    CHECK(exported(all_asynchronous_cells(), "blif") == golden("all_cells.blif"));
    CHECK(exported(all_asynchronous_cells(), "json") == golden("all_cells.json"));
    CHECK(exported(all_asynchronous_cells(), "spice") == golden("all_cells.cir"));
    CHECK(exported(clocked_sample(), "verilog") == golden("clocked.v"));
    CHECK(exported(clocked_sample(), "blif") == golden("clocked.blif"));
    CHECK(exported(clocked_sample(), "json") == golden("clocked.json"));
    CHECK(exported(clocked_sample(), "spice") == golden("clocked.cir"));
    CHECK(exported(latch_without_modes(), "verilog") == golden("bare.v"));
    CHECK(exported(latch_without_modes(), "blif") == golden("bare.blif"));
}

TEST_CASE("a format is told apart from the netlist as a list") {
    CHECK(exported(latch_without_modes(), "text") == write_netlist_text(latch_without_modes()));
}

TEST_CASE("flip-flops cut the loops in the figures") {
    CHECK(exported(clocked_sample(), "stats") ==
          R"(clocked: 5 cells, 8 nets, 11 pins, 3 inputs, 3 outputs

cells by type
         1 XOR gate
         1 D flip-flop
         2 clocked timer
         1 look-ahead of a clocked timer

feedback loops: 0

largest fan-out: 4 pins, of clk

depth outside the loops: 1 cells
)");
}

TEST_CASE("the figures of an empty netlist") {
    CHECK(exported(NetlistMaker("none").make(), "stats") ==
          "none: 0 cells, 0 nets, 0 pins, 0 inputs, 0 outputs\n\ncells by type\n\n"
          "feedback loops: 0\n\ndepth outside the loops: 0 cells\n");
}

TEST_CASE("loops are named by their nets where there are no steps, and long lists are cut") {
    NetlistMaker maker("rings");
    maker.input("a");
    using enum CellType;
    maker.cell(nand_gate, "self", {"self", "a"});
    std::vector<std::string> names;
    for (int i = 0; i < 10; ++i) names.push_back("n" + std::to_string(i));
    for (std::size_t i = 0; i < 10; ++i) maker.cell(inverter, names[i], {names[(i + 9) % 10]});
    const std::string text = exported(maker.make(), "stats");
    CHECK(text.find("feedback loops: 2\n"
                    "  1 cells: nets self\n"
                    "  10 cells: nets n0, n1, n2, n3, n4, n5, n6, n7 and 2 more\n") !=
          std::string::npos);
}
