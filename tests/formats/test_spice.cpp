#include <doctest/doctest.h>

#include <sstream>

#include "formats/benches.h"
#include "formats/netlist_formats.h"
#include "formats/sample_netlists.h"
#include "formats/spice/spice_cells.h"
#include "support/tool_runner.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string deck_of(const Netlist& netlist, const Bench& bench = idle_bench(),
                    Time scan_period = 10 * ms) {
    return write_netlist(*netlist_format_named("spice"), netlist,
                         {.scan_period = scan_period, .bench = bench});
}

/// The rows of samples that ngspice prints: a digit per output.
std::vector<std::string> rows_in(const std::string& deck) {
    ToolRunner tools;
    tools.write("deck.cir", deck);
    const auto result = tools.run("ngspice -b deck.cir");
    CHECK(result.status == 0);
    std::vector<std::string> rows;
    std::istringstream output(result.output);
    bool in_table = false;
    std::size_t table = 0;
    std::size_t row = 0;
    for (std::string line; std::getline(output, line);) {
        if (line.starts_with("Time or Step")) {
            ++table;
            row = 0;
        }
        in_table = table != 0 && line.size() > 12 && line[1] == '.' && line.find("e+") < 14;
        if (!in_table) continue;
        std::istringstream cells(line);
        std::string cell;
        cells >> cell >> cell;
        if (cell != "0s" || row++ == 0) continue;  // the first row is the start
        std::string values;
        while (cells >> cell) values += cell[0];
        if (table == 1) {
            rows.push_back(values);
        } else {
            REQUIRE(row - 2 < rows.size());
            rows[row - 2] += values;
        }
    }
    return rows;
}

std::vector<std::string> sampled(const Netlist& netlist, const Bench& bench,
                                 Time scan_period = 10 * ms) {
    return rows_in(deck_of(netlist, bench, scan_period));
}

using Rows = std::vector<std::string>;

}  // namespace

TEST_CASE("the sequencer in ngspice") {
    const Bench bench = bench_of({{0, {}},
                                  {10 * ms, {{0, true}}},
                                  {20 * ms, {{1, true}}},
                                  {30 * ms, {{0, false}, {2, true}}}},
                                 {0, 10 * ms, 20 * ms, 30 * ms});
    CHECK(sampled(nand_sequencer(), bench) == Rows{"1000", "0101", "0011", "1000"});
}

TEST_CASE("latch, pulse and timer cells in ngspice") {
    const Bench bench =
        bench_of({{0, {{1, true}, {2, true}}},
                  {5 * ms, {{0, true}}},
                  {20 * ms, {{2, false}}},
                  {30 * ms, {{2, true}}},
                  {40 * ms, {{1, false}}},
                  {50 * ms, {{2, false}}}},
                 {0, 5 * ms, 19 * ms, 30 * ms, 40 * ms, 49 * ms, 50 * ms, 51 * ms, 52 * ms});
    Rows rows = sampled(all_asynchronous_cells(), bench);
    for (std::string& row : rows) row = {row[9], row[10], row[13]};
    CHECK(rows == Rows{"010", "110", "110", "110", "000", "000", "001", "001", "000"});
}

TEST_CASE("the delay of the gates in ngspice is a parameter of the deck") {
    std::string deck =
        deck_of(all_asynchronous_cells(),
                bench_of({{0, {{1, true}}}, {5 * ms, {{0, true}}}, {9 * ms, {{1, false}}}},
                         {0, 5 * ms, 9 * ms}));
    const Rows rows = rows_in(deck);
    CHECK(rows.size() == 3);
    const std::string_view line = ".param gate=1000\n";
    REQUIRE(deck.find(line) != std::string::npos);
    deck.replace(deck.find(line), line.size(), ".param gate=3500\n");
    CHECK(rows_in(deck) == rows);
}

TEST_CASE("ten seconds with gates of nanoseconds") {
    const Bench bench = bench_of({{5 * second, {{0, true}}}, {9 * second, {{1, true}}}},
                                 {0, 5 * second, 9 * second, 10 * second});
    CHECK(sampled(nand_sequencer(), bench) == Rows{"1000", "0101", "0011", "0011"});
}

TEST_CASE("a latch without modes starts at its initial value in ngspice") {
    const Bench bench = bench_of({{ms, {{1, true}}}, {2 * ms, {{1, false}}}, {3 * ms, {{0, true}}}},
                                 {0, ms, 2 * ms, 3 * ms});
    CHECK(sampled(latch_without_modes(), bench) == Rows{"1", "0", "0", "1"});
}

