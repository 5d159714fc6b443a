#include <doctest/doctest.h>
#include <fmt/format.h>

#include "formats/netlist_formats.h"
#include "formats/sample_netlists.h"
#include "formats/shared/gate_delays.h"
#include "support/reviewed_file.h"
#include "text/nearest_name.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string written(const Netlist& netlist, std::string_view format) {
    REQUIRE(netlist_format_named(format) != nullptr);
    return write_netlist(*netlist_format_named(format), netlist);
}

const NetlistFormat* readable(std::string_view path) {
    const NetlistFormat* format = readable_format_of(path);
    CHECK((format == nullptr || format->read != nullptr));
    return format;
}

}  // namespace

TEST_CASE("the table of formats") {
    CHECK(netlist_format_named("edif") == nullptr);
    CHECK(nearest_name("verlog", netlist_format_names()) == "verilog");
    for (const NetlistFormat& format : netlist_formats()) {
        CHECK(netlist_format_named(format.name) == &format);
        CHECK(format.extension.starts_with('.'));
        CHECK_FALSE(format.description().english.empty());
        CHECK(format.description().french != format.description().english);
    }
}

TEST_CASE("files are read by the format of their extension") {
    CHECK(readable("a.b/c.blif") == netlist_format_named("blif"));
    CHECK(readable("c.json") == netlist_format_named("json"));
    CHECK(readable("c.v") == nullptr);
    CHECK(readable("blif") == nullptr);
}

// tests/formats/golden/FORMAT has a file for every sample; `tools/bless --tables` writes them.
TEST_CASE("samples in every format") {
    const std::pair<std::string, Netlist> samples[] = {{"sequencer", nand_sequencer()},
                                                       {"all_cells", all_asynchronous_cells()},
                                                       {"clocked", clocked_sample()},
                                                       {"bare", latch_without_modes()}};
    for (const NetlistFormat& format : netlist_formats()) {
        for (const auto& [name, netlist] : samples) {
            const std::string file = "formats/golden/" + std::string(format.name) + '/' + name +
                                     std::string(format.extension);
            check_reviewed(file, write_netlist(format, netlist));
        }
    }
}

TEST_CASE("the stimuli and the scan period are heeded where the row says so") {
    const Netlist netlist = clocked_sample();
    WriteOptions with_bench;
    with_bench.bench.stimuli.changes = {{0, {{0, true}}}};
    for (const NetlistFormat& format : netlist_formats()) {
        CAPTURE(format.name);
        const std::string plain = write_netlist(format, netlist);
        const bool has_bench = format.options.find("--bench") != std::string_view::npos;
        CHECK((has_bench && format.write_bench == nullptr) ==
              (write_netlist(format, netlist, with_bench) != plain));
        CHECK((format.options.find("--scan") != std::string_view::npos) ==
              (write_netlist(format, netlist, {.scan_period = 20 * millisecond}) != plain));
        if (format.write_bench == nullptr) continue;
        CHECK(has_bench);
        CHECK(format.write_bench(netlist, with_bench) != format.write_bench(netlist, {}));
    }
}

TEST_CASE("gates have the delay of the model, as a parameter with one default") {
    const Netlist netlist = all_asynchronous_cells();
    const DelayModel slow{.name = "slow", .gate = {2500, 2500}};
    const std::string verilog =
        write_netlist(*netlist_format_named("verilog"), netlist, {.delays = slow});
    CHECK(verilog.find("module all_cells #(parameter GATE_NS = 2.5) (") != std::string::npos);
    CHECK(verilog.find("and #GATE_NS and3$g (") != std::string::npos);
    CHECK(verilog.find("#(.GATE_NS(GATE_NS), .INIT(1'b0)) kept$g (") != std::string::npos);
    CHECK(verilog.find("assign #(1000 * GATE_NS) q") != std::string::npos);
    CHECK(verilog.find("`define GRAFWIRE_START (100 * GATE_NS)\n") != std::string::npos);
    const std::string spice =
        write_netlist(*netlist_format_named("spice"), netlist, {.delays = slow});
    CHECK(spice.find(".param gate=2500\n") != std::string::npos);
    CHECK(spice.find("slow_and d_and(rise_delay={gate} fall_delay={gate})") != std::string::npos);
    CHECK(spice.find("held_and d_and(rise_delay={gate - 1} fall_delay={gate - 1})") !=
          std::string::npos);
    CHECK(spice.find("flip_flop_x d_dff(clk_delay={gate} ic=2)") != std::string::npos);
    CHECK(write_netlist(*netlist_format_named("verilog"), clocked_sample()).find("GATE_NS") ==
          std::string::npos);
}

TEST_CASE("times in gate delays") {
    const DelayModel slow{.name = "slow", .gate = {2500, 2500}};
    CHECK(in_gate_delays(2500, slow, "g") == "g");
    CHECK(in_gate_delays(7500, slow, "g") == "3 * g");
    CHECK(in_gate_delays(4000, slow, "g") == "(4000.0 / 2500) * g");
}

TEST_CASE("a format is told apart from the netlist as a list") {
    const Netlist latch = latch_without_modes();
    CHECK(written(latch, "text") ==
          fmt::format("# {}: {} cells.\n", latch.name, latch.cells.size()) +
              write_netlist_text(latch));
}

TEST_CASE("flip-flops cut the loops in the figures") {
    CHECK(written(clocked_sample(), "stats") ==
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
    CHECK(written(NetlistMaker("none").make(), "stats") ==
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
    const std::string text = written(maker.make(), "stats");
    CHECK(text.find("feedback loops: 2\n"
                    "  1 cells: nets self\n"
                    "  10 cells: nets n0, n1, n2, n3, n4, n5, n6, n7 and 2 more\n") !=
          std::string::npos);
}
