// S7-200 listings: `s7 run` and `check --against`.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/json_schema.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::string listing(const std::string& name) {
    return example("s7-200/" + name);
}

}  // namespace

TEST_CASE("s7 run: names are addresses, those of a table, or those of a GRAFCET") {
    const ScratchFolder folder;
    const std::string program =
        folder.file("p.awl", "NETWORK1\nLD E0.0\nUN E0.1\n= V20.0\n= A0.3\nMEND\n");
    const std::string by_address = folder.file("a.stim", "0ms : \"E0.0\"=1\n10ms : \"E0.1\"=1\n");
    const Ran plain = grafwire_with({"s7", "run", program, "--stim", by_address, "--scan", "10ms"});
    CHECK(plain.status == 0);
    CHECK(plain.err.empty());
    CHECK(plain.out == "time_ms,E0.0,E0.1,Init,AUdur,AUdoux,A0.3\n0,1,0,0,0,0,1\n10,1,1,0,0,0,0\n");
    const std::string table = folder.file(
        "t.io", "A0.3 = lamp\nV20.0 = X1\nE0.1 = AUdur\nE0.0 = go\nV0.0 = G\nV80.0 = (0)\n");
    const std::string by_name = folder.file("n.stim", "0ms : go=1\n10ms : AUdur=1 Init=1\n");
    const Ran named =
        grafwire_with({"s7", "run", program, "--stim", by_name, "--scan", "10ms", "--io", table});
    CHECK(named.status == 0);
    CHECK(named.err ==
          "grafwire: warning: the listing has no input Init: what the stimuli say of it is left "
          "out\n");
    CHECK(named.out == "time_ms,go,Init,AUdur,AUdoux,X1,lamp\n0,1,0,0,0,1,1\n10,1,0,1,0,0,0\n");
}

TEST_CASE("s7 run: the corrected manipulator in the columns of its GRAFCET is the reference") {
    const ScratchFolder folder;
    const std::string chart = example("manipulator.grafcet");
    const std::string stimuli =
        folder.file("m.stim", "0ms : v0=1 h0=1\n100ms : dcy=1\n+1s : h1=1\n+1s : end\n");
    const Ran reference = grafwire_with({"run", chart, stimuli, "--scan", "20ms"});
    const Ran ran =
        grafwire_with({"s7", "run", listing("manipulator.awl"), "--stim", stimuli, "--scan", "20ms",
                       "--io", listing("manipulator.io"), "--grafcet", chart});
    CHECK(ran.status == 0);
    CHECK(ran.out == reference.out);
}

TEST_CASE("s7 run: what is wrong ends with 2, and nothing is written") {
    const ScratchFolder folder;
    const std::string stimuli = folder.file("s.stim", "0ms : end\n");
    const std::string out = folder.path("trace.csv");
    const auto run = [&](const std::string& program, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments = {"s7",     "run",  program, "--stim", stimuli,
                                              "--scan", "10ms", "-o",    out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = grafwire_with(arguments);
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        return ran.err;
    };
    CHECK(contains(run(folder.file("a.awl", "NETWORK1\nLDX E0.0\nMEND\n")),
                   "a.awl:2:1: error: unknown instruction 'LDX'; did you mean 'LD'?"));
    CHECK(contains(run(folder.file("b.awl", "NETWORK7\nLBL K1\nLD SM0.0\nJMP K1\nMEND\n")),
                   "at 0 ms, network 7, line "));
    const std::string good = folder.file("c.awl", "NETWORK1\nLD E0.0\n= A0.0\nMEND\n");
    CHECK(
        contains(run(good, {"--grafcet", example("manipulator.grafcet")}), "--grafcet needs --io"));
    CHECK(contains(run(good, {"--io", folder.file("d.io", "A0.9 = a\n")}),
                   "d.io:1:1: error: 'A0.9' is not an address"));
    CHECK(contains(run(listing("manipulator.printed.awl"), {"--cpu", "212"}),
                   "T110: the CPU 212 has 64 places of this area"));
    CHECK(folder.names() == std::vector<std::string>{"a.awl", "b.awl", "c.awl", "d.io", "s.stim"});
}

TEST_CASE("check --against a listing: equivalent, or the network it comes from") {
    const std::string chart = example("manipulator.grafcet");
    const Ran good = grafwire_with({"check", chart, "--against", listing("manipulator.awl"), "--io",
                                    listing("manipulator.io")});
    CHECK(good.status == 0);
    CHECK(good.err.empty());
    CHECK(contains(good.out, "manipulator.grafcet: equivalent (program "));
    CHECK(contains(good.out, "  scan period: 100ms; "));
    const ScratchFolder folder;
    const Ran bad = grafwire_with({"check", chart, "--against", listing("manipulator.printed.awl"),
                                   "--io", listing("manipulator.io"), "--scan", "500ms",
                                   "--witness", folder.path("w"), "--to", "json", "--lang", "fr"});
    CHECK(bad.status == 1);
    const auto report = nlohmann::json::parse(bad.out);
    CHECK(schema_problems(bad.out) == "");
    CHECK(report["verdict"] == "different");
    CHECK(report["period"] == "500ms");
    CHECK(report["witness"]["files"].size() == 9);
    CHECK(report["witness"]["cause"].is_null());
    CHECK(report["witness"]["story"].back() == "      189  S     V70.0   K4");
    CHECK(contains(text_of(folder.path("w/witness.txt")), "l'a écrit : réseau 49"));
    // The witness replays.
    const Ran replayed =
        grafwire_with({"run", chart, folder.path("w/witness.stim"), "--scan", "500ms"});
    CHECK(replayed.out == text_of(folder.path("w/expected.csv")));
}

TEST_CASE("check --against a listing: what is asked for") {
    const ScratchFolder folder;
    const std::string chart = example("manipulator.grafcet");
    const Ran no_table = grafwire_with({"check", chart, "--against", listing("manipulator.awl")});
    CHECK(no_table.status == 2);
    CHECK(contains(no_table.err, "needs a table that says which address is which input"));
    const std::string half =
        folder.file("half.io", text_of(listing("manipulator.io")) + "E1.0 = Init\n");
    const Ran one_mode =
        grafwire_with({"check", chart, "--against", listing("manipulator.awl"), "--io", half});
    CHECK(one_mode.status == 2);
    CHECK(contains(one_mode.err, "Init, AUdur and AUdoux: give all three an address, or none"));
}

TEST_CASE("what plc --to s7-200 writes, the check finds equivalent") {
    const ScratchFolder folder;
    for (const std::string name : {"single-sequence", "rule-5", "manipulator", "press"}) {
        CAPTURE(name);
        const std::string chart = example(name + ".grafcet");
        const std::string program = folder.path(name + ".awl");
        const std::string table = folder.path(name + ".io");
        const Ran made =
            grafwire_with({"plc", chart, "--to", "s7-200", "--addresses", table, "-o", program});
        REQUIRE(made.status == 0);
        const Ran ran = grafwire_with({"check", chart, "--against", program, "--io", table});
        CHECK(ran.status == 0);
        CHECK(contains(ran.out, ": equivalent (program "));
    }
}

}  // namespace grafwire::testing
