// Gates that take times of their own, from a file.

#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "command/charts.h"
#include "command/json_schema.h"
#include "support/files.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// At 300 ms m rises: X1$set0 falls, X1 rises, X0$reset0 falls, X0$q rises, X0 falls.
constexpr std::string_view slow_gates = R"(
X1$set0  2 3           # rise, fall
at 300ms + 5
X0$q     4
at 1s
X0       900
)";

/// `grafwire simulate` of the sequence, with a file of delays that holds this.
Ran simulate_with(const std::string& delays, const std::vector<std::string>& more) {
    const ScratchFolder folder;
    folder.file("gates.delays", delays);
    std::vector<std::string> request = {"simulate", sequence_chart, sequence_stimuli, "--delays",
                                        folder.path("gates.delays")};
    request.insert(request.end(), more.begin(), more.end());
    return grafwire_with(request);
}

}  // namespace

TEST_CASE("delays of single gates show in an instant") {
    const Ran ran = simulate_with(std::string(slow_gates),
                                  {"--style", "nand", "--zoom", "300ms", "--to", "wavedrom"});
    CHECK(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    const std::vector<std::string> times = json["signal"][0]["data"];
    CHECK(times == std::vector<std::string>{"before", "0ns", "3ns", "4ns", "5ns", "9ns", "10ns",
                                            "11ns", "12ns"});
    // As many causes as under equal delays: each is found by the delay that was in force.
    CHECK(json["edge"].size() == 8);
}

TEST_CASE("delays of single gates are told in words") {
    const Ran ran = simulate_with(std::string(slow_gates), {"--style", "nand", "--explain"});
    CHECK(ran.status == 0);
    CHECK(contains(ran.out,
                   "  X1 becomes 1 after 4 ns: m=1, NAND gate X1$set0=0 (+3 ns)\n"
                   "  X0 becomes 0 after 10 ns: X1=1, NAND gate X0$reset0=0 (+5 ns), NAND gate\n"
                   "      X0$q=1 (+9 ns)\n"));
}

TEST_CASE("delays: a check about every circuit ends with one that fails, and it can be run") {
    const ScratchFolder folder;
    const Ran check = grafwire_with({"check", sequence_chart, "--style", "nand", "--delay", "any",
                                     "--witness", folder.path("witness")});
    CHECK(check.status == 1);
    CHECK(contains(check.out, "delays: any finite one of every gate;"));
    CHECK(
        contains(check.out, "The delays that it takes (every other gate is as fast as can be):\n"));
    CHECK(contains(check.out, "A race of gates: "));
    const std::vector<std::string> request = {
        "simulate", sequence_chart, folder.path("witness/witness.stim"), "--style", "nand",
        "--delay",  "any"};
    const Ran open = grafwire_with(request);
    CHECK(open.status == 2);
    CHECK(contains(open.err, "--delay any leaves the delays of gates open"));
    std::vector<std::string> with_delays = request;
    with_delays.insert(with_delays.end(), {"--delays", folder.path("witness/witness.delays")});
    const Ran run = grafwire_with(with_delays);
    CHECK(run.status == 0);
    CHECK(run.out == text_of(folder.path("witness/got.csv")));
    CHECK(run.out != text_of(folder.path("witness/expected.csv")));
    // Those of a difference that is no more go with it.
    CHECK(grafwire_with(
              {"check", sequence_chart, "--style", "nand", "--witness", folder.path("witness")})
              .status == 0);
    CHECK(!std::filesystem::exists(folder.path("witness/witness.delays")));
}

TEST_CASE("delays: the clocked style has none to be open, and a model has to be one") {
    const Ran clocked =
        grafwire_with({"check", sequence_chart, "--style", "clocked", "--delay", "any"});
    CHECK(clocked.status == 2);
    CHECK(contains(clocked.err, "clock"));
    const Ran wrong = grafwire_with({"check", sequence_chart, "--delay", "2..1"});
    CHECK(wrong.status == 2);
    CHECK(contains(wrong.err, "--delay: 2..1 not in {unit,MIN..MAX,any,any-wire,"));
}

TEST_CASE("delays: bounds in JSON and in French") {
    const Ran json = grafwire_with(
        {"check", sequence_chart, "--style", "nand", "--delay", "1..1.5", "--to", "json"});
    CHECK(json.status == 0);
    CHECK(nlohmann::json::parse(json.out)["delay"] == "1..1.5");
    const Ran french = grafwire_with(
        {"check", sequence_chart, "--style", "nand", "--delay", "1..1.5", "--lang", "fr"});
    CHECK(contains(french.out, "retards\u00a0: 1 à 1.5\u00a0ns par changement de porte"));
}

TEST_CASE("delays: a report says which figures of a part family it rests on") {
    const std::vector<std::string> request = {"check", sequence_chart, "--style",
                                              "nand",  "--delay",      "74HC"};
    const Ran check = grafwire_with(request);
    CHECK(check.status == 1);
    CHECK(contains(check.out, "  delays: 74HC, as far as its data sheets let gates differ; "));
    CHECK(contains(check.out,
                   "  every change of a gate takes, in ns:\n"
                   "    NOT gate: 2 to 24 (74HC04: TI-HC, LT)\n"));
    CHECK(contains(check.out,
                   "    NAND gate, 2 inputs: 1 to 23 (74HC00: Philips 74HC/HCT00, TI-HC, LT)\n"));
    CHECK(contains(check.out, "; no maximum was found: that of the next wider gate)\n"));
    std::vector<std::string> as_json = request;
    as_json.insert(as_json.end(), {"--to", "json"});
    const auto json = nlohmann::json::parse(grafwire_with(as_json).out);
    CHECK(json["delay"] == "74HC");
    CHECK(json["figures"][0]["cell"] == "not");
    CHECK(json["figures"][0]["rise"] == std::vector<double>{2, 24});
    CHECK(json["figures"][0]["part"] == "74HC04");
}

TEST_CASE("delays: gates wider than any part are told, and edges that differ") {
    const ScratchFolder folder;
    folder.file("wide.blif",
                ".model wide\n.inputs a b c Init AUdur AUdoux\n.outputs X0\n"
                ".names a b c ab\n1-- 1\n-1- 1\n--1 1\n"
                ".names Init ab X0\n1- 1\n-1 1\n-0 1\n.end\n");
    folder.file("one.grafcet", "input a\ninput b\ninput c\ngraph G {\n  initial 0\n}\n");
    const Ran check = grafwire_with({"check", folder.path("one.grafcet"), "--against",
                                     folder.path("wide.blif"), "--delay", "74LS", "--lang", "fr"});
    CHECK(contains(check.out, "retards : 74LS, autant que ses notices laissent les portes"));
    CHECK(contains(check.out,
                   "    porte OU, 3 entrées : 3 à 66 (composée de plusieurs, prise pour une "
                   "seule porte)\n"));
}

TEST_CASE("delays: of wires as well, and the witness names them") {
    const ScratchFolder folder;
    const Ran check = grafwire_with({"check", sequence_chart, "--style", "nand", "--delay",
                                     "any-wire", "--witness", folder.path("witness")});
    CHECK(check.status == 1);
    CHECK(contains(check.out, "  delays: any finite one of every gate and of every wire; "));
    const Ran run = grafwire_with({"simulate", sequence_chart, folder.path("witness/witness.stim"),
                                   "--style", "nand", "--delay", "any-wire", "--delays",
                                   folder.path("witness/witness.delays")});
    CHECK(run.status == 0);
    CHECK(run.out == text_of(folder.path("witness/got.csv")));
    CHECK(run.out != text_of(folder.path("witness/expected.csv")));
}

TEST_CASE("a wire takes the time that a file gives it, and none else") {
    // m reaches X1$set0 20 ns after what else it reaches.
    const Ran slow = simulate_with("m->X1$set0 20\n", {"--style", "nand", "--explain"});
    CHECK(slow.status == 0);
    CHECK(contains(slow.out, "  X1 becomes 1 after 22 ns: m=1, buffer m->X1$set0=1 (+20 ns), "));
    const Ran none = simulate_with("m->X0 20\n", {"--style", "nand"});
    CHECK(none.status == 2);
    CHECK(contains(none.err, "the netlist has no net 'm->X0'"));
}

TEST_CASE("a check finds how much delays may differ") {
    const std::vector<std::string> request = {"check", sequence_chart, "--style", "nand",
                                              "--tolerance"};
    const Ran check = grafwire_with(request);
    CHECK(check.status == 0);
    CHECK(contains(check.out,
                   "\nTolerance: it holds as long as no change of a gate takes more than "));
    CHECK(contains(check.out, " times it does not:\n  0s : "));
    CHECK(contains(check.out, "A race of gates: "));
    std::vector<std::string> as_json = request;
    as_json.insert(as_json.end(), {"--to", "json"});
    const auto json = nlohmann::json::parse(grafwire_with(as_json).out);
    CHECK(json["verdict"] == "equivalent");
    CHECK(json["tolerance"]["holds"] < json["tolerance"]["fails"]);
    CHECK(json["tolerance"]["unlimited"] == false);
    CHECK(json["tolerance"]["witness"]["kind"] == "situation");
    const Ran handshake =
        grafwire_with({"check", sequence_chart, "--style", "handshake", "--tolerance"});
    CHECK(contains(handshake.out,
                   "\nTolerance: it holds however much the delays of gates differ.\n"));
    const Ran clocked =
        grafwire_with({"check", sequence_chart, "--style", "clocked", "--tolerance"});
    CHECK(clocked.status == 2);
}

namespace {

constexpr const char* selection_chart =
    "input a, b, c\noutput v\ngraph G {\n  initial 0 : v if a.b + /a.c\n}\n";

/// How often a net of a waveform changes in the last instant at which anything does.
std::size_t changes_at_end(const std::string& vcd, const std::string& net) {
    const std::size_t name = vcd.find(" " + net + " $end");
    REQUIRE(name != std::string::npos);
    const std::size_t before = vcd.rfind(' ', name - 1);
    const std::string id = vcd.substr(before + 1, name - before - 1);
    std::size_t changes = 0;
    std::uint64_t at = 0;
    std::istringstream lines(vcd.substr(vcd.find("$enddefinitions")));
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) continue;
        if (line[0] == '#') {
            // Gates answer within nanoseconds, instants are far apart.
            const std::uint64_t last = std::exchange(at, std::stoull(line.substr(1)));
            if (at - last > at / 100) changes = 0;
        } else if (line.substr(1) == id) {
            ++changes;
        }
    }
    return changes;
}

}  // namespace

