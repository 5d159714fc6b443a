#include <doctest/doctest.h>

#include "formats/benches.h"
#include "formats/sample_netlists.h"
#include "formats/verilog/verilog_names.h"
#include "formats/verilog/write_verilog.h"
#include "support/tool_runner.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string spelled(std::string_view name) {
    std::string out;
    spell_verilog(out, name);
    return out;
}

/// What the test bench prints when Icarus Verilog runs it; `options` may set its parameters.
std::string simulated(const Netlist& netlist, const Bench& bench, Time scan = 10 * millisecond,
                      const std::string& options = "") {
    ToolRunner tools;
    tools.write("netlist.v", write_verilog(netlist));
    tools.write("bench.v", write_verilog_bench(netlist, bench, scan));
    const auto compiled = tools.run("iverilog -Wall " + options + " -o run bench.v netlist.v");
    CHECK(compiled.status == 0);
    const auto result = tools.run("vvp -n run");
    CHECK(result.status == 0);
    return result.output;
}

}  // namespace

TEST_CASE("identifiers keep their spelling where Verilog can hold it") {
    CHECK(spelled("X7") == "X7");
    CHECK(spelled("X7$set") == "X7$set");
    CHECK(spelled("$low") == "\\$low ");
    CHECK(spelled("H+") == "\\H+ ");
    CHECK(spelled("1") == "\\1 ");
    CHECK(spelled("étape") == "\\étape ");
    CHECK(spelled("module") == "\\module ");
    CHECK(spelled("logic") == "\\logic ");
    CHECK(spelled("a b") == "\\a%20b ");
    CHECK(spelled("a%20b") == "\\a%2520b ");
    CHECK(spelled("a`b") == "\\a%60b ");
    CHECK(spelled("*a\"") == "\\%2Aa%22 ");
    CHECK(spelled("a*b*") == "\\a*b* ");
    CHECK(spelled("/*(*//**") == "\\/%2A(%2A//%2A* ");
    CHECK(spelled("/%2A") == "\\/%252A ");
}

TEST_CASE("the sequencer in Icarus Verilog") {
    // a at 10 ms, b at 20 ms, c at 30 ms; c takes the token back to 0, where a is still 1.
    const Bench bench = bench_of({{0, {}},
                                  {10 * ms, {{0, true}}},
                                  {20 * ms, {{1, true}}},
                                  {30 * ms, {{0, false}, {2, true}}}},
                                 {0, 10 * ms, 20 * ms, 30 * ms});
    CHECK(simulated(nand_sequencer(), bench) ==
          "time_ms,X0,X1,X2,lamp\n0,1,0,0,0\n10,0,1,0,1\n20,0,0,1,1\n30,1,0,0,0\n");
}

TEST_CASE("latch, pulse and timer cells in Icarus Verilog") {
    const Bench bench = bench_of(
        {{0, {{1, true}, {2, true}}},  // c: the timer starts at 0
         {5 * ms, {{0, true}}},        // rise of a sets the latch
         {20 * ms, {{2, false}}},      // c falls as the timer ends
         {30 * ms, {{2, true}}},
         {40 * ms, {{1, false}}},  // fall of b resets it
         {50 * ms, {{2, false}}}},
        {0, 5 * ms, 19 * ms, 20 * ms, 30 * ms, 40 * ms, 49 * ms, 50 * ms, 51 * ms, 52 * ms});
    const std::string output = simulated(all_asynchronous_cells(), bench);
    // Columns kept, held, late.
    std::string rows;
    std::size_t line = 0;
    for (std::size_t end = output.find('\n'); end != std::string::npos;
         end = output.find('\n', line)) {
        const std::string text = output.substr(line, end - line);
        std::vector<std::string> cells(1);
        for (const char c : text) {
            if (c == ',') {
                cells.emplace_back();
            } else {
                cells.back() += c;
            }
        }
        REQUIRE(cells.size() == 15);
        rows += cells[0] + ' ' + cells[10] + cells[11] + cells[14] + '\n';
        line = end + 1;
    }
    CHECK(rows ==
          "time_ms keptheldlate\n"
          "0 010\n5 110\n19 110\n20 111\n30 110\n40 000\n49 000\n50 001\n51 001\n52 000\n");
}

