// The reports of `check` for programs.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "command/run_program.h"

namespace grafwire::test {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& item : object.items()) keys.push_back(item.key());
    return keys;
}

/// The report, with all that every report has.
Json report(std::vector<std::string> arguments, int status) {
    arguments.insert(arguments.begin(), "check");
    arguments.insert(arguments.end(), {"--to", "json"});
    const Ran ran = grafwire_with(arguments);
    CHECK(ran.status == status);
    CHECK(ran.err.empty());
    const Json json = Json::parse(ran.out, nullptr, false);
    REQUIRE(json.is_object());
    CHECK(keys_of(json) == std::vector<std::string>{"verdict", "style", "cdx", "delay",
                                                    "situations", "cases", "unstable", "complete",
                                                    "witness"});
    for (const std::string key : {"verdict", "style", "cdx", "delay"}) CHECK(json[key].is_string());
    for (const std::string key : {"situations", "cases", "unstable"}) {
        CHECK(json[key].is_number_unsigned());
    }
    CHECK(json["complete"].is_boolean());
    CHECK(json["delay"] == "unit");
    return json;
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
        if (tag[0] == '?') continue;
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
    CHECK(ran.out.rfind("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite", 0) == 0);
    CHECK(contains(ran.out, " tests=\"1\""));
    return ran.out;
}

}  // namespace

TEST_CASE("JSON: equivalent") {
    const Json json = report({example("nine-steps.grafcet"), "--style", "gates"}, 0);
    CHECK(json["verdict"] == "equivalent");
    CHECK(json["style"] == "gates");
    CHECK(json["cdx"] == "successor");
    CHECK(json["complete"] == true);
    CHECK(json["witness"].is_null());
    CHECK(json["cases"] > 300);
    CHECK(json["unstable"] > 0);
    CHECK(report({example("rule-5.grafcet"), "--style", "clocked"}, 0)["cdx"] == "transition");
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
    CHECK(witness["expected"] != witness["got"]);
    // The files are there, and the stimuli are those of the witness.
    std::vector<std::string> files;
    for (const Json& file : witness["files"]) files.push_back(file);
    CHECK(files.size() == 6);
    for (const std::string& file : files) CHECK(!text_of(file).empty());
    CHECK(text_of(folder.path("w/witness.stim")) == witness["stimuli"]);
    CHECK(report({chart, "--style", "nor"}, 1)["witness"]["files"] == Json::array());
    // The story is in English whatever the language, and tells what the file tells.
    CHECK(witness["cause"] == "reset-priority");
    std::string story;
    for (const Json& line : witness["story"]) story += line.get<std::string>() + "\n";
    CHECK(story == text_of(folder.path("w/witness.txt")));
    const Json french = report({chart, "--style", "nor", "--lang", "fr"}, 1)["witness"];
    CHECK(french["story"] == witness["story"]);
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
    CHECK(!contains(passed, "<failure"));
    const std::string failed = junit({example("rule-5.grafcet"), "--style", "nor"}, 1);
    CHECK(contains(failed, " failures=\"1\" errors=\"0\""));
    CHECK(contains(failed, "<failure message=\"situation\">"));
    const std::string undecided =
        junit({example("nine-steps.grafcet"), "--style", "nand", "--max-cases", "100"}, 3);
    CHECK(contains(undecided, " failures=\"0\" errors=\"1\""));
    CHECK(contains(undecided, "<error message="));
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

}  // namespace grafwire::test
