// The reports of `check` for programs.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "command/json_schema.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

/// The report, which is as its schema says.
Json report(std::vector<std::string> arguments, int status) {
    arguments.insert(arguments.begin(), "check");
    arguments.insert(arguments.end(), {"--to", "json"});
    const Ran ran = grafwire_with(arguments);
    CHECK(ran.status == status);
    INFO("report: " << ran.out);
    CHECK(schema_problems(ran.out) == "");
    const Json json = Json::parse(ran.out, nullptr, false);
    REQUIRE(json.is_object());
    return json;
}

/// The keys of a report on what `subject` describes, one after the other.
std::vector<std::string> keys_with(const std::vector<std::string>& subject) {
    std::vector<std::string> keys{"grafwire", "chart", "file", "verdict"};
    keys.insert(keys.end(), subject.begin(), subject.end());
    keys.insert(keys.end(), {"power_up", "assumptions", "method", "together", "situations", "cases",
                             "unstable", "complete", "diagnostics", "never", "witness"});
    return keys;
}

void check_values(const Json& values, const std::vector<std::string>& names) {
    REQUIRE(values.is_object());
    CHECK(keys_of(values) == names);
    for (const auto& item : values.items()) {
        CHECK((item.value() == 0 || item.value() == 1 || item.value() == "x"));
    }
}

/// Whether a text is well-formed XML, as far as a report without namespaces and sections goes.
bool is_well_formed(const std::string& text) {
    std::vector<std::string> open;
    std::size_t at = 0;
    bool had_root = false;
    const auto good_text = [](const std::string& part) {
        for (std::size_t i = 0; i < part.size(); ++i) {
            const auto c = static_cast<unsigned char>(part[i]);
            if (c < 0x20 && c != '\n' && c != '\t') return false;
            if (c == '<') return false;
            if (c != '&') continue;
            const std::size_t end = part.find(';', i);
            if (end == std::string::npos) return false;
            const std::string name = part.substr(i + 1, end - i - 1);
            if (name != "amp" && name != "lt" && name != "gt" && name != "quot" && name != "apos" &&
                name[0] != '#') {
                return false;
            }
        }
        return true;
    };
    while (at < text.size()) {
        if (text[at] != '<') {
            const std::size_t end = std::min(text.find('<', at), text.size());
            const std::string part = text.substr(at, end - at);
            if (!good_text(part)) return false;
            if (open.empty() && part.find_first_not_of(" \n") != std::string::npos) return false;
            at = end;
            continue;
        }
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) return false;
        const std::string tag = text.substr(at + 1, end - at - 1);
        at = end + 1;
        if (tag[0] == '?' || (tag.starts_with("!--") && tag.ends_with("--"))) continue;
        if (tag[0] == '/') {
            if (open.empty() || open.back() != tag.substr(1)) return false;
            open.pop_back();
            continue;
        }
        if (open.empty() && had_root) return false;
        had_root = true;
        const std::string name = tag.substr(0, tag.find_first_of(" /"));
        // Attributes: name="value", the value without a quote.
        std::size_t i = name.size();
        while (i < tag.size() && tag[i] == ' ') {
            const std::size_t quote = tag.find("=\"", i);
            if (quote == std::string::npos) return false;
            const std::size_t close = tag.find('"', quote + 2);
            if (close == std::string::npos) return false;
            if (!good_text(tag.substr(quote + 2, close - quote - 2))) return false;
            i = close + 1;
        }
        if (i == tag.size()) {
            open.push_back(name);
        } else if (tag.substr(i) != "/") {
            return false;
        }
    }
    return had_root && open.empty();
}

std::string junit(std::vector<std::string> arguments, int status) {
    arguments.insert(arguments.begin(), "check");
    arguments.insert(arguments.end(), {"--to", "junit"});
    const Ran ran = grafwire_with(arguments);
    CHECK(ran.status == status);
    CHECK(ran.err.empty());
    INFO("report: " << ran.out);
    CHECK(is_well_formed(ran.out));
    CHECK(ran.out.rfind("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- grafwire ", 0) == 0);
    CHECK(contains(ran.out, " -->\n<testsuite "));
    CHECK(contains(ran.out, " tests=\"1\""));
    return ran.out;
}

}  // namespace

