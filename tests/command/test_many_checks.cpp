// Several checks in one call, of files and styles: what is planned, what each report says of those
// that were made, skipped or wrong, and that none of it depends on how many run at a time.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "command/charts.h"
#include "command/json_schema.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

const std::string counter_chart = example("batch-counter.grafcet");

std::vector<Json> json_lines(const std::string& text) {
    std::vector<Json> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        INFO("line: " << line);
        CHECK(schema_problems(line) == "");
        lines.push_back(Json::parse(line, nullptr, false));
        REQUIRE(lines.back().is_object());
    }
    return lines;
}

/// `style verdict` of each.
Words verdicts_of(const std::vector<Json>& lines) {
    Words words;
    for (const Json& line : lines) {
        words.push_back(line.at("style").get<std::string>() + " " +
                        line.at("verdict").get<std::string>());
    }
    return words;
}

/// What the table on standard error says in its first four columns, without blanks between them.
Words table_of(const std::string& err) {
    Words rows;
    std::istringstream stream(err);
    bool is_table = false;
    for (std::string line; std::getline(stream, line);) {
        is_table = is_table || line.rfind("File ", 0) == 0;
        if (!is_table) continue;
        std::istringstream words(line);
        Words row;
        for (std::string word; words >> word;) row.push_back(word);
        std::string text;
        for (std::size_t i = 0; i + 1 < row.size(); ++i) text += row[i] + " ";
        rows.push_back(text);
    }
    return rows;
}

/// Whether servers can read it.
void check_junit(const std::string& file) {
    const Ran ran = run_program({"xmllint", "--noout", "--schema",
                                 std::string(GRAFWIRE_ROOT) + "/tests/command/junit.xsd", file});
    INFO(ran.err);
    CHECK(ran.status == 0);
}

Ran in_folder(const ScratchFolder& folder, Words arguments) {
    arguments.insert(arguments.begin(), {"/bin/sh", "-c", "cd \"$1\" && shift && exec \"$@\"", "sh",
                                         folder.path(""), GRAFWIRE_PROGRAM});
    return run_program(arguments);
}

Json sarif(const Ran& ran) {
    INFO("log: " << ran.out);
    CHECK(schema_problems(ran.out, "tests/command/sarif.schema.json") == "");
    const Json log = Json::parse(ran.out, nullptr, false);
    REQUIRE(log.is_object());
    const Json& run = log["runs"][0];
    for (const Json& result : run["results"]) {
        CHECK(run["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"] ==
              result["ruleId"]);
    }
    return run["results"];
}

}  // namespace

TEST_CASE("styles: a list, all, and what is none of it") {
    CHECK(verdicts_of(json_lines(
              grafwire_with({"check", rule_5_chart, "--style", "nor,nand", "--to", "json"}).out)) ==
          Words{"nand equivalent", "nor different"});
    const Ran all = grafwire_with({"check", rule_5_chart, "--style", "all", "--to", "json"});
    CHECK(all.status == 1);
    const auto lines = json_lines(all.out);
    Words styles;
    for (const Json& line : lines) styles.push_back(line.at("style"));
    CHECK(styles == choices_of("netlist", "--style"));
    CHECK(lines.back().at("verdict") == "skipped");
    CHECK(lines.back().at("diagnostics")[0].at("severity") == "error");
    CHECK(contains(all.err, "6 checks: 4 equivalent, 1 different, 1 skipped\n"));
    for (const std::string words : {"nand,", ",nand", "nand,nand", "nand,all", "nand rs", ""}) {
        CAPTURE(words);
        CHECK(grafwire_with({"check", rule_5_chart, "--style", words}).status == 2);
    }
}

