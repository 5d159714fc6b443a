// Charts that depend on the order in which their transitions clear, in the style handshake: what is
// said of them, and --interlock.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/json_schema.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// A step that is passed through, and a graph that reads it.
constexpr const char* passing =
    "grafcet passing\n"
    "input a, b\n"
    "graph G {\n"
    "  initial 1\n"
    "  step 2\n"
    "  step 3\n"
    "  1 -> 2 : a\n"
    "  2 -> 3 : 1  # at once\n"
    "  3 -> 1 : /a\n"
    "}\n"
    "graph H {\n"
    "  initial 11\n"
    "  step 12\n"
    "  step 13\n"
    "  11 -> 12 : X2 . b\n"
    "  12 -> 13 : X3\n"
    "  13 -> 11 : X1\n"
    "}\n";

struct Passing {
    ScratchFolder folder;
    std::string chart = folder.file("passing.grafcet", passing);

    Ran ran(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin() + 1, chart);
        return grafwire_with(arguments);
    }
};

}  // namespace

TEST_CASE("a netlist of a chart that depends on order is written with a warning") {
    const Passing passing_chart;
    const Ran ran = passing_chart.ran({"netlist", "--style", "handshake", "--to", "blif"});
    CHECK(ran.status == 0);
    CHECK(contains(ran.out, ".model passing"));
    CHECK(contains(ran.err,
                   "passing.grafcet:8:3: warning: under some delays of its gates the wiring may "
                   "not do what the chart does: (1) 2 -> 3 and (3) 11 -> 12 can be cleared at the "
                   "same moment"));
    CHECK(contains(ran.err,
                   "passing.grafcet:15:3: note: situation in the end: {3, 13} if they "
                   "are cleared together, {3, 11} otherwise"));
    CHECK(contains(ran.err, "note: stimuli that lead there: 0s : a=1 b=1; 0s : end\n"));
    CHECK(contains(ran.err,
                   "(1) 2 -> 3 waits until (3) 11 -> 12 has been cleared or cannot be: "
                   "its receptivity is /X11 + /b"));
    CHECK(passing_chart.ran({"netlist", "--style", "nand", "--to", "blif"}).err.empty());
}

TEST_CASE("with the interlock there is nothing to warn of, and the file says what was added") {
    const Passing passing_chart;
    const Ran ran =
        passing_chart.ran({"netlist", "--style", "handshake", "--to", "blif", "--interlock"});
    CHECK(ran.status == 0);
    CHECK(ran.err ==
          "1 interlock added to the chart:\n"
          "  (1) 2 -> 3 waits until (3) 11 -> 12 has been cleared or cannot be: its "
          "receptivity is /X11 + /b\n");
    CHECK(contains(ran.out, "--to blif --interlock\n"));
    CHECK(contains(ran.out, "# The chart has got these interlocks:\n#   (1) 2 -> 3 waits until "));
}

TEST_CASE("a check says that the chart depends on order, beside the verdict") {
    const Passing passing_chart;
    const Ran ran = passing_chart.ran({"check", "--style", "handshake", "--delay", "any"});
    CHECK(ran.status == 1);
    CHECK(contains(ran.out, "passing.grafcet: different (style handshake, CDX successor)"));
    CHECK(contains(ran.out,
                   "Remark: the chart itself depends on the order in which its "
                   "transitions clear."));
    CHECK(contains(ran.out, "its receptivity is /X11 + /b"));
    // With all gates alike it holds; the remark stands there as well.
    const Ran alike = passing_chart.ran({"check", "--style", "handshake"});
    CHECK(alike.status == 0);
    CHECK(contains(alike.out, "Remark: the chart itself depends on the order"));
    const Ran french = passing_chart.ran({"check", "--style", "handshake", "--lang", "fr"});
    CHECK(contains(french.out,
                   "Remarque\u00a0: le grafcet lui-même dépend de l'ordre de ses "
                   "franchissements."));
}

TEST_CASE("the verdict on an interlocked chart is not one on the chart of the file") {
    const Passing passing_chart;
    const Ran ran =
        passing_chart.ran({"check", "--style", "handshake", "--delay", "any", "--interlock"});
    CHECK(ran.status == 0);
    CHECK(contains(ran.out, "passing.grafcet with interlocks: equivalent (style handshake"));
    CHECK(contains(ran.out,
                   "compared with the chart of the file and these interlocks, not with "
                   "that chart itself:\n    (1) 2 -> 3 waits until "));
    CHECK(contains(ran.out, "in all, the chart comes with them to what it came to without"));
    CHECK(!contains(ran.out, "Remark: the chart itself"));
    // Among several it stands in the table as well, of the style that it is for.
    const Ran several =
        passing_chart.ran({"check", "--style", "nand,handshake", "--delay", "any", "--interlock"});
    CHECK(contains(several.err, "passing.grafcet with interlocks  handshake  "));
    CHECK(!contains(several.err, "passing.grafcet with interlocks  nand"));
}