TEST_CASE("JSON: equivalent") {
    const Json json = report({example("nine-steps.grafcet"), "--style", "gates"}, 0);
    CHECK(keys_of(json) == keys_with({"style", "cdx", "delay", "changes"}));
    CHECK("grafwire " + json["grafwire"].get<std::string>() + "\n" ==
          grafwire_with({"--version"}).out);
    CHECK(json["chart"] == "nine_steps");
    CHECK(json["file"] == example("nine-steps.grafcet"));
    CHECK(json["verdict"] == "equivalent");
    CHECK(json["style"] == "gates");
    CHECK(json["cdx"] == "successor");
    CHECK(json["delay"] == "unit");
    CHECK(json["changes"] == "one");
    CHECK(json["power_up"] == "Init");
    CHECK(json["assumptions"] == Json{"/(d1.d2)"});
    CHECK(json["together"] == true);
    CHECK(json["complete"] == true);
    CHECK(json["diagnostics"] == Json::array());
    CHECK(json["never"] == Json::parse(R"({"steps": [], "transitions": [], "inputs": [], )"
                                       R"("outputs": []})"));
    CHECK(json["witness"].is_null());
    CHECK(json["cases"] > 100);
    CHECK(json["unstable"] > 0);
}

TEST_CASE("JSON: what the verdict rests on") {
    const std::string chart = example("single-sequence.grafcet");
    const Json many =
        report({chart, "--changes", "many", "--modes", "off", "--assume", "/m + /a"}, 0);
    CHECK(many["changes"] == "many");
    CHECK(many["together"].is_null());
    CHECK(many["power_up"] == "initial values");
    CHECK(many["assumptions"] == Json{"/m + /a"});
    const Json every = report({chart, "--style", "clocked"}, 0);
    CHECK(keys_of(every) == keys_with({"style", "cdx", "delay", "period"}));
    CHECK(every["cdx"] == "transition");
    CHECK(every["period"] == "every");
    CHECK(report({chart, "--style", "clocked", "--scan", "0.01s"}, 0)["period"] == "10ms");
}

TEST_CASE("JSON: netlists and programs from elsewhere") {
    const ScratchFolder folder;
    const std::string chart = example("single-sequence.grafcet");
    const auto made = [&](std::vector<std::string> arguments, const std::string& name) {
        arguments.insert(arguments.begin() + 1, chart);
        arguments.insert(arguments.end(), {"-o", folder.path(name)});
        REQUIRE(grafwire_with(arguments).status == 0);
        return folder.path(name);
    };
    const std::string wired = made({"netlist", "--style", "nand", "--to", "blif"}, "wired.blif");
    const Json netlist = report({chart, "--against", wired}, 0);
    CHECK(keys_of(netlist) == keys_with({"against", "delay", "changes"}));
    CHECK(netlist["against"] == wired);
    CHECK(netlist["power_up"] == "Init");
    const std::string clocked =
        made({"netlist", "--style", "clocked", "--to", "json"}, "clocked.json");
    CHECK(keys_of(report({chart, "--against", clocked}, 0)) ==
          keys_with({"against", "delay", "period"}));
    const std::string ladder = made({"plc", "--to", "plcopen"}, "ladder.xml");
    const Json program = report({chart, "--against", ladder, "--scan", "20ms"}, 0);
    CHECK(keys_of(program) == keys_with({"device", "period"}));
    CHECK(program["device"] == ladder);
    CHECK(program["period"] == "20ms");
    CHECK(program["power_up"] == "Init");
    const std::string bare = made({"plc", "--to", "plcopen", "--modes", "off"}, "bare.xml");
    CHECK(report({chart, "--against", bare}, 0)["power_up"] == "initial values");
}

