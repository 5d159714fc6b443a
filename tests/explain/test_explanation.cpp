// What an explanation says of a difference: the equations of a student's wrong wiring, and the
// chain through the gates.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "check/netlist_witness.h"
#include "check/report.h"
#include "explain/explained.h"
#include "explain/write_explanation.h"
#include "formats/blif/read_blif.h"

namespace grafwire::testing {

namespace {

using Fault = Explanation::Fault;

const std::string chart = R"(
input m, a, b, c
output P, Q
graph G {
  initial 0
  step 1 : P
  step 2 : Q
  step 3 : Q if c
  step 4 : P, Q
  (0) 0 -> 1 : m
  (1) 1 -> 2 : a
  (2) 1 -> 3 : b./a
  (3) 2 -> 4 : b
  (4) 3 -> 4 : c
  (5) 4 -> 0 : m
})";

// Wired by hand, every step in another way: a latch of NAND gates, AND and OR gates, one cover.
const std::string wiring = R"(.model sequence
.inputs m a b c
.outputs X0 X1 X2 X3 X4 P Q
#@initially X0 1
#@initially X1 0
#@initially X2 0
#@initially X3 0
#@initially X4 0
.names X4 m s0
11 0
.names X1 s0 r0
11 0
.names s0 q0 X0
11 0
.names r0 X0 q0
11 0
.names X0 m s1
11 1
.names X2 X3 X1 h1
001 1
.names s1 h1 X1
00 0
.names X1 a X4 X2 X2
11-- 1
--01 1
.names X1 b a s3
110 1
.names X4 X3 h3
01 1
.names s3 h3 X3
00 0
.names X2 b t3
11 1
.names X3 c t4
11 1
.names X0 X4 h4
01 1
.names t3 t4 h4 X4
000 0
.names X1 X4 P
00 0
.names X3 c q1
11 1
.names X2 q1 X4 Q
000 0
.end
)";

const std::vector<std::string> nothing;

}  // namespace

TEST_CASE("a wiring by hand is right in all its ways") {
    Diagnostics diagnostics;
    auto netlist = read_blif({"wiring.blif", wiring}, diagnostics);
    REQUIRE(netlist);
    const Grafcet grafcet = grafcet_of(chart);
    adopt_ports(grafcet, *netlist);
    const CheckResult result = check_equivalence(grafcet, *netlist, {});
    CHECK(result.verdict == Verdict::equivalent);
}

