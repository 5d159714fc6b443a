// What the gates do at each instant, in words.

#include <doctest/doctest.h>

#include "check/compare_ports.h"
#include "explain/gate_story.h"
#include "explain/write_gate_story.h"
#include "formats/blif/read_blif.h"
#include "support/small_netlists.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

const std::string told_chart = R"(
input a, b
output P
graph G {
  initial 0
  step 1 : P
  step 2
  (0) 0 -> 1 : a
  (1) 1 -> 2 : 2s/X1
  (2) 2 -> 0 : b
})";

std::string told(const Grafcet& grafcet, const Netlist& netlist, const std::string& stimuli,
                 Time scan_period = 0, Language language = Language::english) {
    Diagnostics diagnostics;
    const auto read = parse_stimuli({"s", stimuli}, grafcet, diagnostics);
    REQUIRE(read);
    SimulateOptions options;
    options.scan_period = scan_period;
    const auto simulation =
        tell_simulation(grafcet, netlist, cell_delays(netlist, {}), *read, options);
    CHECK(simulation.result.trace.row_count() > 0);
    return write_gate_stories(grafcet, netlist, simulation.stories, language);
}

std::string told(Style style, Time scan_period = 0, Language language = Language::english) {
    const Grafcet grafcet = grafcet_of(told_chart);
    return told(grafcet, netlist_of(grafcet, style), "1s : a=1\n4s : a=0 b=1\n5s : end\n",
                scan_period, language);
}

}  // namespace

TEST_CASE("from inputs and ends of delays through the gates to steps and outputs") {
    CHECK(told(Style::nand) == R"(At 0 ms: all inputs are 0
  stable situation after 1 ns: X0
  outputs at 1: none

At 1000 ms: a=1
  X1 becomes 1 after 2 ns: a=1, NAND gate X1$set0=0 (+1 ns)
  P becomes 1 after 3 ns: X1=1
  X0 becomes 0 after 5 ns: X1=1, NAND gate X0$reset0=0 (+3 ns), NAND gate X0$q=1 (+4 ns)
  stable situation after 6 ns: X1
  outputs at 1: P

At 3000 ms: the delay of 2s/X1 is over
  X2 becomes 1 after 2 ns: timer X1$timer0=1 (+0 ns), NAND gate X2$set1=0 (+1 ns)
  X1 becomes 0 after 5 ns: X2=1, NAND gate X1$reset0=0 (+3 ns), NAND gate X1$q=1 (+4 ns)
  P becomes 0 after 6 ns: X1=0
  stable situation after 6 ns: X2
  outputs at 1: none

At 4000 ms: a=0 b=1
  X0 becomes 1 after 2 ns: b=1, NAND gate X0$set2=0 (+1 ns)
  X2 becomes 0 after 5 ns: X0=1, NAND gate X2$reset0=0 (+3 ns), NAND gate X2$q=1 (+4 ns)
  stable situation after 6 ns: X0
  outputs at 1: none

At 5000 ms: nothing changes
)");
}

TEST_CASE("gates in French") {
    const std::string text = told(Style::nand, 0, Language::french);
    CHECK(text.find("X1 passe à 1 au bout de 2 ns : a=1, porte NON-ET X1$set0=0 (+1 ns)\n") !=
          std::string::npos);
    CHECK(text.find("À 3000 ms : la temporisation 2s/X1 est écoulée\n") != std::string::npos);
    CHECK(text.find("situation stable au bout de 6 ns : X2\n") != std::string::npos);
}

TEST_CASE("gates scan by scan") {
    const std::string text = told(Style::clocked, second / 2);
    CHECK(text.find("From 1500 ms to 3000 ms: nothing changes (4 scans)\n") != std::string::npos);
    CHECK(text.find("At 3500 ms: no input changes\n"
                    "  X1 becomes 0 after 2 ns: clk=1\n"
                    "  X2 becomes 1 after 2 ns: clk=1\n") != std::string::npos);
    CHECK(text.find("  situation: X2\n") != std::string::npos);
}

TEST_CASE("nets that keep changing, and outputs that are undefined") {
    const Grafcet grafcet = grafcet_of("input a\noutput P\ngraph G { initial 0 : P if a }");
    Diagnostics diagnostics;
    auto netlist = read_blif({"ring.blif",
                              ".model ring\n.inputs a\n.outputs X0 P\n.names X0 a X0\n11 0\n"
                              ".names P a P\n11 1\n.end\n"},
                             diagnostics);
    REQUIRE(netlist);
    adopt_ports(grafcet, *netlist);
    CHECK(told(grafcet, *netlist, "1s : a=1\n2s : end\n") == R"(At 0 ms: all inputs are 0
  stable situation: X0
  outputs at 1: none

At 1000 ms: a=1
  the netlist does not settle: X0 keep changing
)");
}

TEST_CASE("a long way and a wide instant are cut short") {
    std::string text = "input a\noutput ";
    for (int i = 0; i < 15; ++i) text += (i == 0 ? "P" : ", P") + std::to_string(i);
    text += "\ngraph G {\n  initial 0\n  step 1 : ";
    for (int i = 0; i < 15; ++i) text += (i == 0 ? "P" : ", P") + std::to_string(i);
    text += "\n  (0) 0 -> 1 : a\n  (1) 1 -> 0 : /a\n}";
    const Grafcet wide = grafcet_of(text);
    CHECK(told(wide, netlist_of(wide, Style::clocked), "1s : a=1\n2s : end\n")
              .find("  … and 5 more steps and outputs change\n") != std::string::npos);

    std::string wires = ".model long\n.inputs a\n.outputs X0 P\n.names X0\n1\n";
    std::string from = "a";
    for (int i = 1; i <= 12; ++i) {
        const std::string to = i == 12 ? "P" : "n" + std::to_string(i);
        wires += ".names " + from + " " + to + "\n1 1\n";
        from = to;
    }
    const Grafcet grafcet = grafcet_of("input a\noutput P\ngraph G { initial 0 : P if a }");
    Diagnostics diagnostics;
    auto netlist = read_blif({"long.blif", wires + ".end\n"}, diagnostics);
    REQUIRE(netlist);
    adopt_ports(grafcet, *netlist);
    CHECK(told(grafcet, *netlist, "1s : a=1\n2s : end\n")
              .find("  P becomes 1 after 12 ns: a=1, …, buffer n5=1 (+5 ns), ") !=
          std::string::npos);
}

}  // namespace grafwire::testing