TEST_CASE("JSON: many inputs at once make a difference that one at a time does not") {
    const Json json = report({example("rule-5.grafcet"), "--style", "gates", "--modes", "off"}, 0);
    CHECK(json["verdict"] == "equivalent");
    CHECK(json["together"] == false);
    REQUIRE(json["together_inputs"].size() >= 2);
    // The stimuli replay: the netlist comes out otherwise than the GRAFCET.
    const ScratchFolder folder;
    const std::string stim = folder.file("together.stim", json["together_stimuli"]);
    CHECK(grafwire_with({"run", example("rule-5.grafcet"), stim}).out !=
          grafwire_with(
              {"simulate", example("rule-5.grafcet"), stim, "--style", "gates", "--modes", "off"})
              .out);
    // The assumption keeps its word.
    CHECK(json["together_assume"] == "s + k");
    const Json assumed = report({example("rule-5.grafcet"), "--style", "gates", "--modes", "off",
                                 "--assume", json["together_assume"]},
                                0);
    CHECK(assumed["together"] == true);
    CHECK(report({example("rule-5.grafcet"), "--style", "gates", "--modes", "off", "--changes",
                  "many"},
                 1)["together"]
              .is_null());
}

TEST_CASE("JSON: what no case exercised, and the warnings of the GRAFCET") {
    const ScratchFolder folder;
    const std::string chart = folder.file("idle.grafcet", R"(input a, b
output lamp
graph G {
  initial 0
  step 1
  step 7 : lamp
  0 -> 1 : a
  1 -> 0 : /a
  (back) 7 -> 0 : ↑b
}
)");
    const Json json = report({chart, "--style", "nand", "--assume", "/b"}, 0);
    CHECK(json["never"]["steps"] == Json{"7"});
    CHECK(json["never"]["transitions"] == Json{"back"});
    CHECK(json["never"]["inputs"] == Json{"b"});
    CHECK(json["never"]["outputs"] == Json{"lamp"});
    REQUIRE(json["diagnostics"].size() == 1);
    CHECK(json["diagnostics"][0]["severity"] == "warning");
    CHECK(json["diagnostics"][0]["line"] == 6);
    CHECK(json["diagnostics"][0]["column"] == 8);
    CHECK(contains(json["diagnostics"][0]["message"], "7"));
}

TEST_CASE("JSON: different, with a witness") {
    const ScratchFolder folder;
    const std::string chart = example("rule-5.grafcet");
    const Json json = report({chart, "--style", "nor", "--witness", folder.path("w")}, 1);
    CHECK(json["verdict"] == "different");
    CHECK(json["complete"] == false);
    const Json& witness = json["witness"];
    REQUIRE(witness.is_object());
    CHECK(keys_of(witness) == std::vector<std::string>{"kind", "stimuli", "expected", "got",
                                                       "cause", "story", "files"});
    CHECK(witness["kind"] == "situation");
    const std::vector<std::string> names{"X1", "X2", "present", "loaded"};
    check_values(witness["expected"], names);
    check_values(witness["got"], names);
    // The step that is activated and deactivated at once is lost, and its lamp with it.
    CHECK(witness["expected"] == Json{{"X1", 1}, {"X2", 1}, {"present", 1}, {"loaded", 1}});
    CHECK(witness["got"] == Json{{"X1", 0}, {"X2", 1}, {"present", 0}, {"loaded", 1}});
    // The files are there, and hold the stimuli and the story of the witness.
    std::vector<std::string> files;
    for (const Json& file : witness["files"]) files.push_back(file);
    CHECK(files.size() == 9);
    for (const std::string& file : files) CHECK(!text_of(file).empty());
    CHECK(text_of(folder.path("w/witness.stim")) == witness["stimuli"]);
    std::string story;
    for (const Json& line : witness["story"]) story += line.get<std::string>() + "\n";
    CHECK(text_of(folder.path("w/witness.txt")) == story);
    CHECK(report({chart, "--style", "nor"}, 1)["witness"]["files"] == Json::array());
    // The story is in English whatever the language, and tells what the file tells.
    CHECK(witness["cause"] == "reset-priority");
    const Json french = report({chart, "--style", "nor", "--lang", "fr"}, 1)["witness"];
    CHECK(french["story"] == witness["story"]);
}

