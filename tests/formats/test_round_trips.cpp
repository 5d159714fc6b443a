// What is written and read back must be the same netlist, and what other tools make of it must
// still be readable.

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "equations/equations.h"
#include "formats/blif/write_blif.h"
#include "formats/netlist_formats.h"
#include "formats/sample_netlists.h"
#include "formats/yosys/write_yosys_json.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/styles/styles.h"
#include "support/files.h"
#include "support/tool_runner.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// The cells and ports as text; modules are not kept by the formats, nor the order of initial
/// values.
std::string essence(const Netlist& netlist) {
    std::istringstream text(write_netlist_text(netlist));
    std::string result;
    std::vector<std::string> initial;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("module ")) continue;
        if (line.starts_with("initially ")) {
            initial.push_back(line);
        } else {
            result += line + '\n';
        }
    }
    std::sort(initial.begin(), initial.end());
    for (const std::string& line : initial) result += line + '\n';
    return result;
}

Netlist read_back(std::string_view format, const std::string& text) {
    const SourceFile source{"x", text};
    Diagnostics diagnostics;
    std::optional<Netlist> netlist = netlist_format_named(format)->read(source, diagnostics);
    CHECK(format_diagnostics(diagnostics, source) == "");
    REQUIRE(netlist.has_value());
    CHECK(fault_of(*netlist) == "");
    return std::move(*netlist);
}

Netlist read_back_blif(const std::string& text) {
    return read_back("blif", text);
}

Netlist read_back_json(const std::string& text) {
    return read_back("json", text);
}

void check_same(const Netlist& a, const Netlist& b) {
    CHECK(essence(a) == essence(b));
    CHECK(a.timings == b.timings);
    CHECK(a.has_modes == b.has_modes);
    CHECK(a.is_clocked() == b.is_clocked());
    CHECK(a.step_count == b.step_count);
}

void check_round_trips(const Netlist& netlist) {
    for (const NetlistFormat& format : netlist_formats()) {
        if (format.read == nullptr) continue;
        CAPTURE(format.name);
        check_same(netlist, read_back(format.name, write_netlist(format, netlist)));
    }
}

constexpr std::string_view examples[] = {
    "manipulator", "manipulator-modes", "positioning-axis", "press",
    "rule-5",      "nine-steps",        "batch-counter"};

/// Every example in every style that can hold it.
template <typename Visit>
void for_each_example(const Visit& visit) {
    std::size_t count = 0;
    for (const std::string_view name : examples) {
        const SourceFile source{std::string(name), example_text(std::string(name) + ".grafcet")};
        Diagnostics diagnostics;
        const std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
        REQUIRE(grafcet.has_value());
        for (const StyleRow& style : style_table) {
            for (const bool modes : {true, false}) {
                const Equations equations = equations_from(*grafcet, {style.default_cdx, modes});
                Diagnostics refusals;
                const std::optional<Netlist> netlist =
                    netlist_from(*grafcet, equations, style.style, refusals);
                if (!netlist) continue;
                CAPTURE(name);
                CAPTURE(style.name);
                visit(*netlist);
                ++count;
            }
        }
    }
    CHECK(count >= 40);
}

}  // namespace

TEST_CASE("hand-made netlists come back as they were") {
    check_round_trips(nand_sequencer());
    check_round_trips(all_asynchronous_cells());
    check_round_trips(clocked_sample());
    check_round_trips(latch_without_modes());
    check_round_trips(odd_names());
    check_round_trips(NetlistMaker("none").make());
}

TEST_CASE("the netlists of the examples come back as they were") {
    for_each_example([](const Netlist& netlist) { check_round_trips(netlist); });
}

TEST_CASE("names come back as they were") {
    for (const NetlistFormat& format : netlist_formats()) {
        if (format.read == nullptr) continue;
        CAPTURE(format.name);
        const Netlist back = read_back(format.name, write_netlist(format, odd_names()));
        REQUIRE(back.inputs.size() == odd_input_names().size());
        for (std::size_t i = 0; i < odd_input_names().size(); ++i) {
            CHECK(back.inputs[i].name == odd_input_names()[i]);
        }
        CHECK(back.name == "odd names");
    }
}

