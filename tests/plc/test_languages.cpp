// What programs look like, what their names become, what is refused, and how they take bad scans.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <stdexcept>

#include "plc/compile.h"
#include "plc/formats.h"
#include "plc/run_language.h"
#include "random/read_text.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::string lift_chart() {
    return text_of(std::string(GRAFWIRE_ROOT) + "/tests/golden/lift.grafcet");
}

std::string messages_of(const std::string& format, const std::string& chart) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    const ScanProgram program = program_from(*grafcet, {});
    Diagnostics diagnostics;
    CHECK(plc_format_named(format)->write(*grafcet, program, {}, diagnostics) == "");
    return format_diagnostics(diagnostics, {"chart", chart});
}

std::string program_of(const std::string& format, const std::string& chart) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    return written(format, *grafcet, program_from(*grafcet, {}));
}

/// `input i0, i1, …`
std::string inputs(std::size_t count) {
    std::string text = "input i0";
    for (std::size_t i = 1; i < count; ++i) text += fmt::format(", i{}", i);
    return text + "\n";
}

std::string steps(std::size_t count) {
    std::string text = "graph G {\n  initial 0\n";
    for (std::size_t s = 1; s < count; ++s) text += fmt::format("  step {}\n", s);
    return text + "}\n";
}

/// Names that are keywords, macros, or differ from each other only in case or accents.
constexpr const char* awkward = R"(
grafcet "main" "*/ { (* ??/"
input "H+", "H-", int, INT, "int_2", end, begin, S1, PB0, unix, in, print, Ïnit, "init", n1
output "class", or1, "record", "a??/"
var and1, lambda
counter "goto" : 0..3
graph G {
  initial "or" : "class"
  step "r" : set and1, "goto" := "goto" + 1
  "or" -> "r" : "H+" . "H-" . int . INT . "int_2" . end . begin . S1 . PB0 + unix
  "r" -> "or" : ↑(in + print) . Ïnit . "init" . 1.5s/and1
}
)";

constexpr const char* awkward_scans = "x\n0.5,1,1,1,1,1,1,1,1,1,0,0,0,0,0,0,0,0,0,9,9\n";

}  // namespace

TEST_CASE("names that a language does not take stand at the head of the file") {
    const auto head_of = [](const std::string& text) {
        const std::size_t from = text.find("Names that are spelt");
        REQUIRE(from != std::string::npos);
        const std::size_t first = text.find('\n', from) + 1;
        return text.substr(first, text.find("\n\n", first) + 1 - first);
    };
    CHECK(head_of(program_of("c", awkward)) == R"(//   H_plus   "H+"
//   H_minus  "H-"
//   int_2    int
//   int_2_2  int_2
//   unix_2   unix
//   Init_2   Ïnit
//   class_2  class
//   a        "a??/"
//   goto_2   goto
)");
    CHECK(head_of(program_of("pascal", awkward)) == R"(//   H_plus    "H+"
//   H_minus   "H-"
//   INT_2     INT
//   int_2_2   int_2
//   end_2     end
//   begin_2   begin
//   in_2      in
//   Init_2    Ïnit
//   init_3    init
//   class_2   class
//   record_2  record
//   a         "a??/"
//   goto_2    goto
//   Xor_2     Xor
)");
    CHECK(head_of(program_of("python", awkward)) == R"(#   H_plus    "H+"
#   H_minus   "H-"
#   in_2      in
#   Init_2    Ïnit
#   class_2   class
#   a         "a??/"
#   lambda_2  lambda
)");
    const std::string arduino = program_of("arduino", awkward);
    CHECK(arduino.find("const uint8_t in_S1 = 9;") != std::string::npos);
    CHECK(arduino.find("const uint8_t in_PB0_2 = 10;") != std::string::npos);
}

TEST_CASE("names of buttons and breakers stay in the languages of controllers") {
    const std::string chart =
        "input S1, Q, \"épais\"\noutput KM1\n"
        "graph G { initial 0 : KM1 if S1 . Q . \"épais\" }\n";
    CHECK(
        contains(program_of("st", chart), "KM1 := Ts[X0] AND S1 AND Q AND epais AND NOT AUdoux;"));
    CHECK(contains(program_of("plcopen", chart), "<variable name=\"S1\">"));
    // There S1 is an operator as well.
    CHECK(contains(program_of("il", chart), "(*   S1_2 is S1 *)\n(*   epais is épais *)\n"));
}