TEST_CASE("gates in Icarus Verilog") {
    std::vector<Stimuli::Change> changes;
    std::vector<Time> instants;
    for (std::uint32_t i = 0; i < 8; ++i) {
        changes.push_back({i * ms, {{0, (i & 4U) != 0}, {1, (i & 2U) != 0}, {2, (i & 1U) != 0}}});
        instants.push_back(i * ms);
    }
    const std::string output = simulated(all_asynchronous_cells(), bench_of(changes, instants));
    // zero, one, same, not_a, and3, or3, nand3, nor3, xor3
    const char* expected[] = {"0,0,1,0,1,0,0,1,1,0", "1,0,1,0,1,0,1,1,0,1", "2,0,1,0,1,0,1,1,0,1",
                              "3,0,1,0,1,0,1,1,0,0", "4,0,1,1,0,0,1,1,0,1", "5,0,1,1,0,0,1,1,0,0",
                              "6,0,1,1,0,0,1,1,0,0", "7,0,1,1,0,1,1,0,0,1"};
    for (const char* row : expected)
        CHECK(output.find(std::string("\n") + row + ",") != std::string::npos);
}

TEST_CASE("a timer counts from the start of the stimuli, and a return starts it anew") {
    NetlistMaker maker("timed");
    maker.input("a").output("q").cell(CellType::timer, "q", {"a"}, Logic::zero,
                                      {10 * ms, 4 * ms, 0});
    const Bench bench = bench_of({{0, {{0, true}}},
                                  {30 * ms, {{0, false}}},
                                  {33 * ms, {{0, true}}},
                                  {40 * ms, {{0, false}}},
                                  {50 * ms, {{0, true}}},
                                  {59 * ms, {{0, false}}}},
                                 {0, 9 * ms, 10 * ms, 34 * ms, 43 * ms, 44 * ms, 59 * ms, 61 * ms});
    CHECK(simulated(maker.make(), bench) ==
          "time_ms,q\n0,0\n9,0\n10,1\n34,1\n43,1\n44,0\n59,0\n61,0\n");
}

TEST_CASE("delays of hours") {
    NetlistMaker maker("slow");
    maker.input("a").output("q").cell(CellType::timer, "q", {"a"}, Logic::zero, {30 * hour, 0, 0});
    const Bench bench = bench_of({{0, {{0, true}}}}, {0, 30 * hour - ms, 30 * hour});
    CHECK(simulated(maker.make(), bench) == "time_ms,q\n0,0\n107999999,0\n108000000,1\n");
}

TEST_CASE("a pulse begun again lasts on") {
    // Two rises 4 ns apart, made by a delay line: a pulse of 5 ns then lasts 9 ns, and another that
    // comes 6 ns after its beginning meets it.
    NetlistMaker maker("pulses");
    using enum CellType;
    maker.input("a").output("seen");
    std::string last = "a";
    for (int i = 1; i <= 8; ++i) {
        const std::string next = "d" + std::to_string(i);
        maker.cell(buffer, next, {last});
        last = next;
    }
    maker.cell(inverter, "d1$not", {"d1"})
        .cell(and_gate, "first", {"a", "d1$not"})
        .cell(or_gate, "twice", {"first", "d5"})
        .cell(rise_pulse, "p", {"twice"}, Logic::unknown, {0, 5 * nanosecond})
        .cell(rise_pulse, "t", {"d8"}, Logic::unknown, {0, nanosecond})
        .cell(and_gate, "both", {"p", "t"})
        .cell(low, "never", {})
        .cell(latch, "seen", {"both", "never"}, Logic::zero);
    CHECK(simulated(maker.make(), bench_of({{ms, {{0, true}}}}, {0, ms})) ==
          "time_ms,seen\n0,0\n1,1\n");
}

TEST_CASE("with slower gates pulses last longer, and rows are taken later") {
    // A pulse of three gate delays is seen by gates that take one each, however long that is.
    NetlistMaker maker("slower");
    using enum CellType;
    maker.input("a").input("GATE_NS").output("seen").output("last");
    maker.cell(rise_pulse, "p", {"a"}, Logic::unknown, {0, 3 * nanosecond})
        .cell(buffer, "a$late", {"a"})
        .cell(buffer, "a$later", {"a$late"})
        .cell(and_gate, "both", {"p", "a$later"})
        .cell(latch, "seen", {"both", "GATE_NS"}, Logic::zero);
    std::string from = "a";
    for (int i = 1; i <= 4; ++i) {
        const std::string to = i == 4 ? "last" : "d" + std::to_string(i);
        maker.cell(buffer, to, {from});
        from = to;
    }
    const Netlist netlist = maker.make();
    const Bench bench = bench_of({{ms, {{0, true}}}}, {0, ms, 2 * ms});
    for (const std::string gate : {"1", "3", "7.25", "40000"}) {
        CAPTURE(gate);
        CHECK(simulated(netlist, bench, 10 * ms, "-P grafwire_bench.GATE_NS=" + gate) ==
              "time_ms,seen,last\n0,0,0\n1,1,1\n2,1,1\n");
    }
    // Too little time to settle, and more gate delays than lie between two instants.
    CHECK(simulated(netlist, bench, 10 * ms,
                    "-P grafwire_bench.GATE_NS=3 -P grafwire_bench.SETTLE_NS=11") ==
          "time_ms,seen,last\n0,0,0\n1,0,0\n2,1,1\n");
    CHECK(simulated(netlist, bench, 10 * ms, "-P grafwire_bench.GATE_NS=240000") ==
          "time_ms,seen,last\n0,0,0\n1,0,0\n2,1,1\n");
}