TEST_CASE("the reports for programs have races and interlocks") {
    const Passing passing_chart;
    const auto orders_of = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--to", "json"});
        const Ran ran = passing_chart.ran(arguments);
        CHECK(schema_problems(ran.out) == "");
        const auto json = nlohmann::json::parse(ran.out, nullptr, false);
        REQUIRE(json.is_object());
        return json.value("orders", nlohmann::json());
    };
    const auto found = orders_of({"check", "--style", "handshake"});
    REQUIRE(found["races"].size() == 1);
    CHECK(found["races"][0]["kind"] == "withdrawn");
    CHECK(found["races"][0]["first"] == "1");
    CHECK(found["races"][0]["second"] == "3");
    CHECK(found["races"][0]["stimuli"] == "0s : a=1 b=1\n0s : end\n");
    CHECK(found["interlocks"].empty());
    CHECK(found["complete"] == true);
    const auto cured = orders_of({"check", "--style", "handshake", "--interlock"});
    CHECK(cured["races"].empty());
    REQUIRE(cured["interlocks"].size() == 1);
    CHECK(cured["interlocks"][0]["condition"] == "/X11 + /b");
    CHECK(orders_of({"check", "--style", "nand"}).is_null());
    const Ran junit = passing_chart.ran(
        {"check", "--style", "handshake", "--delay", "any", "--interlock", "--to", "junit"});
    CHECK(contains(junit.out, "handshake successor interlock"));
}

TEST_CASE("a simulation with the interlock comes to what the chart comes to") {
    const Passing passing_chart;
    const std::string stimuli = passing_chart.folder.file("a.stim", "0ms : a=1 b=1\n+1s : end\n");
    const Ran ran = grafwire_with(
        {"simulate", passing_chart.chart, stimuli, "--style", "handshake", "--interlock"});
    CHECK(ran.status == 0);
    CHECK(ran.out == grafwire_with({"run", passing_chart.chart, stimuli}).out);
    CHECK(contains(ran.err, "1 interlock added to the chart:"));
}

TEST_CASE("fmt writes the interlocked chart, with all else as it was") {
    const Passing passing_chart;
    const Ran ran = passing_chart.ran({"fmt", "--interlock"});
    CHECK(ran.status == 0);
    std::string expected = passing_chart.ran({"fmt"}).out;
    const std::size_t at = expected.find("2 -> 3 : 1 ");
    REQUIRE(at != std::string::npos);
    expected.replace(at, 11, "2 -> 3 : /X11 + /b ");
    // Blanks before the comment follow the longest line.
    const auto squeezed = [](std::string text) {
        std::string result;
        for (const char c : text) {
            if (c != ' ' || result.empty() || result.back() != ' ') result += c;
        }
        return result;
    };
    CHECK(squeezed(ran.out) == squeezed(expected));
    CHECK(contains(ran.err, "1 interlock added to the chart:"));
    const Ran again = grafwire_with({"fmt", "--interlock", "-"}, ran.out);
    CHECK(again.out == ran.out);
    CHECK(contains(again.err, "no interlock was added"));
}

TEST_CASE("what no interlock helps against is said") {
    const ScratchFolder folder;
    const std::string chart = folder.file(
        "mutual.grafcet",
        "input a, b\ngraph G {\n  initial 1\n  step 2\n  step 3\n  1 -> 2 : a . X11\n"
        "  2 -> 3 : b\n  3 -> 1 : /b\n}\ngraph H {\n  initial 11\n  step 12\n  step 13\n"
        "  11 -> 12 : a . X1\n  12 -> 13 : b\n  13 -> 11 : /b\n}\n");
    const Ran ran = grafwire_with({"netlist", chart, "--style", "handshake", "--to", "blif"});
    CHECK(ran.status == 0);
    CHECK(contains(ran.err, "no interlock was found that helps"));
    const Ran asked =
        grafwire_with({"netlist", chart, "--style", "handshake", "--to", "blif", "--interlock"});
    CHECK(contains(asked.err, "no interlock was found that helps"));
    CHECK(contains(asked.err, "interlocks do not help against all"));
}

TEST_CASE("--interlock is for the style handshake") {
    const Passing passing_chart;
    for (const char* style : {"nand", "clocked"}) {
        const Ran ran = passing_chart.ran({"check", "--style", style, "--interlock"});
        CHECK(ran.status == 2);
        CHECK(contains(ran.err, "--interlock has no effect here: "));
    }
}

}  // namespace grafwire::testing
