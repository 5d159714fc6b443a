// The equations of the worked examples, in the spelling of the course.

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/csv.h"
#include "support/run_program.h"
#include "text/utf8.h"

namespace grafwire::testing {

namespace {

std::string equations(const std::string& name, std::vector<std::string> options) {
    options.insert(options.begin(), {"equations", example(name + ".grafcet"), "--to", "csv"});
    const Ran ran = grafwire_with(options);
    CHECK(ran.status == 0);
    CHECK(!contains(ran.err, "error"));
    return ran.out;
}

}  // namespace

TEST_CASE("known answers: the selections and the simultaneous sequences, without modes") {
    const std::vector<std::string> off{"--modes", "off"};
    const std::string divergence = equations("selection-divergence", off);
    CHECK(contains(divergence, "\nX7,X6.a,X10 + X20,"));
    CHECK(contains(divergence, "\nX10,X7.x,X11,"));
    CHECK(contains(divergence, "\nX20,X7.z,X21,"));
    const std::string convergence = equations("selection-convergence", off);
    CHECK(contains(convergence, "\nX31,X30.b,X6,"));
    CHECK(contains(convergence, "\nX48,X47.c,X6,"));
    CHECK(contains(convergence, "\nX6,X31.d + X48.e,X7,"));
    const std::string split = equations("parallel-divergence", off);
    CHECK(contains(split, "\nX7,X6.a,X10.X20,"));
    CHECK(contains(split, "\nX10,X7.x,X11,"));
    CHECK(contains(split, "\nX20,X7.x,X21,"));
    const std::string join = equations("parallel-convergence", off);
    CHECK(contains(join, "\nX31,X30.b,X6,"));
    CHECK(contains(join, "\nX48,X47.c,X6,"));
    CHECK(contains(join, "\nX6,X31.X48.d,X7,"));
}

TEST_CASE("known answers: the single sequence, with modes, the whole file") {
    CHECK(equations("single-sequence", {}) ==
          "variable,CAX,CDX,X\n"
          "X0,X2.b + Init,X1./Init,(X2.b + /X1.X0 + Init)./AUdur\n"
          "X1,X0.m./Init,X2 + Init,(X0.m + /X2.X1)./Init./AUdur\n"
          "X2,X1.a./Init,X0 + Init,(X1.a + /X0.X2)./Init./AUdur\n");
}

TEST_CASE("known answers: the exercise of nine steps, with modes, the whole file") {
    CHECK(equations("nine-steps", {}) ==
          "variable,CAX,CDX,X\n"
          "X1,X4.X8 + Init,X2.X5./Init,(X4.X8 + /(X2.X5).X1 + Init)./AUdur\n"
          "X2,X1.m./Init,X3 + Init,(X1.m + /X3.X2)./Init./AUdur\n"
          "X3,X2.b./Init,X4 + Init,(X2.b + /X4.X3)./Init./AUdur\n"
          "X4,X3.c./Init,X1 + Init,(X3.c + /X1.X4)./Init./AUdur\n"
          "X5,X1.m./Init,X6 + Init,(X1.m + /X6.X5)./Init./AUdur\n"
          "X6,X5.a./Init,X7 + X9 + Init,(X5.a + /(X7 + X9).X6)./Init./AUdur\n"
          "X7,X6.d1./Init,X8 + Init,(X6.d1 + /X8.X7)./Init./AUdur\n"
          "X8,(X7.e + X9.f)./Init,X1 + Init,(X7.e + X9.f + /X1.X8)./Init./AUdur\n"
          "X9,X6.d2./Init,X8 + Init,(X6.d2 + /X8.X9)./Init./AUdur\n"
          "A,,,X3./AUdoux\n");
}

TEST_CASE("the transition form, without modes") {
    const std::string text = equations("nine-steps", {"--cdx", "transition", "--modes", "off"});
    CHECK(contains(text, "\nX1,X4.X8,X1.m,X4.X8 + /(X1.m).X1\n"));
    CHECK(contains(text, "\nX6,X5.a,X6.d1 + X6.d2,X5.a + /(X6.d1 + X6.d2).X6\n"));
    CHECK(contains(text, "\nA,,,X3\n"));
}

TEST_CASE("a sink has no follower to wait for") {
    CHECK(contains(equations("rule-5", {"--modes", "off"}), "\nX2,X1,X2.k,"));
}

TEST_CASE("CSV has a row per step in the order of the file, then one per output") {
    for (const std::string& name : example_names()) {
        INFO("example: " << name);
        const std::string info = equations(name, {});
        const auto rows = read_csv(info);
        const auto trace = read_csv(
            grafwire_with({"run", example(name + ".grafcet"), example(name + ".stim")}).out);
        REQUIRE(!trace.empty());
        CHECK(rows.front() == CsvRow{"variable", "CAX", "CDX", "X"});
        // The trace has the same names in the same order, behind AUdoux.
        std::size_t column = 0;
        while (trace[0][column] != "AUdoux") ++column;
        REQUIRE(column + rows.size() <= trace[0].size());
        for (std::size_t i = 1; i < rows.size(); ++i) {
            REQUIRE(rows[i].size() == 4);
            CHECK(rows[i][0] == trace[0][column + i]);
            CHECK(!rows[i][3].empty());
        }
    }
}

TEST_CASE("the other forms") {
    const std::vector<std::string> request{"equations", example("nine-steps.grafcet"), "--to"};
    const auto in_form = [&](const std::string& form) {
        std::vector<std::string> arguments = request;
        arguments.push_back(form);
        const Ran ran = grafwire_with(arguments);
        CHECK(ran.status == 0);
        return ran.out;
    };
    const auto json = nlohmann::json::parse(in_form("json"), nullptr, false);
    CHECK(!json.is_discarded());
    CHECK(contains(in_form("markdown"), "| "));
    CHECK(contains(in_form("latex"), "\\overline"));
    CHECK(in_form("text") == grafwire_with({"equations", example("nine-steps.grafcet")}).out);
    const Ran karnaugh =
        grafwire_with({"equations", example("single-sequence.grafcet"), "--karnaugh"});
    CHECK(karnaugh.status == 0);
    CHECK(karnaugh.out.size() >
          grafwire_with({"equations", example("single-sequence.grafcet")}).out.size());
    const Ran fragment = grafwire_with(
        {"equations", example("single-sequence.grafcet"), "--to", "latex", "--karnaugh"});
    const Ran document =
        grafwire_with({"--lang", "fr", "equations", example("single-sequence.grafcet"), "--to",
                       "latex", "--karnaugh", "--standalone"});
    CHECK(!contains(fragment.out, "\\documentclass"));
    CHECK(contains(document.out, "\\usepackage[french]{babel}"));
    CHECK(document.out.rfind("\\end{document}\n") == document.out.size() - 15);
}

TEST_CASE("equations and info warn of what wiring may get wrong, in the form asked for") {
    const std::string warning = ": warning: steps 1 and 2 can be active together: with --cdx ";
    const std::string chart = example("rule-5.grafcet");
    const Ran successor = grafwire_with({"equations", chart, "--to", "csv"});
    CHECK(contains(successor.err, warning));
    CHECK(successor.status == 0);
    const Ran transition =
        grafwire_with({"equations", chart, "--to", "csv", "--cdx", "transition"});
    CHECK_FALSE(contains(transition.err, warning));
    const Ran info = grafwire_with({"info", chart});
    CHECK(contains(info.err, warning));
    CHECK(info.status == 0);
    // The other commands have their own say.
    CHECK_FALSE(contains(grafwire_with({"plc", chart, "--to", "st"}).err, warning));
    CHECK(grafwire_with({"info", example("nine-steps.grafcet")}).err.empty());
}

TEST_CASE("the text fits a terminal of 80 columns on every example") {
    for (const std::string& name : example_names()) {
        const Ran ran = grafwire_with({"equations", example(name + ".grafcet"), "--karnaugh"});
        CHECK(ran.status == 0);
        std::istringstream lines(ran.out);
        for (std::string line; std::getline(lines, line);) {
            CAPTURE(line);
            CHECK(std::count_if(line.begin(), line.end(), begins_character) <= 80);
        }
    }
}

}  // namespace grafwire::testing
