// Under --lang fr all that people read is French: the help of every command, and what is said of
// requests and inputs that are refused. English words betray a text that was left out.

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "command/english_words.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Request = std::vector<std::string>;

const std::string chart = example("single-sequence.grafcet");
const std::string stim = example("single-sequence.stim");

/// The commands that a help lists.
std::vector<std::string> commands_in(const std::string& help) {
    std::vector<std::string> commands;
    std::istringstream lines(help.substr(help.find("\nCommandes\u00a0:\n") + 14));
    for (std::string line; std::getline(lines, line);) {
        const bool begins = line.rfind("  ", 0) == 0 && line.find_first_not_of(' ') == 2;
        if (begins) commands.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    return commands;
}

/// How many options a help lists.
std::size_t options_in(const std::string& help) {
    std::size_t count = 0;
    for (std::size_t at = help.find("\n  -"); at != std::string::npos;
         at = help.find("\n  -", at + 1))
        ++count;
    return count;
}

}  // namespace

TEST_CASE("help is French throughout") {
    std::string shown = grafwire_with({"--lang", "fr", "--help"}).out;
    CHECK(english_in(shown).empty());
    CHECK(contains(shown, "Utilisation\u00a0: grafwire [OPTIONS] COMMANDE"));
    const std::vector<std::string> commands = commands_in(shown);
    CHECK(commands.size() == 11);
    for (const std::string& command : commands) {
        INFO("command: " << command);
        shown = grafwire_with({command, "--help", "--lang", "fr"}).out;
        CHECK(english_in(shown) == "");
        CHECK(contains(shown, "Exemple"));
        // It is the same help: one option for each of the English one.
        const std::string english = grafwire_with({command, "--help"}).out;
        CHECK(options_in(shown) == options_in(english));
        CHECK(english_in(english) != "");
    }
    CHECK(english_in(grafwire_with({"s7", "run", "--help", "--lang=fr"}).out) == "");
    CHECK(grafwire_with({"check", "--help"}, {}, {"LC_ALL=fr_FR.UTF-8"}).out ==
          grafwire_with({"--lang", "fr", "check", "--help"}).out);
}