TEST_CASE(
    "that a style cannot hold a chart is no error where all are tried, and one where it is "
    "asked for") {
    const Ran all = grafwire_with({"check", counter_chart, "--style", "all", "--max-cases", "20"});
    CHECK(all.status == 3);
    CHECK(contains(all.out, counter_chart +
                                ": skipped (style nand, CDX successor): the nand style has no "
                                "registers for the counter"));
    CHECK(!contains(all.err, "error"));
    const Ran asked =
        grafwire_with({"check", counter_chart, "--style", "nand,clocked", "--max-cases", "20"});
    CHECK(asked.status == 2);
    CHECK(contains(asked.err, "error: the nand style has no registers"));
    CHECK(contains(asked.out, "undecided (style clocked"));
    // A chart of which there is no verdict at all is none that is in order.
    const Ran none =
        grafwire_with({"check", counter_chart, rule_5_chart, "--style", "all", "--delay", "1..2"});
    CHECK(none.status == 2);
    CHECK(contains(none.err, counter_chart + ": no style can hold this GRAFCET as it is asked "
                                             "for, so nothing was checked\n"));
    CHECK(contains(none.err, " in error"));
}

TEST_CASE("reports on several: one behind the other, and a table of all") {
    const Ran ran = grafwire_with({"check", rule_5_chart, sequence_chart, "--style", "nand,nor"});
    CHECK(ran.status == 1);
    std::string expected;
    for (const std::string& chart : {rule_5_chart, sequence_chart}) {
        for (const std::string style : {"nand", "nor"}) {
            expected += (expected.empty() ? "" : "\n") +
                        grafwire_with({"check", chart, "--style", style}).out;
        }
    }
    CHECK(ran.out == expected);
    CHECK(table_of(ran.err) ==
          Words{"File Compared with Verdict Cases ", rule_5_chart + " nand equivalent 93 ",
                rule_5_chart + " nor different 12 ", sequence_chart + " nand equivalent 49 ",
                sequence_chart + " nor equivalent 49 ", "4 checks: 3 equivalent, 1 "});
    CHECK(contains(grafwire_with({"check", rule_5_chart, sequence_chart, "--lang", "fr"}).err,
                   "2 vérifications\u00a0: 2 équivalentes\n"));
}

TEST_CASE("one that is wrong does not stop the others; the status is the worst") {
    const ScratchFolder folder;
    const std::string broken = folder.file("broken.grafcet", "graph G {\n  initial 0 <\n}\n");
    const Words good{"check", rule_5_chart, "--style", "nand,nor", "--max-cases", "60"};
    CHECK(grafwire_with(good).status == 1);
    CHECK(grafwire_with({"check", rule_5_chart, sequence_chart, "--max-cases", "60"}).status == 3);
    Words wrong = good;
    wrong.insert(wrong.begin() + 1, {broken, folder.path("*.none")});
    const Ran ran = grafwire_with(wrong);
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, broken + ":2:13: error: "));
    CHECK(contains(ran.out, broken + ": not checked (style nand, CDX successor): "));
    CHECK(contains(ran.out, folder.path("*.none") + ": not checked (style nor, CDX successor): no "
                                                    "file fits this pattern\n"));
    CHECK(contains(ran.out, "different (style nor"));
    wrong.insert(wrong.end(), {"--to", "json"});
    Words expected;
    for (int i = 0; i < 2; ++i) expected.insert(expected.end(), {"nand error", "nor error"});
    expected.insert(expected.end(), {"nand undecided", "nor different"});
    CHECK(verdicts_of(json_lines(grafwire_with(wrong).out)) == expected);
    // A request that is wrong is so for all.
    Words request{"check", rule_5_chart, sequence_chart, "--cpu", "212", "--to", "json"};
    const Ran refused = grafwire_with(request);
    CHECK(refused.status == 2);
    CHECK(refused.out.empty());
    CHECK(std::count(refused.err.begin(), refused.err.end(), '\n') == 1);
    request.back() = "junit";
    CHECK(contains(grafwire_with(request).out, " tests=\"2\" failures=\"0\" errors=\"2\""));
}