TEST_CASE("a check finds outputs that change too often, and they can be run") {
    const ScratchFolder folder;
    folder.file("selection.grafcet", selection_chart);
    const std::string chart = folder.path("selection.grafcet");
    for (const std::string delay : {"any", "any-wire", "1..2", "74HC"}) {
        CAPTURE(delay);
        const std::vector<std::string> request = {"check",   chart, "--style", "gates",
                                                  "--delay", delay, "--pulses"};
        std::vector<std::string> as_json = request;
        as_json.insert(as_json.end(), {"--to", "json"});
        const Ran ran = grafwire_with(as_json);
        CHECK(schema_problems(ran.out) == "");
        std::vector<std::string> by_two = as_json;
        by_two.insert(by_two.end(), {"-j", "2"});
        CHECK(grafwire_with(by_two).out == ran.out);
        const auto json = nlohmann::json::parse(ran.out);
        REQUIRE(json["pulses"].size() == 1);
        const auto& pulse = json["pulses"][0];
        CHECK(pulse["name"] == "v");
        CHECK(pulse["expected"] == 0);
        CHECK(pulse["got"] == 2);
        CHECK(json["pulses_open"].empty());
        folder.file("v.stim", pulse["stimuli"].get<std::string>());
        folder.file("v.delays", pulse["delays"].get<std::string>());
        const std::string vcd = folder.path("v.vcd");
        CHECK(grafwire_with({"simulate", chart, folder.path("v.stim"), "--style", "gates",
                             "--delay", delay, "--delays", folder.path("v.delays"), "--vcd", vcd})
                  .status == 0);
        CHECK(changes_at_end(text_of(vcd), "v") == 2);
    }
}

