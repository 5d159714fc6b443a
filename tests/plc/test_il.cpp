#include <doctest/doctest.h>

#include "plc/check_grammar.h"
#include "plc/il_machine.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/plc_machine.h"

namespace grafwire::testing {

namespace {

const PlcLanguage instruction_list{"il", il_machine, {}};

}  // namespace

TEST_CASE("Instruction List: the examples run like the reference") {
    CHECK(check_examples(instruction_list) == 0);
}

TEST_CASE("Instruction List: random charts run like the reference") {
    check_property(
        [](const RandomCase& item) {
            const auto grafcet = read_grafcet(item.chart);
            return difference(instruction_list, *grafcet, *read_stimuli(item.stimuli, *grafcet),
                              {millisecond, 1500 * microsecond});
        },
        Features(), 940'000, 200);
}

TEST_CASE("Instruction List: programs are texts of the standard") {
    CHECK(check_grammar(instruction_list, "il_block", 940'000) == "");
}

TEST_CASE("Instruction List: conditions, counters and times") {
    const auto grafcet = read_grafcet(R"(grafcet pump
input a, b
counter c : 1..9
graph G {
  initial 1
  step 2 : c := c + 1
  1 -> 2 : /(a . /b) . [c + 1 < 9 - c] + 2s/a
}
)");
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    const std::string text =
        plc_format_named("il")->write(*grafcet, program_from(*grafcet, {false}), {}, diagnostics);
    const auto has = [&](const std::string& part) {
        CHECK_MESSAGE(text.find(part) != std::string::npos, part << " is not in\n" << text);
    };
    has(R"(
(* (0) 1 -> 2 : /(a./b).[c + 1 < 9 - c] + 2s/a *)
    LD    c
    ADD   1
    LT(
      LD    9
      SUB   c
    )
    ST    part_0
    LD    a
    ANDN  b
    NOT
    AND   part_0
    OR    on_2s_a.Q
    ST    T0
)");
    has(R"(
    LD    X1
    AND   T0
    S     Ta_X2
    S     Td_X1
)");
    has(R"(
    LD    Tpulse_X2
    JMPCN kept
    LD    c
    ADD   1
    MIN   9
    ST    c
kept:
)");
    has(R"(
    LD    a
    ST    on_2s_a.IN
    LD    T#2s
    ST    on_2s_a.PT
    CAL   on_2s_a
)");
}

TEST_CASE("Instruction List: the interpreter refuses what is not in the language") {
    const auto grafcet = read_grafcet("graph G { initial 1 }");
    REQUIRE(grafcet);
    const auto run = [&](const std::string& body) {
        const std::string text =
            "FUNCTION_BLOCK b\nVAR_INPUT\na : BOOL;\nEND_VAR\nVAR\nc : INT;\nd : BOOL;\n"
            "t : TON;\nEND_VAR\n" +
            body + "\nEND_FUNCTION_BLOCK\n";
        il_machine(text, *grafcet)->scan(0);
    };
    CHECK_NOTHROW(
        run("LD c\nADD 1\nGT 0\nAND(\nLDN a\n)\nST d\nJMPC over\nLD T#1s\nST t.PT\nCAL t\nover:"));
    for (const char* wrong : {"AND a",
                              "LD a AND d",
                              "LD a\nAND(\nLD d",
                              "LD a\n)",
                              "LD c\nST d",
                              "LD a\nADD 1",
                              "LD 32767\nST c\nLD c\nADD 1",
                              "LD a\nST a",
                              "LD e",
                              "JMP nowhere",
                              "LD a\nLD(\nd\n)",
                              "LD a\nNOP",
                              "LD a\nAND(\nLD d\nOR(\nLD a\nAND d\n)\n)",
                              "LD t",
                              "CAL d",
                              "CAL t(PT := T#1s)",
                              "LD 1\nST t.PT",
                              "LD T#1s\nST t.IN",
                              "LD a\nST t.Q",
                              "LD a;",
                              "again:\nJMP again",
                              "x:\nLD a\nx:"}) {
        CHECK_THROWS_AS_MESSAGE(run(wrong), PlcError, wrong);
    }
}

}  // namespace grafwire::testing
