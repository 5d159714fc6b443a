// grafwire report: what stands on the page, and what is refused.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "command/charts.h"
#include "support/files.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::string report_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "report");
    const Ran ran = grafwire_with(arguments);
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    return ran.out;
}

}  // namespace

TEST_CASE("a report holds drawing, equations, schematic, run and the verdict on every style") {
    const std::string page = report_of({rule_5_chart, rule_5_stimuli});
    for (const char* id :
         {"chart", "names", "equations", "schematic", "run", "verdicts", "warnings", "source"}) {
        INFO("section: " << id);
        CHECK(count_of(page, "<section id=\"" + std::string(id) + "\">") == 1);
        CHECK(count_of(page, "href=\"#" + std::string(id) + "\"") == 1);
    }
    for (const std::string& style : choices_of("netlist", "--style")) {
        INFO("style: " << style);
        CHECK(contains(page, "<td>\n<code>" + style + "</code>"));
    }
    CHECK(count_of(page, "<strong class=\"equivalent\">") >= 3);
    // The difference of the NOR latch, in words and as a picture with both runs.
    const std::size_t nor = page.find("<section id=\"style-nor\">");
    REQUIRE(nor != page.npos);
    CHECK(page.find("<strong class=\"different\">", nor) < page.find("</section>", nor));
    CHECK(page.find("<svg ", nor) < page.find("</section>", nor));
    CHECK(page.find("Witness:", nor) < page.find("</section>", nor));
}

TEST_CASE("a report is XML as well, loads nothing, and links to what it holds") {
    const ScratchFolder folder;
    for (const std::string& name : example_names()) {
        INFO("chart: " << name);
        const std::string path = folder.path("report.html");
        REQUIRE(
            grafwire_with({"report", example(name + ".grafcet"), "--max-cases", "300", "-o", path})
                .status == 0);
        CHECK(run_program({"xmllint", "--noout", path}).status == 0);
        const std::string page = text_of(path);
        for (const char* loading : {"src=", "<link", "<script", "@import", "url("}) {
            CHECK_FALSE(contains(page, loading));
        }
        for (std::size_t at = page.find("href=\"#"); at != page.npos;
             at = page.find("href=\"#", at + 1)) {
            const std::size_t begin = at + 7;
            const std::string id = page.substr(begin, page.find('"', begin) - begin);
            CHECK_MESSAGE(count_of(page, " id=\"" + id + "\"") == 1, id);
        }
        // Each picture is called by ids of its own.
        for (std::size_t at = page.find("aria-labelledby=\""); at != page.npos;
             at = page.find("aria-labelledby=\"", at + 1)) {
            const std::size_t begin = at + 17;
            const std::size_t middle = page.find(' ', begin);
            const std::string title = page.substr(begin, middle - begin);
            const std::string text = page.substr(middle + 1, page.find('"', begin) - middle - 1);
            CHECK_MESSAGE(count_of(page, "<title id=\"" + title + "\">") == 1, title);
            CHECK_MESSAGE(count_of(page, "<desc id=\"" + text + "\">") == 1, text);
        }
    }
}

TEST_CASE("the same chart gives the same report, wherever it stands") {
    const ScratchFolder folder;
    const std::string chart = folder.file("rule-5.grafcet", text_of(rule_5_chart));
    const std::string stimuli = folder.file("rule-5.stim", text_of(rule_5_stimuli));
    CHECK(report_of({chart, stimuli}) == report_of({rule_5_chart, rule_5_stimuli}));
}

TEST_CASE("the schematic of a report is of the style and in the symbols asked for") {
    const std::string iec = report_of({sequence_chart, "--style", "nand"});
    CHECK(contains(iec, "Schematic, style nand"));
    const std::string us = report_of({sequence_chart, "--style", "nand", "--symbols", "us"});
    CHECK(count_of(us, "class=\"cell") == count_of(iec, "class=\"cell"));
    CHECK(us != iec);
}

TEST_CASE("a check that is given up is undecided in the report, whose status is 0") {
    const std::string page = report_of({rule_5_chart, "--max-cases", "1"});
    CHECK(contains(page, "<strong class=\"undecided\">"));
}

TEST_CASE("a report in French has no English in it") {
    const std::string page = report_of({rule_5_chart, rule_5_stimuli, "--lang", "fr"});
    CHECK(contains(page, "lang=\"fr\""));
    CHECK(contains(page, "<h2>Sommaire</h2>"));
    // The text of the chart is its author's.
    const std::string ours = page.substr(0, page.find("<section id=\"source\">"));
    const std::size_t body = ours.find("<body>");
    CHECK_FALSE(contains(ours.substr(body), "Contents"));
    CHECK_FALSE(contains(ours.substr(body), "equivalent</strong>"));
}

TEST_CASE("bad input gives no report") {
    const ScratchFolder folder;
    const std::string out = folder.path("report.html");
    const std::string wrong = folder.file("wrong.grafcet", "grafcet w\ngraph G {\n  step\n}\n");
    const Ran ran = grafwire_with({"report", wrong, "-o", out});
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, "wrong.grafcet:4:1: error"));
    CHECK_FALSE(std::filesystem::exists(out));
    const std::string chart = folder.file("rule-5.grafcet", text_of(rule_5_chart));
    CHECK(grafwire_with({"report", chart, "-o", chart}).status == 2);
    CHECK(text_of(chart) == text_of(rule_5_chart));
}

}  // namespace grafwire::testing