TEST_CASE("JUnit: a case for each file and style, passed, failed, in error or skipped") {
    const ScratchFolder folder;
    const std::string broken = folder.file("a & b.grafcet", "graph G {\n  initial 0 <\n}\n");
    const std::string report = folder.path("report.xml");
    const Ran ran = grafwire_with({"check", rule_5_chart, broken, "--style", "all", "--max-cases",
                                   "100", "--to", "junit", "-o", report});
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    check_junit(report);
    const std::string text = text_of(report);
    CHECK(contains(text, " tests=\"12\" failures=\"1\" errors=\"7\" skipped=\"1\" time=\""));
    CHECK(contains(text, "<testcase classname=\"" + rule_5_chart + "\" name=\"nor successor\""));
    CHECK(contains(text, "<failure message=\"situation\">" + rule_5_chart + ": different"));
    CHECK(contains(text, "<error message=\"undecided\">"));
    CHECK(contains(text, "a &amp; b.grafcet\" name=\"clocked transition\""));
    CHECK(contains(text, "<error message=\"not checked\">"));
    CHECK(contains(text, "<skipped message=\"the style cannot hold this GRAFCET\">"));
    // Also of a single one, and where the schema has to see a mistake.
    CHECK(grafwire_with({"check", broken, "--to", "junit", "-o", report}).status == 2);
    check_junit(report);
    const std::string wrong = folder.file("wrong.xml", "<testsuite name=\"a\" tests=\"x\"/>\n");
    CHECK(run_program({"xmllint", "--noout", "--schema",
                       std::string(GRAFWIRE_ROOT) + "/tests/command/junit.xsd", wrong})
              .status != 0);
}

TEST_CASE("what comes out does not depend on how many checks run at a time") {
    const std::string folder = example("");
    const Words request{"check", folder, "--style", "all", "--max-cases", "300", "--to"};
    for (const std::string form : {"text", "json", "sarif"}) {
        Words one = request;
        one.insert(one.end(), {form, "-j", "1"});
        const Ran expected = grafwire_with(one);
        CHECK(expected.status == 1);
        for (const std::string jobs : {"2", "7"}) {
            one.back() = jobs;
            const Ran ran = grafwire_with(one);
            CHECK(ran.status == expected.status);
            CHECK(ran.out == expected.out);
            CHECK(table_of(ran.err) == table_of(expected.err));
            CHECK(ran.err.substr(0, ran.err.find("File ")) ==
                  expected.err.substr(0, expected.err.find("File ")));
        }
    }
}

TEST_CASE("Ctrl-C ends those that run and all that come, undecided, with a report") {
    const ScratchFolder folder;
    const std::string report = folder.path("report.json");
    // The signal comes once there are threads that check, long before they are done.
    const Ran ran =
        run_program({"/bin/sh", "-c",
                     "env --default-signal=INT \"$@\" & i=0; until [ $i -gt 3000 ] || grep -q "
                     "'^Threads:.*[2-9]' /proc/$!/status; "
                     "do i=$((i+1)); sleep 0.01; done; kill -INT $!; wait $!",
                     "sh", GRAFWIRE_PROGRAM, "check", example("manipulator-modes.grafcet"),
                     example("level-crossing.grafcet"), "--style", "clocked", "-j", "2", "--to",
                     "json", "-o", report});
    CHECK(ran.status == 3);
    CHECK(verdicts_of(json_lines(text_of(report))) ==
          Words{"clocked undecided", "clocked undecided"});
    CHECK(contains(ran.err, "2 checks: 2 undecided\n"));
}