TEST_CASE("the clocked sample in Icarus Verilog, scan by scan") {
    Bench bench = bench_of({{0, {{0, true}}}, {50 * ms, {{0, false}}}},
                           {0, 10 * ms, 20 * ms, 30 * ms, 40 * ms, 50 * ms, 60 * ms, 70 * ms});
    CHECK(simulated(clocked_sample(), bench) ==
          "time_ms,X1,late,later\n0,0,0,0\n10,1,0,0\n20,0,0,0\n30,1,1,0\n40,0,1,0\n50,0,1,1\n60,0,"
          "0,0\n70,0,0,0\n");
    // Half as many scans for the same delays.
    bench.instants = {0, 20 * ms, 40 * ms, 60 * ms, 80 * ms};
    CHECK(simulated(clocked_sample(), bench, 20 * ms) ==
          "time_ms,X1,late,later\n0,0,0,0\n20,1,0,0\n40,0,1,0\n60,0,1,1\n80,0,0,0\n");
    bench.instants = {0, 60 * ms};
    bench.clock_cycles = 5;
    CHECK(simulated(clocked_sample(), bench) == "time_ms,X1,late,later\n0,0,1,0\n60,0,0,0\n");
}

TEST_CASE("the initial values of a netlist without modes") {
    const Bench bench = bench_of({{ms, {{1, true}}}, {2 * ms, {{1, false}}}, {3 * ms, {{0, true}}}},
                                 {0, ms, 2 * ms, 3 * ms});
    CHECK(simulated(latch_without_modes(), bench) == "time_ms,X1\n0,1\n1,0\n2,0\n3,1\n");
}

TEST_CASE("odd names pass through Icarus Verilog and Yosys") {
    std::string expected = "0";
    for (std::size_t i = 0; i < odd_input_names().size(); ++i) expected += i == 1 ? ",0" : ",1";
    const std::string output = simulated(odd_names(), bench_of({{0, {{1, true}}}}, {0}));
    CHECK(output.substr(0, 20) == "time_ms,!H+,!a b,!a%");
    CHECK(output.find("\n" + expected + "\n") != std::string::npos);
    ToolRunner tools;
    tools.write("netlist.v", write_verilog(odd_names()));
    CHECK(tools
              .run("yosys -q -p 'read_verilog netlist.v; hierarchy -check -auto-top; proc; check "
                   "-assert'")
              .status == 0);
}

TEST_CASE("names do not begin comments for the preprocessor of Icarus Verilog") {
    // The directives that follow are lost in such a comment.
    for (const std::string name : {"a/*b", "(*", "/*(*", "a//b", "\"", "*/"}) {
        INFO("name: " << name);
        NetlistMaker maker(name);
        maker.input(name).input("reset").output("kept");
        maker.module("m").cell(CellType::latch, "kept", {name, "reset"}, Logic::zero);
        const std::string output =
            simulated(maker.make(), bench_of({{0, {{0, true}}}, {ms, {{0, false}}}}, {0, ms}));
        CHECK(output == "time_ms,kept\n0,1\n1,1\n");
    }
}

TEST_CASE("names are no comments that Yosys obeys") {
    for (const std::string name : {"synopsys translate_off", " synthesis translate_off",
                                   "* synopsys translate_off", "synthesis full_case"}) {
        INFO("name: " << name);
        NetlistMaker maker(name);
        maker.input("a").output("b").module(name).cell(CellType::inverter, "b", {"a"});
        maker.module("m", name + " = b").cell(CellType::inverter, "c", {"b"});
        ToolRunner tools;
        tools.write("netlist.v", write_verilog(maker.make()));
        const auto result = tools.run(
            "yosys -q -p 'read_verilog netlist.v; hierarchy -check -auto-top; "
            "select -assert-count 2 t:*'");
        INFO(result.output);
        CHECK(result.status == 0);
    }
}