TEST_CASE("a flip-flop in ngspice, over more instants than one list holds") {
    NetlistMaker maker("toggle");
    maker.input("clk").output("X1");
    maker.cell(CellType::inverter, "d", {"X1"})
        .cell(CellType::flip_flop, "X1", {"d", "clk"}, Logic::one);
    Bench bench;
    Rows expected;
    for (int i = 0; i < 60; ++i) {
        bench.instants.push_back(i * ms);
        expected.push_back(i % 2 == 0 ? "0" : "1");
    }
    CHECK(sampled(maker.make(), bench) == expected);
}

TEST_CASE("gates of more inputs than one list holds, and more outputs than one table") {
    NetlistMaker maker("wide");
    std::vector<std::string> pins;
    for (int i = 0; i < 120; ++i) {
        pins.push_back("in" + std::to_string(i));
        maker.input(pins.back());
    }
    maker.output("all").output("none").output("odd");
    maker.cell(CellType::and_gate, "all", pins).cell(CellType::nor_gate, "none", pins);
    maker.cell(CellType::xor_gate, "odd", pins);
    for (const std::string& pin : pins)
        maker.output("/" + pin).cell(CellType::inverter, "/" + pin, {pin});
    std::vector<Stimuli::Assignment> all;
    for (std::uint32_t i = 0; i < 120; ++i) all.push_back({i, true});
    const Rows rows =
        sampled(maker.make(), bench_of({{ms, {{7, true}}}, {2 * ms, all}}, {0, ms, 2 * ms}));
    const std::string ones(120, '1');
    CHECK(rows == Rows{"010" + ones, "001" + ones.substr(0, 7) + "0" + ones.substr(8),
                       "100" + std::string(120, '0')});
}

TEST_CASE("odd names in ngspice") {
    const Rows rows = sampled(odd_names(), bench_of({{0, {{1, true}}}}, {0}));
    std::string expected(odd_input_names().size(), '1');
    expected[1] = '0';
    CHECK(rows == Rows{expected});
}

TEST_CASE("ngspice does not obey the name of a netlist") {
    for (const std::string name :
         {".include evil.cir ", ".inc evil.cir ", ".lib evil.cir ", ".control", "*ng_script", "@x",
          "*#echo pwned", "#echo pwned", "+ r 1 2", ".end"}) {
        INFO("name: " << name);
        NetlistMaker maker(name);
        maker.input(name).output("y").module(name).cell(CellType::inverter, "y", {name});
        ToolRunner tools;
        tools.write("evil.cir", ".control\nshell touch pwned\n.endc\n");
        tools.write("deck.cir", deck_of(maker.make(), bench_of({{0, {{0, true}}}}, {0})));
        const auto result = tools.run("ngspice -b deck.cir");
        CHECK(result.status == 0);
        CHECK(result.output.find("Time or Step") != std::string::npos);
        CHECK(result.output.find("\npwned") == std::string::npos);
        CHECK(tools.run("test -e pwned").status != 0);
    }
}

TEST_CASE("nodes keep their names where SPICE can tell them apart") {
    NetlistMaker maker("names");
    for (const char* name : {"X7", "x7", "H+", "H-", "null", "7", "_a"}) maker.input(name);
    const Netlist netlist = maker.make();
    const NetSpelling names = spice_nodes(netlist);
    std::string all;
    for (const Port& port : netlist.inputs) all += std::string(names[port.net]) + ' ';
    CHECK(all == "x7 x7_2 h_plus h_minus null_2 n7 a ");
}

TEST_CASE("clocked timers in ngspice are counters of scans") {
    Bench bench = bench_of({{0, {{0, true}}}, {50 * ms, {{0, false}}}},
                           {0, 10 * ms, 20 * ms, 30 * ms, 40 * ms, 50 * ms, 60 * ms, 70 * ms});
    CHECK(sampled(clocked_sample(), bench) ==
          Rows{"000", "100", "000", "110", "010", "011", "000", "000"});
    // Half as many scans for the same delays.
    bench.instants = {0, 20 * ms, 40 * ms, 60 * ms, 80 * ms};
    CHECK(sampled(clocked_sample(), bench, 20 * ms) == Rows{"000", "100", "010", "011", "000"});
}

TEST_CASE("the head says how the timers count") {
    const auto note = [](Time scan_period) {
        const std::string deck = deck_of(clocked_sample(), idle_bench(), scan_period);
        const std::size_t from = deck.find("* Clocked timers");
        REQUIRE(from != std::string::npos);
        return deck.substr(from, deck.find('\n', from) - from);
    };
    CHECK(note(10 * ms) ==
          "* Clocked timers: 8 flip-flops that count scans of 10ms, at most 3 for one delay.");
    CHECK(note(7 * ms) ==
          "* Clocked timers: 10 flip-flops that count scans of 7ms, at most 5 for one delay.");
    CHECK(deck_of(nand_sequencer()).find("Clocked timers") == std::string::npos);
}