TEST_CASE("witnesses of several checks have a folder each; that of a check that holds goes") {
    const ScratchFolder folder;
    const std::string out = folder.path("w");
    const Words request{"check",     rule_5_chart, sequence_chart, "--style", "nand,nor",
                        "--witness", out,          "--to",         "json"};
    const Ran ran = grafwire_with(request);
    CHECK(ran.status == 1);
    const auto lines = json_lines(ran.out);
    CHECK(lines[1]["witness"]["files"][0] == out + "/rule-5-nor/witness.stim");
    CHECK(std::filesystem::exists(out + "/rule-5-nor/witness.svg"));
    std::size_t folders = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(out)) ++folders;
    CHECK(folders == 1);
    std::filesystem::create_directory(out + "/rule-5-nand");
    folder.file("w/rule-5-nand/got.csv", "old");
    CHECK(grafwire_with(request).status == 1);
    CHECK(!std::filesystem::exists(out + "/rule-5-nand/got.csv"));
    // Two charts whose witnesses would go to one folder.
    std::filesystem::create_directory(folder.path("x"));
    const std::string other = folder.file("x/rule-5.grafcet", text_of(rule_5_chart));
    const Ran same = grafwire_with({"check", rule_5_chart, other, "--witness", out});
    CHECK(same.status == 2);
    CHECK(contains(same.err, "the results of both would be called rule-5"));
}

TEST_CASE("shards are parts of one list, whoever sees it") {
    const ScratchFolder folder;
    for (const std::string name : {"b.grafcet", "a.grafcet", "c.grafcet"}) {
        folder.file(name, text_of(sequence_chart));
    }
    const auto checks_of = [](const Ran& ran) {
        Words words;
        for (const Json& line : json_lines(ran.out)) {
            const std::string file = line.at("file");
            words.push_back(file.substr(file.size() - 9, 1) + " " +
                            line.at("style").get<std::string>());
        }
        return words;
    };
    const auto shard = [&](const Words& files, const std::string& part) {
        Words request{"check", "--style", "rs,nor", "--to", "json", "--shard", part};
        request.insert(request.end(), files.begin(), files.end());
        const Ran ran = in_folder(folder, request);
        CHECK(ran.status == 0);
        return checks_of(ran);
    };
    const Words files{"c.grafcet", "a.grafcet", "b.grafcet"};
    CHECK(shard(files, "1/1") == Words{"a nor", "a rs", "b nor", "b rs", "c nor", "c rs"});
    CHECK(shard(files, "1/4") == Words{"a nor", "a rs"});
    CHECK(shard(files, "2/4") == Words{"b nor", "b rs"});
    CHECK(shard(files, "3/4") == Words{"c nor"});
    CHECK(shard(files, "4/4") == Words{"c rs"});
    CHECK(shard(files, "7/7").empty());
    // Absolute names and others, in any order.
    CHECK(shard({folder.path("c.grafcet"), "./b.grafcet", folder.path("a.grafcet")}, "2/3") ==
          shard(files, "2/3"));
    CHECK(shard({"."}, "1/2") == shard(files, "1/2"));
    for (const std::string part : {"0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/0"}) {
        CAPTURE(part);
        CHECK(grafwire_with({"check", rule_5_chart, "--shard", part}).status == 2);
    }
    // A part without any check is empty, in every form; so is that of a single chart.
    const std::string report = folder.path("report.xml");
    CHECK(grafwire_with({"check", rule_5_chart, "--shard", "2/2", "--to", "junit", "-o", report})
              .status == 0);
    check_junit(report);
}

