// What is told of a difference: a student's wrong wiring, and each known cause once.

#include <algorithm>

#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "check/netlist_witness.h"
#include "check/told_witness.h"
#include "explain/explain.h"
#include "explain/tell_witness.h"
#include "formats/blif/read_blif.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

using Fault = Explanation::Fault;

/// A chart, a netlist that differs from it, and why.
struct Told {
    Grafcet grafcet;
    Netlist netlist;
    Witness witness;
    Explanation explanation;

    std::string text(Language language = Language::english, std::size_t most_links = 0) const {
        return tell_witness(grafcet, netlist, witness, explanation, {language, most_links, {}});
    }
    const Explanation::Part& part(const std::string& name) const {
        const auto found = std::find_if(explanation.parts.begin(), explanation.parts.end(),
                                        [&](const auto& part) { return part.name == name; });
        REQUIRE(found != explanation.parts.end());
        return *found;
    }
    std::string cause() const {
        return explanation.cause ? std::string(identifier_of(explanation.cause->kind)) : "";
    }
};

Told told_of(const std::string& chart, Netlist netlist, Changes changes = Changes::one) {
    Grafcet grafcet = grafcet_of(chart);
    const CellDelays delays = unit_delays(netlist);
    CheckOptions options;
    options.changes = changes;
    const CheckResult result = check_equivalence(grafcet, netlist, delays, options);
    REQUIRE(result.witness);
    Explanation explanation = explain(grafcet, netlist, delays, *result.witness);
    return {std::move(grafcet), std::move(netlist), *result.witness, std::move(explanation)};
}

Told told_of_blif(const std::string& chart, const std::string& blif,
                  Changes changes = Changes::one) {
    Diagnostics diagnostics;
    auto netlist = read_blif({"wiring.blif", blif}, diagnostics);
    REQUIRE(netlist);
    adopt_ports(grafcet_of(chart), *netlist);
    return told_of(chart, std::move(*netlist), changes);
}

Told told_in(const std::string& chart, Style style) {
    return told_of(chart, netlist_of(grafcet_of(chart), style));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

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

const Explanation::EquationPair& equation(const Explanation::Part& part, const std::string& name) {
    const auto found = std::find_if(part.equations.begin(), part.equations.end(),
                                    [&](const auto& pair) { return pair.name == name; });
    REQUIRE(found != part.equations.end());
    return *found;
}

Logic operand(const Explanation::EquationPair& pair, const std::string& name) {
    const auto found = std::find_if(pair.operands.begin(), pair.operands.end(),
                                    [&](const auto& item) { return item.name == name; });
    REQUIRE(found != pair.operands.end());
    return found->value;
}

/// Every link but those at which it begins follows from links before it.
void check_chain(const Explanation& explanation) {
    REQUIRE_FALSE(explanation.chain.empty());
    CHECK(explanation.chain.front().is_begin);
    std::vector<std::string> changed;
    for (const Explanation::Link& link : explanation.chain) {
        for (const std::string& cause : link.causes) {
            CHECK(std::find(changed.begin(), changed.end(), cause) != changed.end());
        }
        changed.push_back(link.net);
    }
}

const std::vector<std::string> nothing;

}  // namespace

TEST_CASE("a wiring by hand is right in all its ways") {
    Diagnostics diagnostics;
    auto netlist = read_blif({"wiring.blif", wiring}, diagnostics);
    REQUIRE(netlist);
    const Grafcet grafcet = grafcet_of(chart);
    adopt_ports(grafcet, *netlist);
    const CheckResult result = check_equivalence(grafcet, *netlist, unit_delays(*netlist), {});
    CHECK(result.verdict == Verdict::equivalent);
}

