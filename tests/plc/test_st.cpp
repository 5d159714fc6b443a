#include <doctest/doctest.h>

#include "plc/check_grammar.h"
#include "plc/st_machine.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/plc_machine.h"

namespace grafwire::testing {

namespace {

const PlcLanguage structured_text{"st", st_machine, {}};

}  // namespace

TEST_CASE("Structured Text: the examples run like the reference") {
    CHECK(check_examples(structured_text) == 0);
}

TEST_CASE("Structured Text: random charts run like the reference") {
    check_property(
        [](const RandomCase& item) {
            const auto grafcet = read_grafcet(item.chart);
            return difference(structured_text, *grafcet, *read_stimuli(item.stimuli, *grafcet),
                              {millisecond, 1500 * microsecond});
        },
        Features(), 930'000, 200);
}

TEST_CASE("Structured Text: programs are texts of the standard") {
    CHECK(check_grammar(structured_text, "st_block", 930'000) == "");
}

TEST_CASE("Structured Text: times, limits and names") {
    const auto grafcet = read_grafcet(R"(grafcet "for" "Essai"
input "V+", v
output "sortie é"
counter c : 0..9
graph G {
  initial 1
  step 2 : "sortie é" if 2min/"V+"/1.5s, c := c + 1
  1 -> 2 : ↑v . 250us/(v + "V+")
}
)");
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    const std::string text =
        plc_format_named("st")->write(*grafcet, program_from(*grafcet, {false}), {}, diagnostics);
    const auto has = [&](const std::string& part) {
        CHECK_MESSAGE(text.find(part) != std::string::npos, part << " is not in\n" << text);
    };
    has("(* for: Essai *)\n");
    has("(*   V_plus is V+ *)\n(*   sortie_e is sortie é *)\n(*   for_2 is for *)\n");
    has("FUNCTION_BLOCK for_2\nVAR_INPUT\n    V_plus : BOOL;\n    v : BOOL;\nEND_VAR\n");
    has("    c : INT;  (* 0..9 *)\n");
    has("(* (0) 1 -> 2 : ↑v . 250us/(v + \"V+\") *)\nTt[T0] := rise_v AND on_250us_1.Q;\n");
    has("IF Ts[X1] AND Tt[T0] THEN\n    Ta[X2] := TRUE;\n    Td[X1] := TRUE;\nEND_IF;\n");
    has("IF Tpulse[X2] THEN\n    c := LIMIT(0, c + 1, 9);\nEND_IF;\n");
    has("on_250us_1(IN := v OR V_plus, PT := T#0.25ms);\n");
    has("on_2min_V_plus_1_5s(IN := V_plus AND NOT time_2min_V_plus_1_5s, PT := T#2m);\n"
        "off_2min_V_plus_1_5s(IN := NOT V_plus AND time_2min_V_plus_1_5s, PT := T#1.5s);\n");
    CHECK(text.find("Init") == std::string::npos);
    CHECK(text.find("Tf1[") == std::string::npos);
}

TEST_CASE("Structured Text: the interpreter refuses what is not in the language") {
    const auto grafcet = read_grafcet("graph G { initial 1 }");
    REQUIRE(grafcet);
    const auto run = [&](const std::string& body) {
        const std::string text =
            "FUNCTION_BLOCK b\nVAR_INPUT\na : BOOL;\nEND_VAR\nVAR\nc : INT;\nd : BOOL;\n"
            "Ts : ARRAY[0..0] OF BOOL;\nt : TON;\nEND_VAR\n" +
            body + "\nEND_FUNCTION_BLOCK\n";
        st_machine(text, *grafcet)->scan(0);
    };
    CHECK_NOTHROW(
        run("d := NOT a OR a AND (c + 1 > 0); t(IN := d, PT := T#1h30m); c := LIMIT(0, 3, 2);"));
    for (const char* wrong : {"d = a;",
                              "d := a",
                              "IF a THEN d := a; END_IF",
                              "d := NOT NOT a;",
                              "d := 1;",
                              "c := a;",
                              "c := 32767 + c + 1; c := c + 1;",
                              "a := d;",
                              "e := d;",
                              "d := Ts[1];",
                              "d := Ts;",
                              "d := a AND c;",
                              "t(IN := a, PT := 5);",
                              "d := T#5;",
                              "// a",
                              "d := étape;",
                              "d__e := a;",
                              "d := (* (* *) *) a;",
                              "d := t;",
                              "FOR c := 0 TO 1 DO d := a; END_IF;"}) {
        CHECK_THROWS_AS_MESSAGE(run(wrong), PlcError, wrong);
    }
}

}  // namespace grafwire::testing
