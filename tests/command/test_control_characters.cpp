// Control characters of strangers: none comes in with a name, and none goes out in a message.

#include <doctest/doctest.h>

#include <filesystem>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

const std::string escape = "\x1b[2J";
const std::string replacement = "\xef\xbf\xbd";

/// Terminals obey the first ones; the last ones turn the direction of writing.
const std::vector<std::string> controls{std::string(1, '\0'), "\a", "\t", "\x1b", "\x7f",
                                        "\xc2\x9b",       // U+009B, which begins what ESC [ does
                                        "\xd8\x9c",       // U+061C
                                        "\xe2\x80\x8f",   // U+200F
                                        "\xe2\x80\xa8",   // U+2028
                                        "\xe2\x80\xae",   // U+202E
                                        "\xe2\x81\xa6"};  // U+2066

/// Of these only those that text may hold where it is written unescaped.
bool is_shown_raw(const std::string& text) {
    for (const std::string& control : controls) {
        if (control != "\t" && contains(text, control)) return true;
    }
    return false;
}

std::string chart_with(const std::string& title, const std::string& input,
                       const std::string& step) {
    return "grafcet g \"" + title + "\"\ninput \"" + input + "\"\ngraph G { initial 0 step \"" +
           step + "\" 0 -> \"" + step + "\" : \"" + input + "\" \"" + step + "\" -> 0 : /\"" +
           input + "\" }\n";
}

void check_refusal(const Ran& ran, const std::string& place) {
    INFO("messages: " << ran.err);
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, place));
    CHECK(contains(ran.err, "which no name or title may hold; remove it"));
    CHECK(!is_shown_raw(ran.err));
}

}  // namespace

TEST_CASE("no name or title of a chart holds a control character") {
    for (const std::string& control : controls) {
        const std::string bad = "ab" + control + "c";
        for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
                 {chart_with(bad, "a", "1"), "<stdin>:1:14: error: "},
                 {chart_with("t", bad, "1"), "<stdin>:2:10: error: "},
                 {chart_with("t", "a", bad), "<stdin>:3:29: error: "}}) {
            check_refusal(grafwire_with({"info", "-"}, text), place);
        }
    }
    // Where a name needs no quotes these are no letters.
    const Ran ran = grafwire_with({"info", "-"}, "input a\xd8\x9c\ngraph G { initial 0 }\n");
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, "U+061C"));
}

TEST_CASE("nor does a name that comes in otherwise") {
    const ScratchFolder folder;
    check_refusal(grafwire_with({"check", rule_5_chart, "--assume", "/\"" + escape + "\""}),
                  "--assume:1:3: error: ");
    const std::string io = folder.file("a.io", "E0.0 = \"s" + escape + "\"\nA0.0 = (\x7f)\n");
    check_refusal(grafwire_with({"plc", rule_5_chart, "--to", "s7-200", "--io", io}),
                  ":1:8: error: ");
    check_refusal(grafwire_with({"plc", rule_5_chart, "--to", "s7-200", "--io", io}),
                  ":2:8: error: ");
    // Whether written as it is or percent by percent.
    for (const std::string& name : {"a" + escape, std::string("a%1B")}) {
        const std::string net =
            ".inputs " + name + "\n.outputs y\n.names " + name + " y\n1 1\n.end\n";
        const std::string blif = folder.file("a.blif", ".model m\n" + net);
        check_refusal(grafwire_with({"check", rule_5_chart, "--against", blif}), ":2:9: error: ");
        const std::string model = folder.file("b.blif", ".model " + name + "\n.inputs a\n.end\n");
        check_refusal(grafwire_with({"check", rule_5_chart, "--against", model}), ":1:8: error: ");
    }
    for (const std::string module : {"m", "\\u001b"}) {
        const std::string port = module == "m" ? "p\\u0007" : "p";
        const std::string json =
            folder.file("a.json", "{\"modules\":{\"" + module + "\":{\"ports\":{\"" + port +
                                      "\":{\"direction\":\"input\",\"bits\":[2]}}}}}");
        check_refusal(grafwire_with({"check", rule_5_chart, "--against", json}), "a.json:1:");
    }
    const std::string ladder =
        grafwire_with({"plc", example("manipulator.grafcet"), "--to", "plcopen"}).out;
    const std::size_t name = ladder.find("<variable name=\"") + 16;
    const std::string xml =
        folder.file("a.xml", ladder.substr(0, name) + "&#27;" + ladder.substr(name));
    check_refusal(grafwire_with({"check", example("manipulator.grafcet"), "--against", xml}),
                  "a.xml:");
}

TEST_CASE("messages and reports show no control character of a file name") {
    const ScratchFolder folder;
    const std::string odd = folder.file("a" + escape + ".grafcet", text_of(rule_5_chart));
    const std::string shown = folder.path("a" + replacement + "[2J.grafcet");
    const std::string nowhere = folder.path("none" + escape + "/out");
    for (const std::vector<std::string>& request :
         std::vector<std::vector<std::string>>{{"check", odd, "--style", "nand"},
                                               {"check", odd, "--style", "nor"},
                                               {"check", odd, "--style", "nand", "--to", "junit"},
                                               {"check", rule_5_chart, "--against", odd},
                                               {"equations", rule_5_chart, "-o", nowhere},
                                               {"equations", odd, "-o", odd},
                                               {"equations", odd + escape},
                                               {"netlist", odd, "--style", "nand", "--to", escape},
                                               {"plc", odd, "--to", escape},
                                               {escape},
                                               {"info", "--" + escape}}) {
        CAPTURE(request);
        const Ran ran = grafwire_with(request);
        CHECK(!contains(ran.out + ran.err, "\x1b"));
        CHECK(contains(ran.out + ran.err, replacement));
    }
    CHECK(contains(grafwire_with({"check", odd, "--style", "nand"}).out, shown + ": equivalent"));
}

TEST_CASE("nor one of a comment in a program that is compared") {
    const ScratchFolder folder;
    const std::string manipulator = example("manipulator.grafcet");
    std::string awl = text_of(example("s7-200/manipulator.awl"));
    // Every network has a comment with an escape sequence, and one does something else.
    std::string odd;
    for (std::size_t at = 0; at < awl.size();) {
        const std::size_t end = std::min(awl.find('\n', at), awl.size() - 1);
        const std::string line = awl.substr(at, end - at);
        odd += line + (line.starts_with("NETWORK") ? " // " + escape : "") + "\n";
        at = end + 1;
    }
    const std::size_t place = odd.find("LDN");
    REQUIRE(place != std::string::npos);
    odd.replace(place, 3, "LD ");
    const Ran ran =
        grafwire_with({"check", manipulator, "--against", folder.file("a.awl", odd), "--io",
                       example("s7-200/manipulator.io"), "--witness", folder.path("w")});
    CHECK(ran.status == 1);
    CHECK(!contains(ran.out + ran.err, "\x1b"));
    CHECK(!contains(text_of(folder.path("w/witness.txt")), "\x1b"));
    CHECK(contains(ran.out, replacement));
}

}  // namespace grafwire::testing