TEST_CASE("a reset that lacks a term") {
    const Told told =
        told_of_blif(chart, replaced(wiring, ".names X2 X3 X1 h1\n001 1", ".names X3 X1 h1\n01 1"));
    const Explanation::Part& part = told.part("X1");
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
    CHECK(told.part("P").follows_from == std::vector<std::string>{"X1"});
    CHECK(told.cause().empty());
    check_chain(told.explanation);
    // What should have reset it came about, and did not help.
    CHECK(told.explanation.chain.back().net == "X2");
    CHECK(told.explanation.chain.back().value == Logic::one);
    CHECK(told.text().find(R"(Where they part:
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
    CHECK(told.text(Language::french).find(R"(Où ils se séparent :
  X1 : la référence donne 0, le câblage 1
    CAX1 = X0.m   avec X0=0 m=1
    CDX1 = X2 + X3   avec X2=1 X3=0
    dans le câblage CDX1 = X3 ; il y manque X2
    cela se décide à +4 ns
    ses portes : lignes 17, 19, 21
  P : la référence donne 0, le câblage 1
    cela découle de X1
Comment on en arrive là, porte par porte :
  +1 ns  porte OU X1 (ligne 21) monte, dès le départ
)") != std::string::npos);
}

TEST_CASE("a reset by another step than the one that follows") {
    const Told told = told_of_blif(chart, replaced(wiring, ".names X1 s0 r0", ".names X2 s0 r0"));
    const auto& cdx = equation(told.part("X0"), "CDX0");
    CHECK(cdx.expected == "X1");
    CHECK(cdx.got == "X2");
    CHECK(cdx.missing == std::vector<std::string>{"X1"});
    CHECK(cdx.extra == std::vector<std::string>{"X2"});
}

TEST_CASE("a term that should not be there") {
    const Told told = told_of_blif(chart, replaced(wiring, ".names X1 a X4 X2 X2\n11-- 1\n--01 1",
                                                   ".names X1 a X4 X2 b X2\n11--1 1\n--01- 1"));
    const Explanation::Part& part = told.part("X2");
    const auto& cax = equation(part, "CAX2");
    CHECK(cax.got == "X1.a.b");
    CHECK(cax.extra == std::vector<std::string>{"b"});
    CHECK(cax.missing == nothing);
    CHECK(operand(cax, "b") == Logic::zero);
    CHECK(equation(part, "CDX2").is_same);
    CHECK(told.part("X1").follows_from == std::vector<std::string>{"X2"});
    // What is wrong by itself comes first.
    CHECK(told.explanation.parts.front().name == "X2");
}

TEST_CASE("AND in place of OR") {
    const Told told =
        told_of_blif(chart, replaced(wiring, "X2 X3 X1 h1\n001 1", "X2 X3 X1 h1\n0-1 1\n-01 1"));
    const auto& cdx = equation(told.part("X1"), "CDX1");
    CHECK(cdx.got == "X2.X3");
    CHECK(cdx.missing == nothing);
    CHECK(cdx.extra == nothing);
}

TEST_CASE("a wrong output") {
    const Told told = told_of_blif(chart, replaced(wiring, "X1 X4 P\n00 0", "X1 X4 P\n11 1"));
    REQUIRE(told.explanation.parts.size() == 1);
    const Explanation::Part& part = told.part("P");
    CHECK_FALSE(part.is_step);
    CHECK(part.fault == Fault::equation);
    const auto& action = equation(part, "P");
    CHECK(action.expected == "X1 + X4");
    CHECK(action.got == "X1.X4");
    CHECK(operand(action, "X1") == Logic::one);
    CHECK(operand(action, "X4") == Logic::zero);
    CHECK(part.lines == std::vector<std::uint32_t>{40});
}

TEST_CASE("an output that no equation can be read off is told by its name") {
    // P is a latch of gates instead of X1 + X4.
    const Told told = told_of_blif(
        chart, replaced(wiring, ".names X1 X4 P\n00 0\n",
                        ".names X1 X4 p0\n00 0\n.names p0 kept P\n00 0\n.names P m kept\n11 1\n"));
    const Explanation::Part& part = told.part("P");
    CHECK(part.fault == Fault::unread);
    CHECK(equation(part, "P").expected == "X1 + X4");
    CHECK(told.text().find("P") != std::string::npos);
}

TEST_CASE("the way is told from the change that began it, however long it is") {
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
    const auto witness = replay(grafcet, netlist, unit_delays(netlist), *stimuli, 0);
    REQUIRE(witness);
    const Explanation explanation = explain(grafcet, netlist, unit_delays(netlist), *witness);
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
    const std::string all = tell_witness(grafcet, netlist, *witness, explanation, {});
    const std::string last =
        tell_witness(grafcet, netlist, *witness, explanation, {Language::english, 3, {}});
    CHECK(lines_of(all).size() == lines_of(last).size() + chain.size() - 3 - 1);
    CHECK(last.find("  … " + std::to_string(chain.size() - 3) +
                    " links before these stand in witness.txt\n") != std::string::npos);
    CHECK(all.find("witness.txt") == std::string::npos);
}

TEST_CASE("cause: a loop of two steps in the successor form") {
    const Told told = told_in(R"(
input s, r
graph G { initial 1 step 2
  1 -> 2 : s./r
  2 -> 1 : r })",
                              Style::gates);
    CHECK(told.cause() == "two-step-loop");
    CHECK(told.text().find("Cause:\n  X1 and X2 follow each other.") != std::string::npos);
    CHECK(told.text(Language::french).find("Cause :\n  X1 et X2 se suivent l'une l'autre.") !=
          std::string::npos);
    check_chain(told.explanation);
}

TEST_CASE("cause: two tokens side by side in the successor form") {
    const std::string two_tokens = R"(
input a, b, c
graph G { initial 1 initial 2 step 3
  (12) 1 -> 2 : a
  (23) 2 -> 3 : b
  (31) 3 -> 1 : c })";
    const Told told = told_in(two_tokens, Style::nand);
    CHECK(told.cause() == "two-tokens");
    CHECK(cause_text(*told.explanation.cause, Language::english) ==
          "X1 is reset by a second token: X2 is active already, and in the successor form of CDX "
          "that resets X1 although transition (12) has not been cleared.");
    CHECK(operand(equation(told.part("X1"), "CDX1"), "X2") == Logic::one);
    CHECK(told.explanation.chain.back().net == "X1");
    CHECK(told.explanation.chain.back().value == Logic::zero);
    // What is said to help does.
    const Grafcet grafcet = grafcet_of(two_tokens);
    const Equations equations = equations_from(grafcet, {CdxForm::transition, true});
    Diagnostics diagnostics;
    const auto netlist = netlist_from(grafcet, equations, Style::nand, diagnostics);
    REQUIRE(netlist);
    CHECK(check_equivalence(grafcet, *netlist, unit_delays(*netlist), {}).verdict ==
          Verdict::equivalent);
}

TEST_CASE("cause: a pulse that outlives its transition") {
    const std::string twice = R"(
input a
graph G { initial 0 step 1 step 2
  (0) 0 -> 1 : ↑a
  (1) 1 -> 2 : ↑a
  (2) 2 -> 0 : /a })";
    Netlist netlist = netlist_of(grafcet_of(twice), Style::nand);
    for (Timing& timing : netlist.timings) timing.fall = 9 * nanosecond;
    const Told told = told_of(twice, std::move(netlist));
    CHECK(told.cause() == "long-pulse");
    CHECK(cause_text(*told.explanation.cause, Language::french) ==
          "L'impulsion de ↑a dure plus longtemps que le passage par X1 : elle vaut encore 1 quand "
          "la transition (0) a activé X1, et fait franchir aussi (1).");
    CHECK(told.explanation.chain.front().net == "a");
}