TEST_CASE("pulses are told beside the verdict, in the language asked for") {
    const ScratchFolder folder;
    folder.file("selection.grafcet", selection_chart);
    std::vector<std::string> request = {
        "check",   folder.path("selection.grafcet"), "--style", "gates", "--delay", "any",
        "--pulses"};
    const Ran english = grafwire_with(request);
    CHECK(english.status == 0);
    CHECK(contains(english.out,
                   "\nv: 2 changes in one instant, and the reference asks for none\n"
                   "Gates that race: AND gate v$1 of output v, "));
    CHECK(contains(english.out, "\nStimuli:\n  0s : "));
    request.insert(request.end(), {"--to", "junit"});
    const Ran junit = grafwire_with(request);
    CHECK(junit.status == 0);
    CHECK(contains(junit.out, " failures=\"0\" errors=\"0\""));
    CHECK(contains(junit.out, "v: 2 changes in one instant"));
    request.resize(request.size() - 2);
    request.insert(request.end(), {"--lang", "fr"});
    CHECK(contains(grafwire_with(request).out,
                   "2 changements en un seul instant, et la référence n'en demande aucun\n"));
    const Ran handshake = grafwire_with(
        {"check", sequence_chart, "--style", "handshake", "--delay", "any", "--pulses"});
    CHECK(handshake.status == 0);
    CHECK(contains(handshake.out, "\nPulses: none. No X and no output changes more often "));
    const Ran bounded = grafwire_with(
        {"check", sequence_chart, "--style", "handshake", "--pulses", "--max-cases", "5"});
    CHECK(bounded.status == 3);
    CHECK(contains(bounded.out, "\nPulses: none found, and not everything could be looked at.\n"));
}