TEST_CASE("JSON: the story is in English, the files are in the language asked for") {
    const ScratchFolder folder;
    const std::vector<std::string> request{example("rule-5.grafcet"), "--style", "nor"};
    std::vector<std::string> in_french = request;
    in_french.insert(in_french.end(), {"--lang", "fr", "--witness", folder.path("w")});
    CHECK(report(in_french, 1)["witness"]["story"] == report(request, 1)["witness"]["story"]);
    CHECK(contains(text_of(folder.path("w/witness.txt")), "La référence :"));
}

TEST_CASE("JSON: a difference that shows scan by scan has the period of its scans") {
    const ScratchFolder folder;
    const std::string chart = example("single-sequence.grafcet");
    const std::string ladder = folder.path("ladder.xml");
    REQUIRE(grafwire_with({"plc", chart, "--to", "plcopen", "-o", ladder}).status == 0);
    std::string text = text_of(ladder);
    const std::size_t reset = text.find("storage=\"reset\"");
    REQUIRE(reset != std::string::npos);
    text.replace(reset, 15, "storage=\"set\"");
    const Json json =
        report({chart, "--against", folder.file("wrong.xml", text), "--scan", "20ms"}, 1);
    CHECK(json["witness"]["scan"] == "20ms");
}

TEST_CASE("JSON: a netlist that does not settle") {
    const Json json = report({example("positioning-axis.grafcet"), "--style", "gates"}, 1);
    CHECK(json["witness"]["kind"] == "oscillation");
    const std::vector<std::string> names{"X0",
                                         "X1",
                                         "X2",
                                         "X3",
                                         "X4",
                                         "X5",
                                         "Marche Moteur",
                                         "Sens Moteur",
                                         "Voyant Droite",
                                         "Voyant Gauche"};
    check_values(json["witness"]["expected"], names);
    check_values(json["witness"]["got"], names);
}

TEST_CASE("JSON: undecided") {
    const Json json =
        report({example("nine-steps.grafcet"), "--style", "nand", "--max-cases", "100"}, 3);
    CHECK(json["verdict"] == "undecided");
    CHECK(json["complete"] == false);
    CHECK(json["cases"] == 100);
    CHECK(json["witness"].is_null());
}

TEST_CASE("JUnit: passed, failed, in error") {
    const std::string passed = junit({example("rule-5.grafcet"), "--style", "nand"}, 0);
    CHECK(contains(passed, " failures=\"0\" errors=\"0\""));
    CHECK(contains(passed, "<testcase classname=\"" + example("rule-5.grafcet") + "\" name=\""));
    CHECK(!contains(passed, "<failure"));
    const std::string failed = junit({example("rule-5.grafcet"), "--style", "nor"}, 1);
    CHECK(contains(failed, " failures=\"1\" errors=\"0\""));
    CHECK(contains(failed, "<failure message=\"situation\">"));
    const std::string undecided =
        junit({example("nine-steps.grafcet"), "--style", "nand", "--max-cases", "100"}, 3);
    CHECK(contains(undecided, " failures=\"0\" errors=\"1\""));
    CHECK(contains(undecided, "<error message="));
}

TEST_CASE("JUnit: seconds, with three decimals") {
    const std::string text = junit({example("rule-5.grafcet"), "--style", "nand"}, 0);
    for (const std::string element : {"<testsuite ", "<testcase "}) {
        const std::size_t at = text.find(" time=\"", text.find(element));
        REQUIRE(at != std::string::npos);
        const std::string seconds = text.substr(at + 7, text.find('"', at + 7) - at - 7);
        REQUIRE(seconds.size() >= 5);
        CHECK(seconds[seconds.size() - 4] == '.');
        CHECK(std::stod(seconds) < 60);
    }
}