TEST_CASE("cause: deactivation wins") {
    const Told told = told_in(R"(
input s, k
graph G { step 1 initial 2
  -> 1 : s
  1 -> 2 : 1
  2 -> : k })",
                              Style::nor);
    CHECK(told.cause() == "reset-priority");
    CHECK(told.explanation.parts.front().fault == Fault::priority);
    CHECK(equation(told.explanation.parts.front(), "CAX1").is_same);
}

TEST_CASE("cause: a memory of gates set and reset together, then let go") {
    const Told told = told_of_blif(R"(
input a
graph G { initial 1 initial 2 step 3
  1 -> 2 : ↑a
  2 -> 3 : ↑a
  3 -> 1 : /a })",
                                   R"(.model latches
.inputs a
.outputs X1 X2 X3
#@initially X1 1
#@initially X2 1
#@initially X3 0
#@initially q1 0
#@initially q2 0
#@initially q3 1
.subckt grafwire_rise_pulse a=a q=p
.attr FALL "2ns"
.names a n
0 1
.names X3 n s1
11 0
.names X1 p r1
11 0
.names s1 q1 X1
11 0
.names r1 X1 q1
11 0
.names X1 p s2
11 0
.names X2 p r2
11 0
.names s2 q2 X2
11 0
.names r2 X2 q2
11 0
.names X2 p s3
11 0
.names X3 n r3
11 0
.names s3 q3 X3
11 0
.names r3 X3 q3
11 0
.end
)");
    CHECK(told.witness.kind == DifferenceKind::oscillation);
    CHECK(told.cause() == "set-and-reset");
    // The netlist was read to have the transition form.
    CHECK(equation(told.part("X2"), "CDX2").expected == "X2.↑a");
    CHECK(told.part("X2").fault == Fault::no_fault);
    CHECK(told.text().find("does not settle. These keep changing:\n  NAND gate X2\n") !=
          std::string::npos);
    check_chain(told.explanation);
}