TEST_CASE("refused requests and inputs are told in French") {
    const ScratchFolder folder;
    const std::string plain = folder.file(
        "nand.blif", grafwire_with({"netlist", chart, "--style", "nand", "--to", "blif"}).out);
    const auto blif = [&](const std::string& name, const std::string& text) {
        return Request{"check", chart, "--against",
                       folder.file(name + ".blif", ".model m\n.inputs a b\n.outputs X0\n" + text)};
    };
    const auto json = [&](const std::string& name, const std::string& text) {
        return Request{"check", chart, "--against", folder.file(name + ".json", text)};
    };
    const auto cell = [&](const std::string& name, const std::string& text) {
        return json(name,
                    "{\"modules\": {\"m\": {\"ports\": {\"a\": {\"direction\": \"input\", "
                    "\"bits\": [2]}}, \"cells\": {\"c\": " +
                        text + "}}}}");
    };
    const std::vector<Request> requests{
        // The command line.
        {},
        {"chek"},
        {"zzzzzz", chart},
        {"check"},
        {"s7"},
        {"s7", "run", "a.awl"},
        {"check", chart, "--stile", "nand"},
        {"check", chart, "--zzzzzz"},
        {"check", chart, "--style", "zz"},
        {"check", chart, "--style"},
        {"check", chart, "--style", "nand", "--style", "nor"},
        {"check", chart, "--max-cases", "-1"},
        {"check", chart, "--max-seconds", "x"},
        {"check", chart, "--max-memory", "7 zz"},
        {"check", chart, "--scan", "0ms", "--style", "clocked"},
        {"equations", chart, "--karnaugh=zz"},
        {"--lang", "zz"},
        // What does not go together.
        {"check", chart, "--style", "clocked", "--cdx", "successor"},
        {"netlist", chart, "--style", "nand", "--to", "bliff"},
        {"netlist", chart, "--style", "nand", "--to", "zzzzzz"},
        {"plc", chart, "--to", "zzzzzz"},
        {"plc", chart, "--to", "c", "--io", "x"},
        {"plc", "-", "--to", "s7-200", "--io", "-"},
        {"run", "-", "-"},
        {"equations", chart, "--to", "csv", "--karnaugh"},
        {"equations", chart, "--standalone"},
        {"netlist", chart, "--style", "nand", "--to", "verilog", "--scan", "1ms"},
        {"netlist", chart, "--style", "nand", "--to", "verilog", "--stim", stim},
        {"netlist", chart, "--style", "nand", "--to", "verilog", "--bench"},
        {"netlist", chart, "--style", "nand", "--to", "verilog", "--bench", "--stim", stim},
        {"check", chart, "--against", plain, "--style", "nand"},
        {"check", chart, "--against", plain, "--power-up", "initial"},
        {"check", chart, "--power-up", "initial"},
        {"check", chart, "--program", "p"},
        {"check", chart, "--cpu", "212"},
        {"check", chart, "--scan", "1ms"},
        {"check", chart, "--style", "clocked", "--changes", "many"},
        {"check", chart, "--against", "x.awl", "--delay", "unit"},
        {"check", chart, "--against", "x.awl"},
        {"check", chart, "--against", "x.txt"},
        {"s7", "run", "a.awl", "--stim", stim, "--scan", "1ms", "--grafcet", chart},
        // Files.
        {"info", folder.path("none.grafcet")},
        {"run", folder.path("")},
        {"info", folder.path("*.none")},
        {"draw", chart, stim, "zz"},
        {"equations", chart, "-o", folder.path("none/x")},
        {"equations", chart, "-o", folder.path("")},
        {"equations", chart, "-o", chart},
        {"equations", chart, "-o", folder.path("none/x/y")},
        {"run", chart, stim, "-o", folder.path("x"), "--vcd", folder.path("x")},
        {"equations", chart, "-o", "/dev/full"},
        {"check", example("rule-5.grafcet"), "--witness", plain, "--style", "nor"},
        // Netlists from elsewhere.
        blif("ports", ".names a X0\n1 1\n.end\n"),
        blif("driver", ".names a X0\n1 1\n.names b X0\n1 1\n.end\n"),
        blif("open", ".names z X0\n1 1\n.end\n"),
        blif("twice", ".outputs X0\n.names a X0\n1 1\n.end\n"),
        blif("clock", ".latch a X0 re z 2\n.names a z\n1 1\n.end\n"),
        blif("clocks", ".latch a X0 re a 2\n.latch a y re b 2\n.end\n"),
        blif("row", ".names a X0\n1z 1\n.end\n"),
        blif("rows", ".names a X0\n1 1\n0 0\n.end\n"),
        blif("names", ".names\n.end\n"),
        blif("latch", ".latch\n.latch a X0 fe b 2\n.latch a X0 re b 7\n.end\n"),
        blif("box", ".subckt\n.subckt zz a=b\n.subckt grafwire_latch s=a\n.end\n"),
        blif("pin", ".subckt grafwire_latch zz=a\n.gate zz\n.zzz\n.end\n"),
        blif("models", ".names a X0\n1 1\n.end\n.model n\n.names a\n1\n.end\n"),
        {"check", chart, "--against", folder.file("empty.blif", "")},
        {"check", chart, "--against", folder.file("start.blif", "zz\n")},
        json("none", "{}"),
        json("modules", "{\"modules\": {}}"),
        json("two", "{\"modules\": {\"m\": {}, \"n\": {}}}"),
        json("deep", std::string(50, '[')),
        json("wide",
             "{\"modules\": {\"m\": {\"ports\": {\"a\": {\"direction\": \"input\", "
             "\"bits\": [2, 3]}, \"b\": {\"bits\": [4]}, \"c\": {\"direction\": "
             "\"input\", \"bits\": [\"x\"]}}}}}"),
        cell("bare", "{\"type\": \"$_NOT_\"}"),
        cell("open", "{\"type\": \"$_NOT_\", \"connections\": {\"A\": [2]}}"),
        cell("pins", "{\"type\": \"$_NOT_\", \"connections\": {\"A\": [2, 2], \"Y\": [3]}}"),
        cell("fixed", "{\"type\": \"$_NOT_\", \"connections\": {\"A\": [2], \"Y\": [\"1\"]}}"),
        cell("edge",
             "{\"type\": \"$_DFF_N_\", \"connections\": {\"D\": [2], \"C\": [2], "
             "\"Q\": [3]}}"),
        cell("set", "{\"type\": \"$_DFFSR_PPP_\", \"connections\": {\"Q\": [3]}}"),
        cell("lut",
             "{\"type\": \"$lut\", \"parameters\": {\"LUT\": \"1\"}, \"connections\": "
             "{\"A\": [2], \"Y\": [3]}}"),
        cell("type", "{\"type\": \"$zz\", \"connections\": {\"Y\": [3]}}"),
        cell("module", "{\"type\": \"zz\", \"connections\": {\"Y\": [3]}}"),
    };
    for (const Request& request : requests) {
        std::ostringstream told;
        for (const std::string& word : request) told << word << ' ';
        INFO("request: " << told.str());
        Request in_french{"--lang", "fr"};
        in_french.insert(in_french.end(), request.begin(), request.end());
        const Ran ran = grafwire_with(in_french);
        CHECK(ran.status == 2);
        CHECK((contains(ran.err, "erreur") || contains(ran.err, "les ports ne correspondent pas")));
        CHECK(english_in(ran.err) == "");
    }
}

TEST_CASE("a JUnit report of a refused request does not depend on the language") {
    const Request request{"check", chart, "--scan", "1h", "--to", "junit"};
    Request in_french = request;
    in_french.insert(in_french.end(), {"--lang", "fr"});
    CHECK(english_in(grafwire_with(in_french).err) == "");
    const auto without_time = [](std::string text) {
        const std::size_t at = text.find(" time=");
        return at == std::string::npos ? text : text.substr(0, at);
    };
    CHECK(contains(grafwire_with(in_french).out, "has no effect here"));
    CHECK(without_time(grafwire_with(in_french).out) == without_time(grafwire_with(request).out));
}

}  // namespace grafwire::testing
