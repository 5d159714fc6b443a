#include <doctest/doctest.h>

#include <string>

#include "playground/asked.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// A run of the page that goes through a witness; its last state.
Json replayed(AskedCore& core, Json args, const Json& witness) {
    if (witness.contains("period")) args["period"] = witness.at("period");
    Json state = ask(core, "run.open", args);
    for (const Json& instant : witness.at("instants")) {
        state = ask(
            core, "run.do",
            {{"run", state.at("run")}, {"at_ms", instant.at("at_ms")}, {"set", instant.at("set")}});
        REQUIRE(!state.contains("error"));
    }
    if (state.at("now_ms") < witness.at("end_ms")) {
        state = ask(core, "run.do", {{"run", state.at("run")}, {"at_ms", witness.at("end_ms")}});
    }
    return state;
}

}  // namespace

TEST_CASE("a check reports as the command line does") {
    for (const std::string style : {"nand", "nor", "gates", "clocked"}) {
        CAPTURE(style);
        const Json answer =
            ask("check",
                {{"text", chart_text("rule-5")}, {"file", "rule-5.grafcet"}, {"style", style}});
        Json expected = Json::parse(
            grafwire_with({"check", example("rule-5.grafcet"), "--style", style, "--to", "json"})
                .out);
        expected["file"] = "rule-5.grafcet";
        CHECK(answer.at("report") == expected);
        CHECK(answer.at("verdict") == expected.at("verdict"));
        CHECK(!answer.at("text").get<std::string>().empty());
    }
}

TEST_CASE("a witness comes back in a run of the page") {
    AskedCore core;
    const Json args{{"text", chart_text("rule-5")}, {"style", "nor"}};
    const Json answer = ask(core, "check", args);
    CHECK(answer.at("verdict") == "different");
    CHECK(!answer.at("explanation").get<std::string>().empty());
    const Json& witness = answer.at("witness");
    CHECK(contains(witness.at("svg"), "<svg"));
    CHECK(witness.at("files").size() == 9);
    const Json state = replayed(core, args, witness);
    CHECK_FALSE(state.at("gates").at("agrees").get<bool>());
    CHECK(state.at("gates").at("differs") == Json{"X1", "present"});
}

TEST_CASE("a check shows how far it is, and ends where it is told to") {
    AskedCore core;
    int calls = 0;
    const Json answer = ask(core, "check", {{"text", chart_text("nine-steps")}},
                            [&](const Coverage&) { return ++calls < 3; });
    CHECK(calls >= 3);
    CHECK(answer.at("verdict") == "undecided");
    const Json bounded = ask("check", {{"text", chart_text("nine-steps")}, {"max_cases", 5}});
    CHECK(bounded.at("verdict") == "undecided");
}

TEST_CASE("a netlist from elsewhere is checked by its text") {
    const std::string chart = chart_text("nine-steps");
    const Json files =
        ask("export", {{"text", chart}, {"kind", "netlist"}, {"format", "blif"}}).at("files");
    Json args{{"text", chart}, {"against", {{"name", "got.blif"}}}};
    args["against"]["text"] = files.at(0).at("text");
    CHECK(ask("check", args).at("verdict") == "equivalent");
    args["against"]["name"] = "got.txt";
    CHECK(ask("check", args).at("error") == "got.txt: no netlist that can be read");
    args["against"] = {{"name", "got.blif"}, {"text", ".model a\n.names"}};
    CHECK(ask("check", args).at("error") == "the netlist has errors");
}

}  // namespace grafwire::testing