TEST_CASE("cause: a follower that has gone on before the reset can act") {
    // Step 1 falls late, through eight buffers, so that step 2 is still being set as 3 passes.
    std::string buffers;
    for (int i = 0; i < 8; ++i) {
        buffers += ".names " + (i == 0 ? "X2" : "d" + std::to_string(i)) + " d" +
                   std::to_string(i + 1) + "\n1 1\n";
    }
    std::string blif = R"(.model slow
.inputs a b
.outputs X1 X2 X3 X4 X7
#@initially X1 1
#@initially X2 0
#@initially X3 0
#@initially X4 0
#@initially X7 1
#@initially q1 0
#@initially q2 1
#@initially q3 1
#@initially q4 1
#@initially q7 0
)";
    struct Latch {
        std::string step;
        std::string set;
        std::string reset;
    };
    const Latch latches[] = {{"1", "X4 b", "d8"},
                             {"2", "X1 a", "X3"},
                             {"3", "X2 X7", "X4"},
                             {"4", "X3", "X1 X7"},
                             {"7", "X4 b", "X3"}};
    for (const auto& [n, set, reset] : latches) {
        blif += ".names " + set + " s" + n + (set.size() > 2 ? "\n11 0\n" : "\n1 0\n");
        blif += ".names " + reset + " s" + n + " r" + n;
        blif += reset.size() > 2 ? "\n111 0\n" : "\n11 0\n";
        blif += ".names s" + n + " q" + n + " X" + n + "\n11 0\n";
        blif += ".names r" + n + " X" + n + " q" + n + "\n11 0\n";
    }
    const Told told = told_of_blif(R"(
input a, b
graph G { initial 1 step 2 step 3 step 4 initial 7
  1 -> 2 : a
  2, 7 -> 3 : =1
  3 -> 4 : =1
  4 -> 1, 7 : b })",
                                   blif + buffers + ".end\n");
    CHECK(told.cause() == "fleeting-follower");
    CHECK(told.explanation.cause->step == "X2");
    CHECK(told.explanation.cause->others == std::vector<std::string>{"X3"});
}

TEST_CASE("cause: inputs that change together and are read together") {
    const Told told = told_of_blif(R"(
input a, b, c
graph G { initial 0 step 1 step 2
  0 -> 1 : a./b
  1 -> 2 : c
  2 -> 0 : b })",
                                   R"(.model race
.inputs a b c
.outputs X0 X1 X2
#@initially X0 1
#@initially X1 0
#@initially X2 0
#@initially q0 0
#@initially q1 1
#@initially q2 1
.names b n1
0 1
.names n1 n2
0 1
.names n2 nb
0 1
.names X2 b s0
11 0
.names X1 r0
0 1
.names s0 q0 X0
11 0
.names r0 X0 q0
11 0
.names X0 a nb s1
111 0
.names X2 r1
0 1
.names s1 q1 X1
11 0
.names r1 X1 q1
11 0
.names X1 c s2
11 0
.names X0 r2
0 1
.names s2 q2 X2
11 0
.names r2 X2 q2
11 0
.end
)",
                                   Changes::many);
    CHECK(told.cause() == "input-race");
    const std::vector<std::string> both{"a", "b"};
    CHECK(told.explanation.cause->others == both);
    CHECK(told.part("X1").fault == Fault::no_fault);
}

TEST_CASE("a wrong equation is no cause of its own, whatever the structure") {
    // A loop of two steps, but the netlist has a wrong receptivity.
    const std::string loop = R"(
input s, r
graph G { initial 1 step 2
  1 -> 2 : s
  2 -> 1 : r })";
    const Told told = told_of(
        loop, netlist_of(grafcet_of(replaced(loop, "1 -> 2 : s", "1 -> 2 : s.r")), Style::nand));
    CHECK(told.cause().empty());
    CHECK(equation(told.part("X2"), "CAX2").got == "X1.s./Init.r");
    CHECK(told.text().find("Cause:") == std::string::npos);
}

TEST_CASE("a clocked netlist: what a flip-flop takes") {
    const std::string three = R"(
input m, a
graph G { initial 0 step 1 step 2
  0 -> 1 : m
  1 -> 2 : a
  2 -> 0 : m })";
    const Told told = told_of(
        three,
        netlist_of(grafcet_of(replaced(three, "1 -> 2 : a", "1 -> 2 : a.m")), Style::clocked));
    CHECK(told.cause().empty());
    const auto& cax = equation(told.part("X2"), "CAX2");
    CHECK(cax.expected == "X1.a./Init");
    CHECK(cax.extra == std::vector<std::string>{"m"});
}

}  // namespace grafwire::testing
