#include <doctest/doctest.h>

#include "plc/awl_machine.h"
#include "plc/long_times.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/plc_machine.h"

namespace grafwire::testing {

namespace {

PlcOptions international() {
    PlcOptions options;
    options.mnemonics = s7::Mnemonics::international;
    return options;
}

const PlcLanguage statement_list{"stl", awl_machine, {}};
const PlcLanguage statement_list_international{"stl", awl_machine_international, international()};

}  // namespace

TEST_CASE("Statement List: the examples run like the reference") {
    CHECK(check_examples(statement_list) == 0);
    CHECK(check_examples(statement_list_international) == 0);
}

TEST_CASE("Statement List: random charts with S5 timers run like the reference") {
    std::size_t refused = 0;
    check_property(
        [&](const RandomCase& item) -> std::string {
            const auto grafcet = read_grafcet(with_long_times(item.chart));
            if (!grafcet) return "the chart with longer times is not read";
            const auto stimuli = ten_times_as_long(*read_stimuli(item.stimuli, *grafcet));
            return difference(statement_list, *grafcet, stimuli,
                              {10 * millisecond, 15 * millisecond}, &refused);
        },
        Features(), 950'000, 200);
    CHECK(refused < case_count(200) / 20);
}

TEST_CASE("Statement List: random charts with IEC timers run like the reference") {
    std::size_t refused = 0;
    check_property(
        [&](const RandomCase& item) {
            const auto grafcet = read_grafcet(item.chart);
            return difference(statement_list_international, *grafcet,
                              *read_stimuli(item.stimuli, *grafcet),
                              {millisecond, 1500 * microsecond}, &refused);
        },
        Features(), 960'000, 200);
    CHECK(refused < case_count(200) / 2);
}

TEST_CASE("Statement List: conditions, counters and times") {
    const auto grafcet = read_grafcet(R"(grafcet pump "Pompe"
input a, b
output p
counter c : 1..9
graph G {
  initial 1
  step 2 : p if 2h/b/300ms, c := c + 1
  1 -> 2 : /(a . /b) . [c + 1 < 9 - c] + a . 1234ms/a
}
)");
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    const std::string text = plc_format_named("stl")->write(
        *grafcet, program_from(*grafcet, {false}), international(), diagnostics);
    const auto has = [&](const std::string& part) {
        CHECK_MESSAGE(text.find(part) != std::string::npos, part << " is not in\n" << text);
    };
    has("//   I 0.1      b\n//   Q 4.0      p\n//   MW 20      c\n//   M 10.0     X1\n");
    has(R"(
      O(;
      AN(;
      A     I 0.0;           // a
      AN    I 0.1;           // b
      );
      A(;
      L     9;
      L     MW 20;           // c
      -I;
      T     MW 26;           // auxiliary
      L     MW 20;           // c
      L     1;
      +I;
      L     MW 26;           // auxiliary
      <I;
      );
      );
      O;
      A     I 0.0;           // a
      A     M 23.1;          // 1.234s/a
      =     M 22.0;          // (0)
)");
    has(R"(
      L     MW 16;
      INVI;
      L     MW 12;
      AW;
      L     MW 14;
      OW;
      T     MW 10;
)");
    has(R"(
      A     I 0.1;           // b
      AN    M 23.0;          // 2h/b/300ms
      L     S5T#2H;
      SD    T 0;
      AN    I 0.1;           // b
      A     M 23.0;          // 2h/b/300ms
      L     S5T#300MS;
      SD    T 1;
      A     T 0;
      S     M 23.0;          // 2h/b/300ms
      A     T 1;
      R     M 23.0;          // 2h/b/300ms
)");
    has(R"(
      CALL  SFB 4, DB 1 (
            IN := M 24.1,
            PT := T#1S234MS,
            Q  := M 24.2);
)");
}

TEST_CASE("Statement List: tables of any length, deep conditions and wide integers run") {
    std::string chart = "input a, b, c\ncounter n : 999999..1000003\ngraph G {\n  initial 0\n";
    for (int step = 1; step < 70; ++step) chart += "  step " + std::to_string(step) + "\n";
    for (int step = 0; step < 70; ++step) {
        chart += "  " + std::to_string(step) + " -> " + std::to_string((step + 1) % 70) + " : " +
                 (step % 2 == 0 ? "↑a" : "b do n := n + 1 - n + n") + "\n";
    }
    std::string deep = "c";
    for (int level = 0; level < 12; ++level) {
        deep = (level % 2 == 0 ? "(a + b . " : "/(c . (") + deep +
               (level % 2 == 0 ? ")" : " ⊕ [n = 1000000]))");
    }
    chart += "  0 -> 69 : " + deep + "\n  69 -> 33 : /" + deep + "\n}\n";
    std::string stimuli;
    for (int at = 0; at < 200; ++at) {
        stimuli += std::to_string(at) + "ms : " + "abc"[at * 7 % 3] + "=" +
                   std::to_string(at * 5 % 11 % 2) + "\n";
    }
    std::string messages;
    const auto grafcet = read_grafcet(chart, &messages);
    REQUIRE_MESSAGE(grafcet, messages);
    const auto read = read_stimuli(stimuli, *grafcet, &messages);
    REQUIRE_MESSAGE(read, messages);
    CHECK(difference(statement_list, *grafcet, *read, {millisecond}) == "");
}

TEST_CASE("Statement List: what an S7-300 cannot hold is refused") {
    const auto refusal = [](const std::string& chart) -> std::string {
        const auto grafcet = read_grafcet(chart);
        REQUIRE(grafcet);
        Diagnostics diagnostics;
        const std::string text =
            plc_format_named("stl")->write(*grafcet, program_from(*grafcet, {}), {}, diagnostics);
        CHECK(text.empty() == diagnostics.has_errors());
        return diagnostics.has_errors() ? diagnostics.items().front().message.english : "";
    };
    CHECK(refusal("input a graph G { initial 1 1 -> 1 : 1500us/a }") ==
          "no timer of an S7-300 or S7-400 holds 1.5ms: S5 timers and the IEC timers count whole "
          "milliseconds, up to 24 days; choose another time");
    CHECK(refusal("input a graph G { initial 1 1 -> 1 : 600h/a }") != "");
    CHECK(refusal("input a graph G { initial 1 1 -> 1 : 590h/a }") == "");
    CHECK(refusal("counter c : 3000000000..3000000001 graph G { initial 1 }") ==
          "an integer needs more than the 32 bits of DINT, the widest of an S7-300 or S7-400; make "
          "the range of the counter smaller");
    CHECK(
        refusal("counter c : 2000000000..2000000001 graph G { initial 1 1 -> 1 : [c + c = 0] }") !=
        "");
}

TEST_CASE("Statement List: inputs and outputs where an assignment puts them") {
    const auto grafcet =
        read_grafcet("input a, b output p graph G { initial 1 : p 1 -> 1 : a . b }");
    REQUIRE(grafcet);
    s7::IoAssignment io;
    s7::IoAssignment::Entry& entry = io.entries.emplace_back();
    entry.name = "b";
    entry.operand.area = s7::Area::input;
    entry.operand.address = 124;
    entry.operand.bit = 3;
    PlcOptions options;
    options.io = &io;
    Diagnostics diagnostics;
    const std::string text = plc_format_named("stl")->write(
        *grafcet, program_from(*grafcet, {false}), options, diagnostics);
    CHECK(text.find("//   E 0.0      a\n//   E 124.3    b\n//   A 4.0      p\n") !=
          std::string::npos);
    CHECK(text.find("      U     E 124.3;         // b\n") != std::string::npos);
    entry.operand.area = s7::Area::variable;
    CHECK(plc_format_named("stl")
              ->write(*grafcet, program_from(*grafcet, {}), options, diagnostics)
              .empty());
    REQUIRE(diagnostics.has_errors());
    CHECK(diagnostics.items().front().message.english ==
          "'b' is to be a bit of the inputs, E0.0 and so on");
}

TEST_CASE("Statement List: the interpreter refuses what STEP 7 would") {
    const auto grafcet = read_grafcet("graph G { initial 1 }");
    REQUIRE(grafcet);
    const auto run = [&](const std::string& body) {
        awl_machine(
            "//   M 10.0     X1\nDATA_BLOCK DB 1\nSFB 4\nBEGIN\nEND_DATA_BLOCK\n"
            "FUNCTION FC 1 : VOID\nBEGIN\n" +
                body +
                "\nEND_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nUC FC 1;\n"
                "END_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB 100\nBEGIN\n"
                "END_ORGANIZATION_BLOCK\n",
            *grafcet)
            ->scan(0);
    };
    CHECK_NOTHROW(
        run("U(;\nO E 0.0;\nO;\nU M 1.2;\n);\n= M 1.0;\nL 5;\nL -3;\n>I;\nSPBN no;\n"
            "L S5T#9S990MS;\nSE T 255;\nno: NOP 0;"));
    for (const char* wrong :
         {"A E 0.0;", "U I 0.0;", "U E 0.0", "U E 0.8;", "= E 0.0;", "L S5T#9S995MS;",
          "L S5T#2H46M40S;", "SE T 256;", "L 40000;", "L 30000;\nL 30000;\n+I;", "SPB here;",
          "SPB label;\nlabel: NOP 0;", ");", "U(;\nU M 0.0;", "LD M 0.0;", "UC FC 2;",
          "U(;\nU(;\nU(;\nU(;\nU(;\nU(;\nU(;\nU(;\nU M 0.0;\n);\n);\n);\n);\n);\n);\n);\n);",
          "T 5;", "here: SPA here;"}) {
        CHECK_THROWS_AS_MESSAGE(run(wrong), PlcError, wrong);
    }
}

}  // namespace grafwire::testing
