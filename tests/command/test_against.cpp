// `check --against`: netlists from elsewhere.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/charts.h"
#include "command/json_schema.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::string netlist(const std::string& format, const std::string& style) {
    const Ran ran = grafwire_with({"netlist", sequence_chart, "--style", style, "--to", format});
    CHECK(ran.status == 0);
    return ran.out;
}

Ran check_against(const std::string& file) {
    return grafwire_with({"check", sequence_chart, "--against", file});
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    REQUIRE(contains(text, from));
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
        text.replace(at, from.size(), to);
    }
    return text;
}

/// A student's wiring of the three steps: phase modules by hand, with the modes. `cdx2` is what
/// resets step 2.
std::string students_wiring(const std::string& cdx2) {
    return ".model student\n"
           ".inputs m a b Init AUdur AUdoux\n"
           ".outputs X0 X1 X2\n"
           ".names X2 b X1 X0 Init AUdur X0\n"
           "11---0 1\n--01-0 1\n----10 1\n"
           ".names X0 m X2 X1 Init AUdur X1\n"
           "11--00 1\n--0100 1\n"
           ".names X1 a " +
           cdx2 +
           " X2 Init AUdur X2\n"
           "11--00 1\n--0100 1\n"
           ".end\n";
}

}  // namespace

TEST_CASE("the netlist that was written, read back") {
    const ScratchFolder folder;
    for (const std::string format : {"blif", "json"}) {
        for (const std::string& style : choices_of("netlist", "--style")) {
            INFO("format: " << format << ", style: " << style);
            const std::string file = folder.file("n." + format, netlist(format, style));
            const Ran ran = check_against(file);
            CHECK(ran.status == 0);
            CHECK(ran.err.empty());
            CHECK(contains(ran.out, ": equivalent (netlist " + file));
        }
    }
}

TEST_CASE("a wiring by hand: a good one, and one with a slip") {
    const ScratchFolder folder;
    const Ran good = check_against(folder.file("good.blif", students_wiring("X0")));
    CHECK(good.status == 0);
    CHECK(good.err.empty());
    // Step 2 reset by step 1, which is still up when step 2 begins.
    const std::string slip = folder.file("slip.blif", students_wiring("X1"));
    const Ran wrong = check_against(slip);
    CHECK(wrong.status == 1);
    CHECK(contains(wrong.out, ": different (netlist " + slip));
    CHECK(contains(wrong.out, "\nWitness:\n"));
    // Its witness replays on the same netlist.
    const Ran with_files =
        grafwire_with({"check", sequence_chart, "--against", slip, "--witness", folder.path("w")});
    CHECK(with_files.status == 1);
    const std::string stim = folder.path("w/witness.stim");
    const Ran run = grafwire_with({"run", sequence_chart, stim});
    const Ran gates = grafwire_with({"simulate", sequence_chart, stim, "--against", slip});
    CHECK(run.status == 0);
    CHECK(run.out != gates.out);
    CHECK(text_of(folder.path("w/got.csv")) == gates.out);
}

TEST_CASE("a wiring without Init: at power-up anything, or the initial situation as given") {
    const ScratchFolder folder;
    const std::string file = folder.file("bare.blif",
                                         ".model bare\n"
                                         ".inputs m a b\n"
                                         ".outputs X0 X1 X2\n"
                                         ".names X2 b X1 X0 X0\n11-- 1\n--01 1\n"
                                         ".names X0 m X2 X1 X1\n11-- 1\n--01 1\n"
                                         ".names X1 a X0 X2 X2\n11-- 1\n--01 1\n"
                                         ".end\n");
    const auto checked = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"check", sequence_chart, "--against", file});
        return grafwire_with(arguments);
    };
    const Ran unknown = checked({});
    CHECK(unknown.status == 1);
    CHECK(contains(unknown.out, "; power-up: unknown\n"));
    CHECK(contains(unknown.out, "Give it an input Init or\ninitial values; or check with "));
    const Ran given = checked({"--power-up", "initial"});
    CHECK(given.status == 0);
    CHECK(contains(given.out, "; power-up: initial situation, taken as given\n"));
    for (const bool is_given : {false, true}) {
        const Ran ran = checked({"--to", "json", "--power-up", is_given ? "initial" : "unknown"});
        CHECK(schema_problems(ran.out) == "");
        const auto json = nlohmann::json::parse(ran.out);
        CHECK(json["power_up"] == (is_given ? "given" : "unknown"));
        if (!is_given) CHECK(json["witness"]["kind"] == "power-up");
    }
    // Nothing is to be said of the power-up of a netlist that has an Init.
    const Ran refused =
        grafwire_with({"check", sequence_chart, "--power-up", "initial", "--against",
                       folder.file("good.blif", students_wiring("X0"))});
    CHECK(refused.status == 2);
    CHECK(contains(refused.err, "--power-up has no effect here"));
}