TEST_CASE("a netlist that does not settle ends the run") {
    NetlistMaker maker("oscillator");
    maker.input("a").output("y").cell(CellType::nand_gate, "y", {"y", "a"});
    const std::string output =
        simulated(maker.make(), bench_of({{hour, {{0, true}}}}, {0, hour, 2 * hour}));
    CHECK(output.find("time_ms,y\n0,1\n") != std::string::npos);
    CHECK(output.find("The netlist does not settle.\n") != std::string::npos);
    CHECK(output.find("\n3600000,") == std::string::npos);
}

TEST_CASE("the test bench notices that it stands after the netlist") {
    ToolRunner tools;
    tools.write("netlist.v", write_verilog(latch_without_modes()));
    tools.write("bench.v", write_verilog_bench(latch_without_modes(), idle_bench()));
    CHECK(tools.run("iverilog -o run netlist.v bench.v").status == 0);
    CHECK(tools.run("vvp -n run").output.find("The test bench must stand before the netlist.") ==
          0);
}

TEST_CASE("helpers and blocks do not clash with the name of the GRAFCET") {
    Netlist netlist = clocked_sample();
    netlist.name = "grafwire_dff";
    const std::string text = write_verilog(netlist);
    CHECK(text.find("\nmodule grafwire_dff #(") != std::string::npos);
    CHECK(text.find("\nmodule grafwire__dff #(") != std::string::npos);
    CHECK(simulated(netlist, bench_of({{0, {{0, true}}}}, {0})) ==
          "time_ms,X1,late,later\n0,0,0,0\n");
}

TEST_CASE("an output that shares its net") {
    NetlistMaker maker("shared");
    maker.input("a").output("X1").cell(CellType::inverter, "X1", {"a"});
    Netlist netlist = maker.make();
    netlist.outputs.push_back({"copy", netlist.outputs[0].net});
    netlist.outputs.push_back({"through", netlist.inputs[0].net});
    CHECK(simulated(netlist, bench_of({{ms, {{0, true}}}}, {0, ms})) ==
          "time_ms,X1,copy,through\n0,1,1,0\n1,0,0,1\n");
}

TEST_CASE("a large netlist is cut into blocks and does the same") {
    const Netlist ring = nand_ring(450);
    const std::string text = write_verilog(ring);
    CHECK(text.find("\nmodule ring$block3 #(") != std::string::npos);
    CHECK(text.find("\nmodule ring$block4 ") == std::string::npos);
    // The token goes on at every change: a and b in turn.
    std::vector<Stimuli::Change> changes;
    std::vector<Time> instants{0};
    for (std::uint32_t i = 1; i <= 449; ++i) {
        const bool a = i % 2 == 1;
        changes.push_back({i * ms, {{0, a}, {1, !a}}});
        instants.push_back(i * ms);
    }
    const std::string output = simulated(ring, bench_of(changes, instants));
    for (std::size_t i = 0; i <= 449; ++i) {
        std::string row = "\n" + std::to_string(i);
        for (std::size_t step = 0; step < 450; ++step) row += step == i ? ",1" : ",0";
        CHECK(output.find(row + "\n") != std::string::npos);
    }
}

TEST_CASE("parameters and initial values reach into the blocks") {
    NetlistMaker maker("many");
    maker.input("a").input("clk");
    for (int i = 0; i < 201; ++i) {
        const std::string x = "X" + std::to_string(i);
        maker.output(x);
        maker.module(x).cell(CellType::scan_timer, x, {"a", "clk"}, Logic::zero, {20 * ms, 0, 0});
    }
    const Netlist netlist = maker.make();
    std::string off;
    std::string on;
    for (int i = 0; i < 201; ++i) {
        off += ",0";
        on += ",1";
    }
    const std::string output = simulated(
        netlist, bench_of({{0, {{0, true}}}}, {0, 5 * ms, 10 * ms, 15 * ms, 20 * ms}), 5 * ms);
    CHECK(output.find("\n15" + off + "\n20" + on + "\n") != std::string::npos);
}

TEST_CASE("Yosys finds a clocked netlist whole and makes logic of it") {
    ToolRunner tools;
    tools.write("netlist.v", write_verilog(clocked_sample()));
    const auto result = tools.run(
        "yosys -q -p 'read_verilog netlist.v; hierarchy -check -top clocked; proc; flatten; check "
        "-assert; "
        "synth; check -assert; stat'");
    CHECK(result.output == "");
    CHECK(result.status == 0);
}

TEST_CASE("Yosys reads asynchronous netlists, what knows of time as black boxes") {
    ToolRunner tools;
    tools.write("netlist.v", write_verilog(all_asynchronous_cells()));
    CHECK(tools
              .run("yosys -q -p 'read_verilog netlist.v; hierarchy -check -top all_cells; proc; "
                   "check'")
              .status == 0);
}
