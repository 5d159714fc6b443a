// Each known cause of a difference, once, and what is none.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "explain/explained.h"
#include "explain/write_explanation.h"

namespace grafwire::testing {

namespace {

using Fault = Explanation::Fault;

}  // namespace

TEST_CASE("cause: a loop of two steps in the successor form") {
    const Explained explained = explained_style(R"(
input s, r
graph G { initial 1 step 2
  1 -> 2 : s./r
  2 -> 1 : r })",
                                                Style::gates);
    CHECK(explained.cause() == "two-step-loop");
    CHECK(explained.text().find("Cause:\n  X1 and X2 follow each other.") != std::string::npos);
    CHECK(explained.text(Language::french).find("Cause :\n  X1 et X2 se suivent l'une l'autre.") !=
          std::string::npos);
    check_chain(explained.explanation);
}

TEST_CASE("cause: a step that follows itself in the successor form") {
    const Explained explained = explained_style(R"(
input a, b
graph G { initial 0 step 1 step 2
  0 -> 1 : a
  1 -> 1 : ↑X1
  1 -> 2 : b
  2 -> 0 : /a./b })",
                                                Style::gates);
    REQUIRE(explained.cause() == "two-step-loop");
    CHECK(explained.explanation.cause->step == "X1");
    CHECK(explained.explanation.cause->others == std::vector<std::string>{"X1"});
}

TEST_CASE("a cause names all the steps that take part") {
    const Cause cause{CauseKind::two_step_loop, "X1", {"X2", "X3", "X4"}, {}};
    CHECK(cause_text(cause, Language::english)
              .starts_with("X1 and X2, X3 and X4 follow each other. "));
    CHECK(cause_text(cause, Language::french)
              .starts_with("X1 et X2, X3 et X4 se suivent l'une l'autre. "));
}

TEST_CASE("cause: two tokens side by side in the successor form") {
    const std::string two_tokens = R"(
input a, b, c
graph G { initial 1 initial 2 step 3
  (12) 1 -> 2 : a
  (23) 2 -> 3 : b
  (31) 3 -> 1 : c })";
    const Explained explained = explained_style(two_tokens, Style::nand);
    CHECK(explained.cause() == "two-tokens");
    CHECK(cause_text(*explained.explanation.cause, Language::english) ==
          "X1 is reset by a second token: X2 is active already, and in the successor form of CDX "
          "that resets X1 although transition (12) has not been cleared.");
    CHECK(operand(equation(explained.part("X1"), "CDX1"), "X2") == Logic::one);
    CHECK(explained.explanation.chain.back().net == "X1");
    CHECK(explained.explanation.chain.back().value == Logic::zero);
    // What is said to help does.
    const Grafcet grafcet = grafcet_of(two_tokens);
    const Equations equations = equations_from(grafcet, {CdxForm::transition, true});
    Diagnostics diagnostics;
    const auto netlist = netlist_from(grafcet, equations, Style::nand, diagnostics);
    REQUIRE(netlist);
    CHECK(check_equivalence(grafcet, *netlist, {}).verdict == Verdict::equivalent);
}

TEST_CASE("cause: two tokens, behind the second of two transitions") {
    const Explained explained = explained_style(R"(
input a, b, c, d
graph G { initial 1 initial 2 step 3
  (10) 1 -> : d . b
  (12) 1 -> 2 : a
  (23) 2 -> 3 : b
  (31) 3 -> 1 : c })",
                                                Style::nand);
    CHECK(explained.cause() == "two-tokens");
    CHECK(cause_text(*explained.explanation.cause, Language::english).find("(12)") !=
          std::string::npos);
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
    const Explained explained = explained_netlist(twice, std::move(netlist));
    CHECK(explained.cause() == "long-pulse");
    CHECK(cause_text(*explained.explanation.cause, Language::french) ==
          "L'impulsion de ↑a dure plus longtemps que le passage par X1 : elle vaut encore 1 quand "
          "la transition (0) a activé X1, et fait franchir aussi (1).");
    CHECK(explained.explanation.chain.front().net == "a");
}

TEST_CASE("cause: deactivation wins") {
    const Explained explained = explained_style(R"(
input s, k
graph G { step 1 initial 2
  -> 1 : s
  1 -> 2 : 1
  2 -> : k })",
                                                Style::nor);
    CHECK(explained.cause() == "reset-priority");
    CHECK(explained.explanation.parts.front().fault == Fault::priority);
    CHECK(equation(explained.explanation.parts.front(), "CAX1").is_same);
}

TEST_CASE("cause: deactivation wins, in each step that two loops share") {
    // In the transition form of CDX one equation would be wrong instead of two memories.
    const Explained explained = explained_style(R"(
input init, freeze
graph Orders { initial 90 step 91 step 92
  90 -> 91 : ↑init
  91 -> 90 : 1
  90 -> 92 : freeze
  92 -> 90 : /freeze })",
                                                Style::nor);
    CHECK(explained.cause() == "reset-priority");
    for (const Explanation::Part& part : explained.explanation.parts) {
        CHECK(part.fault == Fault::priority);
        CHECK(equation(part, "CAX" + part.name.substr(1)).is_same);
    }
}

TEST_CASE("cause: a memory of gates set and reset together, then let go") {
    const Explained explained = explained_blif(R"(
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
    CHECK(explained.witness.kind == DifferenceKind::oscillation);
    CHECK(explained.cause() == "set-and-reset");
    // The netlist was read to have the transition form.
    CHECK(equation(explained.part("X2"), "CDX2").expected == "X2.↑a");
    CHECK(explained.part("X2").fault == Fault::no_fault);
    CHECK(explained.text().find("does not settle. These keep changing:\n  NAND gate X2\n") !=
          std::string::npos);
    check_chain(explained.explanation);
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
    const Explained explained = explained_blif(R"(
input a, b
graph G { initial 1 step 2 step 3 step 4 initial 7
  1 -> 2 : a
  2, 7 -> 3 : =1
  3 -> 4 : =1
  4 -> 1, 7 : b })",
                                               blif + buffers + ".end\n");
    CHECK(explained.cause() == "fleeting-follower");
    CHECK(explained.explanation.cause->step == "X2");
    CHECK(explained.explanation.cause->others == std::vector<std::string>{"X3"});
}

TEST_CASE("cause: inputs that change together and are read together") {
    const Explained explained = explained_blif(R"(
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
    CHECK(explained.cause() == "input-race");
    const std::vector<std::string> both{"a", "b"};
    CHECK(explained.explanation.cause->others == both);
    CHECK(explained.part("X1").fault == Fault::no_fault);
}

TEST_CASE("a wrong equation is no cause of its own, whatever the structure") {
    // A loop of two steps, but the netlist has a wrong receptivity.
    const std::string loop = R"(
input s, r
graph G { initial 1 step 2
  1 -> 2 : s
  2 -> 1 : r })";
    const Explained explained = explained_netlist(
        loop, netlist_of(grafcet_of(replaced(loop, "1 -> 2 : s", "1 -> 2 : s.r")), Style::nand));
    CHECK(explained.cause().empty());
    CHECK(equation(explained.part("X2"), "CAX2").got == "X1.s./Init.r");
    CHECK(explained.text().find("Cause:") == std::string::npos);
}

}  // namespace grafwire::testing