TEST_CASE("a reset that lacks a term") {
    const Explained explained = explained_blif(
        chart, replaced(wiring, ".names X2 X3 X1 h1\n001 1", ".names X3 X1 h1\n01 1"));
    const Explanation::Part& part = explained.part("X1");
    CHECK(part.fault == Fault::equation);
    const auto& cdx = equation(part, "CDX1");
    CHECK(cdx.expected == "X2 + X3");
    CHECK(cdx.got == "X3");
    CHECK(cdx.missing == std::vector<std::string>{"X2"});
    CHECK(cdx.extra == nothing);
    CHECK(operand(cdx, "X2") == Logic::one);
    CHECK(operand(cdx, "X3") == Logic::zero);
    CHECK(equation(part, "CAX1").is_same);
    // The gates of step 1, in the lines of the file.
    CHECK(part.lines == std::vector<std::uint32_t>{17, 19, 21});
    CHECK(explained.part("P").follows_from == std::vector<std::string>{"X1"});
    CHECK(explained.cause().empty());
    check_chain(explained.explanation);
    // What should have reset it came about, and did not help.
    CHECK(explained.explanation.chain.back().net == "X2");
    CHECK(explained.explanation.chain.back().value == Logic::one);
    CHECK(explained.text().find(R"(Where they part:
  X1: the reference gives 0, the netlist 1
    CAX1 = X0.m   with X0=0 m=1
    CDX1 = X2 + X3   with X2=1 X3=0
    in the netlist CDX1 = X3; it has no X2
    it is decided at +4 ns
    its gates: lines 17, 19, 21
  P: the reference gives 0, the netlist 1
    that follows from X1
How it came about, gate by gate:
  +1 ns  OR gate X1 (line 21) rises, from the start
  +2 ns  AND gate X2$1 (line 23) rises, after X1
  +3 ns  OR gate X2 (line 23) rises, after X2$1
)") != std::string::npos);
    CHECK(explained.text(Language::french).find(R"(Écart constaté :
  X1 : la référence donne 0, le câblage 1
    CAX1 = X0.m   avec X0=0 m=1
    CDX1 = X2 + X3   avec X2=1 X3=0
    dans le câblage, CDX1 = X3 ; il y manque X2
    cela se décide à +4 ns
    ses portes : lignes 17, 19, 21
  P : la référence donne 0, le câblage 1
    cela découle de X1
Comment on en arrive là, porte par porte :
  +1 ns  porte OU X1 (ligne 21) passe à 1, dès le départ
)") != std::string::npos);
}

TEST_CASE("a reset by another step than the one that follows") {
    const Explained explained =
        explained_blif(chart, replaced(wiring, ".names X1 s0 r0", ".names X2 s0 r0"));
    const auto& cdx = equation(explained.part("X0"), "CDX0");
    CHECK(cdx.expected == "X1");
    CHECK(cdx.got == "X2");
    CHECK(cdx.missing == std::vector<std::string>{"X1"});
    CHECK(cdx.extra == std::vector<std::string>{"X2"});
}

TEST_CASE("a term that should not be there") {
    const Explained explained =
        explained_blif(chart, replaced(wiring, ".names X1 a X4 X2 X2\n11-- 1\n--01 1",
                                       ".names X1 a X4 X2 b X2\n11--1 1\n--01- 1"));
    const Explanation::Part& part = explained.part("X2");
    const auto& cax = equation(part, "CAX2");
    CHECK(cax.got == "X1.a.b");
    CHECK(cax.extra == std::vector<std::string>{"b"});
    CHECK(cax.missing == nothing);
    CHECK(operand(cax, "b") == Logic::zero);
    CHECK(equation(part, "CDX2").is_same);
    CHECK(explained.part("X1").follows_from == std::vector<std::string>{"X2"});
    // What is wrong by itself comes first.
    CHECK(explained.explanation.parts.front().name == "X2");
}

TEST_CASE("AND in place of OR") {
    const Explained explained =
        explained_blif(chart, replaced(wiring, "X2 X3 X1 h1\n001 1", "X2 X3 X1 h1\n0-1 1\n-01 1"));
    const auto& cdx = equation(explained.part("X1"), "CDX1");
    CHECK(cdx.got == "X2.X3");
    CHECK(cdx.missing == nothing);
    CHECK(cdx.extra == nothing);
}

TEST_CASE("a wrong output") {
    const Explained explained =
        explained_blif(chart, replaced(wiring, "X1 X4 P\n00 0", "X1 X4 P\n11 1"));
    REQUIRE(explained.explanation.parts.size() == 1);
    const Explanation::Part& part = explained.part("P");
    CHECK_FALSE(part.is_step);
    CHECK(part.fault == Fault::equation);
    const auto& action = equation(part, "P");
    CHECK(action.expected == "X1 + X4");
    CHECK(action.got == "X1.X4");
    CHECK(operand(action, "X1") == Logic::one);
    CHECK(operand(action, "X4") == Logic::zero);
    CHECK(part.lines == std::vector<std::uint32_t>{40});
}

TEST_CASE("an output that no equation can be read off is explained by its name") {
    // P is a latch of gates instead of X1 + X4.
    const Explained explained = explained_blif(
        chart, replaced(wiring, ".names X1 X4 P\n00 0\n",
                        ".names X1 X4 p0\n00 0\n.names p0 kept P\n00 0\n.names P m kept\n11 1\n"));
    const Explanation::Part& part = explained.part("P");
    CHECK(part.fault == Fault::unread);
    CHECK(equation(part, "P").expected == "X1 + X4");
    CHECK(explained.text().find("P") != std::string::npos);
}

TEST_CASE("the way is explained from the change that began it, however long it is") {
    const std::string steps = R"(
input a
output P
graph G {
  initial 0
  step 1 step 2 step 3 step 4 step 5 step 6 step 7 step 8 : P
  0 -> 1 : a
  1 -> 2 : =1
  2 -> 3 : =1
  3 -> 4 : =1
  4 -> 5 : =1
  5 -> 6 : =1
  6 -> 7 : =1
  7 -> 8 : =1
  8 -> 0 : /a
})";
    // The output is left out. At the start the inputs have been what they are since always.
    const Grafcet grafcet = grafcet_of(steps);
    const Netlist netlist = netlist_of(grafcet_of(replaced(steps, "8 : P", "8")), Style::nand);
    const auto stimuli = read_stimuli("0s :\n1s : a=1\n1s : end\n", grafcet);
    REQUIRE(stimuli);
    const auto witness = replay(grafcet, netlist, cell_delays(netlist, {}), *stimuli, 0);
    REQUIRE(witness);
    const Explanation explanation = explain(grafcet, netlist, cell_delays(netlist, {}), *witness);
    check_chain(explanation);
    const auto& chain = explanation.chain;
    CHECK(chain.front().net == "a");
    CHECK(chain.front().cell == no_cell);
    CHECK(chain.back().net == "X8");
    for (int step = 1; step <= 8; ++step) {
        const std::string net = "X" + std::to_string(step);
        CHECK(std::any_of(chain.begin(), chain.end(),
                          [&](const auto& link) { return link.net == net; }));
    }
    // Nothing that does not lie on the way: step 0 falls beside it.
    CHECK(std::none_of(chain.begin(), chain.end(),
                       [](const auto& link) { return link.net == "X0"; }));
    REQUIRE(chain.size() > 8);
    const std::string all = write_explanation(grafcet, netlist, *witness, explanation, {});
    const std::string last =
        write_explanation(grafcet, netlist, *witness, explanation, {Language::english, 3, {}});
    CHECK(lines_of(all).size() == lines_of(last).size() + chain.size() - 3 - 1);
    CHECK(last.find("  … " + std::to_string(chain.size() - 3) +
                    " links before these stand in witness.txt\n") != std::string::npos);
    CHECK(all.find("witness.txt") == std::string::npos);
}

TEST_CASE("a clocked netlist: what a flip-flop takes") {
    const std::string three = R"(
input m, a
graph G { initial 0 step 1 step 2
  0 -> 1 : m
  1 -> 2 : a
  2 -> 0 : m })";
    const Explained explained = explained_netlist(
        three,
        netlist_of(grafcet_of(replaced(three, "1 -> 2 : a", "1 -> 2 : a.m")), Style::clocked));
    CHECK(explained.cause().empty());
    const auto& cax = equation(explained.part("X2"), "CAX2");
    CHECK(cax.expected == "X1.a./Init");
    CHECK(cax.extra == std::vector<std::string>{"m"});
}

}  // namespace grafwire::testing