TEST_CASE("JUnit: what cannot be checked is a test in error, with the messages") {
    const ScratchFolder folder;
    const std::string chart = example("single-sequence.grafcet");
    const std::string broken = folder.file("broken.grafcet", "graph G {\n  initial 0 <\n}\n");
    const std::string ports =
        folder.file("ports.blif", ".model m\n.inputs a\n.outputs X0\n.names a X0\n1 1\n.end\n");
    for (const std::vector<std::string>& request : std::vector<std::vector<std::string>>{
             {folder.path("none.grafcet")},
             {broken},
             {chart, "--against", ports},
             {chart, "--against", folder.file("ladder.xml", "<project>\n")},
             {chart, "--assume", "m ."},
             {chart, "--style", "clocked", "--changes", "one"},
             {example("batch-counter.grafcet"), "--style", "nand"}}) {
        CAPTURE(request);
        std::vector<std::string> arguments{"check"};
        arguments.insert(arguments.end(), request.begin(), request.end());
        const Ran as_text = grafwire_with(arguments);
        CHECK(as_text.status == 2);
        CHECK(as_text.out.empty());
        arguments.insert(arguments.end(), {"--to", "junit", "-o", folder.path("report.xml")});
        const Ran ran = grafwire_with(arguments);
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK(ran.err == as_text.err);
        const std::string text = text_of(folder.path("report.xml"));
        CHECK(is_well_formed(text));
        CHECK(contains(text, "tests=\"1\" failures=\"0\" errors=\"1\""));
        CHECK(contains(text, "classname=\"" + request.front() + "\""));
        CHECK(contains(text, "<error message=\"not checked\">"));
        // The first message, but for what XML spells otherwise.
        const std::string first = ran.err.substr(0, ran.err.find_first_of("\n<>&\"'"));
        CHECK(contains(text, first));
    }
    // A test keeps its name when it comes to be in error.
    const auto name_in = [](const std::string& text) {
        return text.substr(text.find("classname="),
                           text.find(" time=", text.find("classname=")) - text.find("classname="));
    };
    const std::string target = folder.file("chart.grafcet", text_of(chart));
    const std::string good = junit({target, "--style", "gates", "--changes", "many"}, 0);
    folder.file("chart.grafcet", "graph");
    const Ran bad =
        grafwire_with({"check", target, "--style", "gates", "--changes", "many", "--to", "junit"});
    CHECK(bad.status == 2);
    CHECK(name_in(bad.out) == name_in(good));
}

TEST_CASE("JUnit: in English, whatever the language") {
    const std::vector<std::string> request{
        "check", example("rule-5.grafcet"), "--style", "nor", "--to", "junit", "--lang", "fr"};
    const Ran ran = grafwire_with(request);
    CHECK(contains(ran.out, "The reference:"));
    CHECK(!contains(ran.out, "référence"));
}

TEST_CASE("JUnit: names that XML has to spell otherwise") {
    const ScratchFolder folder;
    const std::string chart = folder.file("a & <b>.grafcet", R"(input "<&>", b
output "A'&<"
graph G {
  initial "<0>"
  step "1&" : "A'&<"
  "<0>" -> "1&" : "<&>"
  "1&" -> "<0>" : b
}
)");
    const std::string failed = junit({chart, "--style", "gates"}, 1);
    CHECK(contains(failed, "a &amp; &lt;b&gt;.grafcet"));
    CHECK(contains(failed, "A'&amp;&lt;"));
}

TEST_CASE("JUnit: the reader of this test sees what is not well-formed") {
    CHECK(is_well_formed("<?xml version=\"1.0\"?>\n<a b=\"c\"><d/>x &lt; y</a>\n"));
    for (const std::string wrong :
         {"<a>", "<a></b>", "<a/><b/>", "<a b=c/>", "<a b=\"<\"/>", "<a>&</a>", "x<a/>", ""}) {
        INFO("text: " << wrong);
        CHECK(!is_well_formed(wrong));
    }
}

}  // namespace grafwire::testing