TEST_CASE("programs with awkward names compile and run") {
    const ScratchFolder folder;
    const std::string c = folder.file("c.c", program_of("c", awkward));
    compile({"gcc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-DGRAFWIRE_MAIN", c,
             "-o", folder.path("c")});
    compile({"g++", "-Wall", "-Wextra", "-Werror", "-DGRAFWIRE_MAIN", "-x", "c++", c, "-o",
             folder.path("cpp")});
    compile({"fpc", "-v0e", folder.file("p.pas", program_of("pascal", awkward)),
             "-o" + folder.path("p")});
    const std::string python = folder.file("p.py", program_of("python", awkward));
    const std::vector<std::vector<std::string>> commands = {
        {folder.path("c")}, {folder.path("cpp")}, {folder.path("p")}, {"/usr/bin/python3", python}};
    for (const std::vector<std::string>& command : commands) {
        CHECK(run_on(command, {awkward_scans}).front() ==
              "time_ms,H+,H-,int,INT,int_2,end,begin,S1,PB0,unix,in,print,Ïnit,init,n1,Init,AUdur,"
              "AUdoux,Xor,Xr,class,or1,record,a?\?/,and1,lambda,goto\n"
              "0.5,1,1,1,1,1,1,1,1,1,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,1,0,1\n");
    }
}

TEST_CASE("scans that make no sense end a program with the number of the line") {
    const std::string chart = "input a\noutput l\ngraph G { initial 0 : l if a }\n";
    const ScratchFolder folder;
    compile({"gcc", "-DGRAFWIRE_MAIN", folder.file("c.c", program_of("c", chart)), "-o",
             folder.path("c")});
    compile({"fpc", "-v0e", folder.file("p.pas", program_of("pascal", chart)),
             "-o" + folder.path("p")});
    const std::string python = folder.file("p.py", program_of("python", chart));
    const std::vector<std::vector<std::string>> commands = {
        {folder.path("c")}, {folder.path("p")}, {"/usr/bin/python3", python}};
    for (const std::vector<std::string>& command : commands) {
        for (const std::string& bad :
             std::vector<std::string>{"1,1,0,0\n", "x,1,0,0,0\n", "0.0001,1,0,0,0\n",
                                      "1.2.3,1,0,0,0\n", "1,2,0,0,0\n", "\n", "-1,1,0,0,0\n"}) {
            INFO(command.back() << " on " << bad);
            const Ran ran = run_program(command, "x\n0,0,0,0,0\n" + bad);
            CHECK(ran.status == 1);
            CHECK(ran.err == "line 3: expected a moment in ms, whole in us, and 4 inputs\n");
            CHECK(contains(ran.out, "\n0,0,0,0,0,1,0\n"));
        }
    }
}

TEST_CASE("without modes there are no control inputs") {
    const LanguageRunner run = [](const Grafcet& grafcet, const ScanProgram& program,
                                  const std::vector<std::string>& scans) {
        const std::string text = written("c", grafcet, program);
        CHECK_FALSE(contains(text, "bool Init"));
        const ScratchFolder folder;
        compile({"gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-DGRAFWIRE_MAIN",
                 folder.file("c.c", text), "-o", folder.path("c")});
        return run_on({folder.path("c")}, scans);
    };
    const RandomCase lift = {
        lift_chart(),
        "0ms : crate=0\n20ms : crate=1\n50ms : top=1\n2s : top=0 crate=0\n"
        "2100ms : crate=1 top=1\n+10ms : \"arrêt\"=1\n+50ms : int=1\n+1s : end\n"};
    CHECK(compare_with_reference(lift, run, true, {false}) == "");
}

TEST_CASE("what a language cannot hold is an error with its place") {
    CHECK(messages_of("pascal", steps(257)) ==
          "chart:258:8: error: this is step 257 of 257, and a set of Free Pascal holds 256; write "
          "--to c or --to python\n  step 256\n       ^\n");
    CHECK(program_of("pascal", steps(256)) != "");
    CHECK(messages_of("arduino", inputs(66) + steps(1)) ==
          "chart: error: 69 inputs and outputs need a pin each, and the largest board, an Arduino "
          "Mega 2560, has 68; write --to c and connect them by yourself, or --modes off to save "
          "three\n");
    CHECK(program_of("arduino", inputs(65) + steps(1)) != "");
}

TEST_CASE("sums beyond 64 bits are refused where integers have no more") {
    const std::string chart = "counter c : 0..1\ngraph G {\n  initial 0 : c := c + 1\n}\n";
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    ScanProgram program = program_from(*grafcet, {});
    // More than a chart can say in a reasonable length.
    for (Statement& statement : program.sections[static_cast<std::size_t>(SectionKind::stored)]) {
        statement.sum.push_back({false, SumTerm::no_counter, INT64_MAX});
    }
    for (const char* format : {"c", "arduino", "pascal"}) {
        Diagnostics diagnostics;
        CHECK(plc_format_named(format)->write(*grafcet, program, {}, diagnostics) == "");
        const std::string messages = format_diagnostics(diagnostics, {"chart", chart});
        INFO(messages);
        CHECK(contains(messages, "chart:3:15: error: this sum can go beyond the 64 bits"));
    }
    CHECK(contains(written("python", *grafcet, program),
                   "self.counters.c + 1 + 9223372036854775807"));
}

}  // namespace grafwire::testing