TEST_CASE("delays of single gates are in the waveform") {
    const ScratchFolder folder;
    folder.file("gates.delays", "X1 2500ps\n");
    const std::string vcd = folder.path("out.vcd");
    const Ran ran = grafwire_with({"simulate", sequence_chart, sequence_stimuli, "--delays",
                                   folder.path("gates.delays"), "--style", "nand", "--vcd", vcd});
    CHECK(ran.status == 0);
    const std::string text = text_of(vcd);
    CHECK(contains(text, "1 ps"));
    CHECK(contains(text, "\n#300000003500\n"));
}

TEST_CASE("a netlist from a file takes delays by the names of its nets") {
    const ScratchFolder folder;
    const std::string blif = folder.path("a.blif");
    CHECK(grafwire_with({"netlist", sequence_chart, "--style", "nand", "--to", "blif", "-o", blif})
              .status == 0);
    const Ran ran = simulate_with("X1 5\n", {"--against", blif, "--explain"});
    CHECK(ran.status == 0);
    CHECK(contains(ran.out, "X1 becomes 1 after 6 ns"));
}

TEST_CASE("a slow gate can break a wiring that is right with equal delays") {
    const std::vector<std::string> nand = {"--style", "nand"};
    const Ran right = simulate_with("", nand);
    CHECK(right.status == 0);
    CHECK(right.out ==
          grafwire_with({"simulate", sequence_chart, sequence_stimuli, "--style", "nand"}).out);
    // X0 is off before the latch of X1 holds: no step is left.
    const Ran wrong = simulate_with("X1$q 1 20\n", nand);
    CHECK(wrong.status == 0);
    CHECK(contains(right.out, "\n300,1,0,0,0,0,0,0,1,0\n"));
    CHECK(contains(wrong.out, "\n300,1,0,0,0,0,0,0,0,0\n"));
}

TEST_CASE("mistakes in a file of delays are shown at their place") {
    const Ran ran = simulate_with("X1$sat0 3\n", {"--style", "nand"});
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(contains(ran.err,
                   "gates.delays:1:1: error: the netlist has no net 'X1$sat0'; did you "
                   "mean 'X1$set0'?"));
    const Ran clocked = simulate_with("X1 3\n", {"--style", "clocked"});
    CHECK(clocked.status == 2);
    CHECK(contains(clocked.err, "--delays has no effect here: it is for netlists without a clock"));
    const Ran missing = grafwire_with({"simulate", sequence_chart, sequence_stimuli, "--style",
                                       "nand", "--delays", "no-such.delays"});
    CHECK(missing.status == 2);
}

TEST_CASE("delays come from standard input where nothing else does") {
    const std::vector<std::string> request = {
        "simulate", sequence_chart, sequence_stimuli, "--style",
        "nand",     "--explain",    "--delays",       "-"};
    CHECK(contains(grafwire_with(request, "X1 5\n").out, "X1 becomes 1 after 6 ns"));
    const Ran both =
        grafwire_with({"simulate", "-", sequence_stimuli, "--style", "nand", "--delays", "-"});
    CHECK(both.status == 2);
    CHECK(contains(both.err, "the delays cannot come from standard input"));
}

}  // namespace grafwire::testing
