// The grammar of IEC 61131-3 takes what is in the standard and nothing else.

#include <doctest/doctest.h>

#include "support/iec_grammar.h"

namespace grafwire::testing {

namespace {

std::string block(const std::string& body) {
    return "FUNCTION_BLOCK b\nVAR_INPUT\na, b : BOOL;\nEND_VAR\nVAR CONSTANT\nn : INT := -1;\n"
           "END_VAR\nVAR (* its bits *)\nd : ARRAY[0..3] OF BOOL;\nt : TON;\nEND_VAR\n" +
           body + "\nEND_FUNCTION_BLOCK\n";
}

bool fits(const char* start, const std::string& body) {
    return misfit_in_iec(block(body), start).empty();
}

bool is_chart(const std::string& body) {
    return misfit_in_iec("PROGRAM p\n" + body + "\nEND_PROGRAM\n", "sfc_program").empty();
}

}  // namespace

TEST_CASE("the grammar of Structured Text") {
    CHECK(fits("st_block", ""));
    CHECK(fits("st_block", "d[n] := NOT a AND (b OR n + 1 >= 2);; t(IN := a, PT := T#0.3ms);"));
    CHECK(fits("st_block",
               "FOR n := 0 TO 3 DO IF a THEN d[n] := t.Q; ELSE RETURN; END_IF; END_FOR;"));
    CHECK(fits("st_block", "n := LIMIT(-1, n - 2 * 3, 9); CASE n OF 1, 3..4: a := b; END_CASE;"));
    for (const char* wrong :
         {"d := a", "d = a;", "a := NOT NOT b;", "IF a THEN b := a; END_IF", "a__b := a;",
          "a_ := b;", "end_if := a;", "a := T#5;", "a := T#300us;", "a := (b;", "a := b; (* end",
          "a := 3a;", "FOR n := 0 DO END_FOR;", "a := b AND;"}) {
        CHECK_MESSAGE(!fits("st_block", wrong), wrong);
    }
    CHECK(misfit_in_iec(block("\nd = a;"), "st_block") == "line 13: '=' does not fit");
    CHECK(misfit_in_iec("FUNCTION_BLOCK b\n", "st_block") == "the text ends too early");
}

TEST_CASE("the grammar of Instruction List") {
    CHECK(fits("il_block", "LD a\nANDN b\n\n(* a word *)\nST d"));
    CHECK(fits("il_block",
               "LD n\nADD 1\nMAX -3\nGT(\nLD 2\nADD n\n)\nAND( a\nOR b\n)\nJMPC over\nover:"));
    CHECK(fits("il_block", "again: LD T#1.5s\nST t.PT\nCAL t\nCAL t(\nIN := a,\nPT := T#1s\n)"));
    CHECK(fits("il_block", "LD a\nOR(\nLD b\nAND(\nLD a\n)\n)\nNOT\nRETC"));
    for (const char* wrong :
         {"LD a AND b", "LD", "CAL t(PT := T#1s)", "LD a\nLD(\nd\n)", "NOP", "LD a;", "a := b;",
          "LD a\nAND(\nLD b", "LD a\n)", "LD a OR b", "JMP 3", "CAL", "LD LD"}) {
        CHECK_MESSAGE(!fits("il_block", wrong), wrong);
    }
}

TEST_CASE("the grammar of sequential function charts") {
    const std::string steps =
        "INITIAL_STEP X1:\nEND_STEP\nSTEP X2: lamp(D, T#5s); act(P1);\nEND_STEP\n";
    CHECK(is_chart(steps));
    CHECK(is_chart(steps + "ACTION act: a := X1.X; END_ACTION\n"
                           "TRANSITION FROM X1 TO (X2, X3) := a AND b; END_TRANSITION\n"
                           "INITIAL_STEP X4: s(S); END_STEP\n"));
    for (const char* wrong :
         {"ACTION act: END_ACTION\n", "ACTION act: (* a *) END_ACTION\n",
          "TRANSITION FROM X1 TO := a; END_TRANSITION\n",
          "TRANSITION FROM X1 TO X2 := a END_TRANSITION\n",
          "TRANSITION FROM (X1) TO X2 := a; END_TRANSITION\n", "STEP X3: lamp(D); END_STEP\n"}) {
        CHECK_MESSAGE(!is_chart(steps + wrong), wrong);
    }
    CHECK_FALSE(is_chart("STEP X1: END_STEP"));
}

}  // namespace grafwire::testing