TEST_CASE("an exclusive or too wide for one cover becomes a chain") {
    NetlistMaker maker("wide");
    std::vector<std::string> pins;
    for (int i = 0; i < 9; ++i) {
        pins.push_back("i" + std::to_string(i));
        maker.input(pins.back());
    }
    const Netlist netlist = maker.output("y").cell(CellType::xor_gate, "y", pins).make();
    check_same(netlist, read_back_json(write_yosys_json(netlist)));
    const Netlist chain = read_back_blif(write_blif(netlist));
    CHECK(chain.cells.size() == 8);
    for (const Cell& cell : chain.cells) CHECK(cell.type == CellType::xor_gate);
}

TEST_CASE("an output that shares its net") {
    NetlistMaker maker("shared");
    maker.input("a").output("X1").cell(CellType::inverter, "X1", {"a"});
    Netlist netlist = maker.make();
    netlist.outputs.push_back({"copy", netlist.outputs[0].net});
    check_same(netlist, read_back_json(write_yosys_json(netlist)));
    // BLIF has no second names, so the copy is a buffer.
    CHECK(essence(read_back_blif(write_blif(netlist))) ==
          "netlist shared\ninput a\noutput X1 = X1\noutput copy = copy\n  copy = buf(X1)\n  X1 = "
          "not(a)\n");
}

TEST_CASE("black boxes have names of their own") {
    Netlist netlist = all_asynchronous_cells();
    netlist.name = "grafwire_latch";
    const std::string blif = write_blif(netlist);
    CHECK(blif.find(".subckt grafwire__latch ") != std::string::npos);
    check_round_trips(netlist);
}

TEST_CASE("Yosys reads what is written, and what it writes is read") {
    ToolRunner tools;
    for_each_example([&](const Netlist& netlist) {
        tools.write("in.json", write_yosys_json(netlist));
        tools.write("in.blif", write_blif(netlist));
        const auto json = tools.run(
            "yosys -q -p 'read_json in.json; hierarchy -check; check; stat; write_json out.json'");
        CHECK(json.status == 0);
        const Netlist from_json = read_back_json(tools.read("out.json"));
        CHECK(from_json.cells.size() == netlist.cells.size());
        CHECK(from_json.timings.size() == netlist.timings.size());
        // Yosys reads no table of more than 12 inputs in a BLIF file.
        const bool is_wide = std::any_of(netlist.cells.begin(), netlist.cells.end(),
                                         [](const Cell& cell) { return cell.pin_count > 12; });
        if (is_wide) return;
        const auto blif = tools.run(
            "yosys -q -p 'read_blif in.blif; hierarchy -check; check; simplemap; write_blif -attr "
            "out.blif'");
        CHECK(blif.status == 0);
        const Netlist from_blif = read_back_blif(tools.read("out.blif"));
        CHECK(from_blif.outputs.size() == netlist.outputs.size());
        CHECK(from_blif.timings.size() == netlist.timings.size());
    });
}

TEST_CASE("what Yosys and ABC make of a clocked netlist is read") {
    ToolRunner tools;
    tools.write(
        "in.blif",
        write_blif(read_back_blif(
            ".model m\n.inputs a clk\n.outputs X1 X2\n.names a X1 d\n10 1\n01 1\n"
            ".latch d X1 re clk 1\n.names X1 X2 a e\n1-1 1\n-10 1\n.latch e X2 re clk 0\n.end\n")));
    CHECK(tools.run("yosys -q -p 'read_blif in.blif; synth; write_json out.json'").status == 0);
    const Netlist yosys = read_back_json(tools.read("out.json"));
    CHECK(yosys.is_clocked());
    std::size_t flip_flops = 0;
    for (const Cell& cell : yosys.cells) flip_flops += cell.type == CellType::flip_flop ? 1 : 0;
    CHECK(flip_flops == 2);
    // ABC exits with 0 even if it cannot read a file.
    const auto abc = tools.run("berkeley-abc -c 'read_blif in.blif; strash; write_blif out.blif'");
    CHECK(abc.status == 0);
    const Netlist back = read_back_blif(tools.read("out.blif"));
    CHECK(back.is_clocked());
    CHECK(back.outputs.size() == 2);
    CHECK(back.inputs.size() == 2);
}