TEST_CASE("SARIF: messages at their places, in UTF-16, and verdicts") {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path("sub dir"));
    folder.file("sub dir/é.grafcet",
                "input a\ngraph G {\n  initial 0\n  step 1\n  step 2  # \U0001F600\n"
                "  0 -> 1 : a  /* \n}\n");
    folder.file("wide.grafcet",
                "input \"\U0001F600\", a\ngraph G {\n  initial 0\n"
                "  0 -> 0 : \"\U0001F600\" . b\n}\n");
    folder.file("good.grafcet", text_of(rule_5_chart));
    const Ran ran = in_folder(folder, {"info", ".", "none.grafcet", "--to", "sarif"});
    CHECK(ran.status == 2);
    const Json results = sarif(ran);
    const auto find = [&](const Json& all, const std::string& rule) {
        for (const Json& result : all) {
            if (result["ruleId"] == rule) return result;
        }
        return Json();
    };
    const Json unknown = find(results, "unknown-name");
    REQUIRE(unknown.is_object());
    CHECK(unknown["level"] == "error");
    const Json place = unknown["locations"][0]["physicalLocation"];
    CHECK(place["artifactLocation"] == Json{{"uri", "wide.grafcet"}, {"uriBaseId", "%SRCROOT%"}});
    // `  0 -> 0 : "x" . b`: the face takes two.
    CHECK(place["region"] == Json{{"startLine", 4}, {"startColumn", 19}});
    CHECK(contains(ran.err, "wide.grafcet:4:18: error"));
    CHECK(contains(ran.out, "\"sub%20dir/%C3%A9.grafcet\""));
    const Json unreadable = find(results, "unreadable-file");
    CHECK(unreadable["locations"][0]["physicalLocation"]["region"] == Json{{"startLine", 1}});
    // Of check: the same messages once, whatever the number of styles, and the verdicts.
    const Ran checked = in_folder(
        folder, {"check", folder.path("good.grafcet"), "--style", "nand,nor", "--to", "sarif"});
    CHECK(checked.status == 1);
    const Json verdicts = sarif(checked);
    REQUIRE(verdicts.size() == 1);
    CHECK(verdicts[0]["ruleId"] == "different");
    CHECK(verdicts[0]["message"]["text"] ==
          "it does not do what this GRAFCET says (situation; style nor, CDX successor)");
    CHECK(verdicts[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] ==
          "good.grafcet");
    // A single one that is wrong has a log as well.
    const Ran broken = in_folder(folder, {"check", "wide.grafcet", "--to", "sarif"});
    CHECK(broken.status == 2);
    CHECK(sarif(broken)[0]["locations"] == unknown["locations"]);
    folder.file("good.grafcet", text_of(sequence_chart));
    CHECK(sarif(in_folder(folder, {"info", "good.grafcet", "--to", "sarif"})).empty());
}

TEST_CASE("--strict: warnings about a chart are errors") {
    const ScratchFolder folder;
    // Steps 0 and 1 follow each other, of which info and equations warn; output V is never used, of
    // which all do.
    const std::string text =
        "input a\noutput V\ngraph G {\n  initial 0\n  step 1\n  0 -> 1 : a\n  1 -> 0 : /a\n}\n";
    const std::string chart = folder.file("chart.grafcet", text);
    const std::string stimuli = folder.file("chart.stim", "0ms : a=1\n1ms : end\n");
    for (const Words& command :
         {Words{"info"}, Words{"equations"}, Words{"check"}, Words{"draw"}, Words{"report"},
          Words{"plc", "--to", "c"}, Words{"netlist", "--style", "nand", "--to", "blif"},
          Words{"run"}, Words{"simulate"}}) {
        CAPTURE(command);
        Words request = command;
        request.push_back(chart);
        if (command[0] == "run" || command[0] == "simulate") request.push_back(stimuli);
        const Ran allowed = grafwire_with(request);
        CHECK(allowed.status == 0);
        CHECK(contains(allowed.err, "chart.grafcet:2:8: warning: "));
        request.push_back("--strict");
        const Ran strict = grafwire_with(request);
        CHECK(strict.status == 2);
        CHECK(strict.out.empty());
        CHECK(contains(strict.err, "chart.grafcet:2:8: error: "));
        CHECK(!contains(strict.err, "warning"));
    }
    // What puts wiring at risk counts where it is told.
    const std::string pair = folder.file("pair.grafcet",
                                         "input a\ngraph G {\n  initial 0\n  step 1\n"
                                         "  0 -> 1 : a\n  1 -> 0 : /a\n}\n");
    CHECK(grafwire_with({"info", pair}).status == 0);
    CHECK(grafwire_with({"info", pair, "--strict"}).status == 2);
    CHECK(grafwire_with({"equations", pair, "--strict"}).status == 2);
    CHECK(grafwire_with({"equations", pair, "--cdx", "transition", "--strict"}).status == 0);
    CHECK(grafwire_with({"check", pair, "--strict"}).status == 0);
}

}  // namespace grafwire::testing