TEST_CASE("a wrong gate in a JSON netlist") {
    const ScratchFolder folder;
    auto json = nlohmann::ordered_json::parse(netlist("json", "nand"));
    // The first NAND becomes an AND.
    bool done = false;
    for (auto& cell : json["modules"].begin().value()["cells"]) {
        if (!done && cell["type"] == "$_NAND_") {
            cell["type"] = "$_AND_";
            done = true;
        }
    }
    REQUIRE(done);
    const Ran ran = check_against(folder.file("wrong.json", json.dump()));
    CHECK(ran.status == 1);
    CHECK(contains(ran.out, ": different ("));
}

TEST_CASE("pulses of an input that the chart does not look at in that situation") {
    const ScratchFolder folder;
    for (const std::string back : {"c . /s", "/e"}) {
        const std::string own = folder.file("pulses.grafcet",
                                            "grafcet pulses\n"
                                            "input s, e, c\n"
                                            "graph G {\n"
                                            "  initial 0\n"
                                            "  step 1\n"
                                            "  step 2\n"
                                            "  0 -> 1 : ↑s . e\n"
                                            "  1 -> 2 : /s\n"
                                            "  2 -> 0 : " +
                                                back + "\n}\n");
        const std::string good =
            grafwire_with({"netlist", own, "--style", "nand", "--modes", "off", "--to", "blif"})
                .out;
        const auto check = [&](const std::string& file) {
            return grafwire_with({"check", own, "--against", file, "--changes", "many", "--witness",
                                  folder.path("w")});
        };
        CHECK(check(folder.file("good.blif", good)).status == 0);
        // `n` changes 7 ns after a rise of c, and then `late` is 1, just as `w` is 1 some ns after
        // a rise of s: both together activate step 1 without e.
        for (const bool rising : {true, false}) {
            const std::string late = rising ? "rise_pulse" : "fall_pulse";
            const std::string set = ".names X1$set0 X1$q X1\n11 0\n";
            const std::string bad =
                replaced(good, set,
                         ".names c c1\n1 1\n.names c1 c2\n1 1\n.names c2 c3\n1 1\n"
                         ".names c3 c4\n1 1\n.names c4 c5\n0 1\n"
                         ".names c c5 n\n11 " +
                             std::string(rising ? "0" : "1") +
                             "\n"
                             ".subckt grafwire_" +
                             late +
                             " a=n q=late\n.attr FALL \"0.002us\"\n"
                             ".subckt grafwire_rise_pulse a=s q=w0\n.attr FALL \"0.004us\"\n"
                             ".names w0 w1\n1 1\n.names w1 w2\n1 1\n.names w2 w3\n1 1\n"
                             ".names w3 w4\n1 1\n.names w4 w\n1 1\n"
                             ".names X0 late w X1$late\n111 0\n"
                             ".names X1$set0 X1$late X1$q X1\n111 0\n");
            const std::string file = folder.file("bad.blif", bad);
            const Ran wrong = check(file);
            INFO("back: " << back << ", " << late << "\n" << wrong.out << wrong.err);
            CHECK(wrong.status == 1);
            const std::string stim = folder.path("w/witness.stim");
            const Ran run = grafwire_with({"run", own, stim});
            const Ran gates = grafwire_with({"simulate", own, stim, "--against", file});
            CHECK(gates.status == 0);
            CHECK(run.out != gates.out);
        }
    }
}

TEST_CASE("ports that do not fit: a table and status 2") {
    const ScratchFolder folder;
    const std::string good = students_wiring("X0");
    const std::string file =
        folder.file("ports.blif", replaced(replaced(good, "X2", "Y2"), " m", " go"));
    const Ran ran = check_against(file);
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(contains(ran.err, file + ": the ports do not fit " + sequence_chart + ":\n"));
    CHECK(contains(ran.err, "X2\n"));
    CHECK(contains(ran.err, "Y2\n"));
    CHECK(contains(ran.err, " m\n"));
    CHECK(contains(ran.err, " go\n"));
    CHECK(contains(grafwire_with({"check", sequence_chart, "--against", file, "--lang", "fr"}).err,
                   "manquante"));
    const std::string json = replaced(netlist("json", "nand"), "\"X1\"", "\"Z1\"");
    const Ran in_json = check_against(folder.file("ports.json", json));
    CHECK(in_json.status == 2);
    CHECK(contains(in_json.err, "X1\n"));
    CHECK(contains(in_json.err, "Z1\n"));
}

TEST_CASE("a file that is no netlist") {
    const ScratchFolder folder;
    const Ran kind = check_against(folder.file("n.v", "module x; endmodule\n"));
    CHECK(kind.status == 2);
    CHECK(contains(kind.err, ".blif"));
    const std::string broken =
        folder.file("broken.blif", replaced(students_wiring("X0"), "----10 1", "----10 7"));
    const Ran blif = check_against(broken);
    CHECK(blif.status == 2);
    CHECK(contains(blif.err, broken + ":7:"));
    const Ran json = check_against(folder.file("broken.json", "{ \"modules\": "));
    CHECK(json.status == 2);
    CHECK(contains(json.err, "broken.json:1:"));
    const Ran missing = check_against(folder.path("none.blif"));
    CHECK(missing.status == 2);
    CHECK(contains(missing.err, "cannot read the file"));
    CHECK((kind.out + blif.out + json.out + missing.out).empty());
}

}  // namespace grafwire::testing
