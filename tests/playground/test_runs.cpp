// A run that is stepped is the run that stimuli make, forwards and back.

#include <doctest/doctest.h>

#include <string>

#include "playground/asked.h"
#include "support/csv.h"
#include "support/files.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// The values of a state in the columns of a trace: inputs, X, outputs, vars, counters.
Json row_of(const Json& state) {
    Json row = state.at("inputs");
    for (const char* kind : {"outputs", "vars", "counters"}) row.update(state.at(kind));
    for (const Json& step : state.at("situation")) row["X" + step.get<std::string>()] = 1;
    return row;
}

/// A run of an example over its stimuli; `visit` sees every state.
template <typename Visit>
Json play(AskedCore& core, const std::string& name, Json args, const Visit& visit) {
    args["text"] = chart_text(name);
    args["stimuli"] = example_text(name + ".stim");
    const Json script = ask(core, "script", args);
    Json state = ask(core, "run.open", args);
    REQUIRE(state.contains("run"));
    for (const Json& instant : script.at("instants")) {
        state = ask(
            core, "run.do",
            {{"run", state.at("run")}, {"at_ms", instant.at("at_ms")}, {"set", instant.at("set")}});
        REQUIRE(!state.contains("error"));
        visit(state);
    }
    return state;
}

}  // namespace

TEST_CASE("gates beside the reference agree with it wherever the wiring is sound") {
    for (const std::string style : {"nand", "clocked"}) {
        for (const std::string name : {"nine-steps", "manipulator", "rule-5", "press"}) {
            if (style == "nand" && name == "press") continue;  // counters are for clocked ones
            CAPTURE(style);
            CAPTURE(name);
            AskedCore core;
            play(core, name, {{"style", style}},
                 [](const Json& state) { CHECK(state.at("gates").at("agrees") == true); });
        }
    }
}

TEST_CASE("what was done is the run that its stimuli make") {
    AskedCore core;
    const Json state = play(core, "press", Json::object(), [](const Json&) {});
    const Json stimuli = ask(core, "run.stimuli", {{"run", state.at("run")}});
    const ScratchFolder folder;
    const std::string file = folder.file("done.stim", stimuli.at("text"));
    const auto trace = read_csv(grafwire_with({"run", example("press.grafcet"), file}).out);
    const Json row = row_of(state);
    for (std::size_t i = 1; i < trace.front().size(); ++i) {
        CAPTURE(trace.front()[i]);
        const Json value = row.value(trace.front()[i], Json(0));
        CHECK(std::to_string(value.get<long>()) == trace.back().at(i));
    }
    CHECK(contains(ask(core, "run.timing", {{"run", state.at("run")}}).at("svg"), "<svg"));
}

TEST_CASE("an instant tells what was cleared, by which rules, and what the gates did") {
    AskedCore core;
    const Json open =
        ask(core, "run.open", {{"text", chart_text("nine-steps")}, {"style", "nand"}});
    const Json run = open.at("run");
    CHECK(open.at("begun") == false);
    CHECK(open.at("gates").at("values").at("X1") == "x");
    const Json first = ask(core, "run.do", {{"run", run}});
    CHECK(first.at("situation") == Json{"1"});
    CHECK(first.at("instants").at(0).at("rules") == Json{1});
    CHECK(!first.at("gates").at("power_up").at("changes").empty());
    const Json second = ask(core, "run.do", {{"run", run}, {"set", {{"m", 1}}}});
    CHECK(second.at("now_ms") == 1);
    const Json& instant = second.at("instants").at(0);
    CHECK(instant.at("rules") == Json{2, 3});
    CHECK(instant.at("inputs") == Json{{"m", 1}});
    CHECK(instant.at("scans").at(0) == Json{{"cleared", {"(1)"}},
                                            {"activated", {"2", "5"}},
                                            {"deactivated", {"1"}},
                                            {"kept", Json::array()},
                                            {"situation", {"2", "5"}}});
    CHECK(contains(instant.at("text"), "(1) 1 -> 2, 5 is cleared (rule 2)"));
    const Json& changes = instant.at("gates").at("changes");
    REQUIRE(!changes.empty());
    for (std::size_t i = 1; i < changes.size(); ++i) {
        CHECK(changes[i - 1].at(0) <= changes[i].at(0));
    }
    CHECK(second.at("gates").at("values").at("X5") == "1");
    // Back, and on in another way.
    const Json back = ask(core, "run.back", {{"run", run}});
    CHECK(back.at("situation") == first.at("situation"));
    CHECK(back.at("gates").at("values") == first.at("gates").at("values"));
    const Json again = ask(core, "run.do", {{"run", run}, {"set", {{"m", true}}}});
    CHECK(again == second);
}

TEST_CASE("delays end as time goes on, in the reference and in the gates") {
    const std::string chart =
        "input a\noutput K\ngraph G {\n  initial 0\n  step 1 : K\n  0 -> 1 : a\n"
        "  1 -> 0 : 2s/X1\n}\n";
    AskedCore core;
    const Json run = ask(core, "run.open", {{"text", chart}, {"style", "nand"}}).at("run");
    ask(core, "run.do", {{"run", run}});
    Json state = ask(core, "run.do", {{"run", run}, {"set", {{"a", 1}}}, {"advance_ms", 500}});
    CHECK(state.at("next_ms") == 2500);
    CHECK(state.at("timers").at(0) ==
          Json{{"condition", "2s/X1"}, {"value", 0}, {"due_ms", 2500.0}});
    ask(core, "run.do", {{"run", run}, {"set", {{"a", 0}}}});
    state = ask(core, "run.do", {{"run", run}, {"advance_ms", 5000}});
    CHECK(state.at("now_ms") == 5501);
    CHECK(state.at("situation") == Json{"0"});
    CHECK(state.at("gates").at("agrees") == true);
    CHECK(state.at("instants").at(0).at("at_ms") == 2500);
    CHECK(ask(core, "run.do", {{"run", run}, {"next", true}}).at("error") == "no delay is running");
    CHECK(ask(core, "run.do", {{"run", run}, {"at_ms", 3}}).at("error") ==
          "time does not go back: use back");
    CHECK(ask(core, "run.do", {{"run", run}, {"set", {{"z", 1}}}}).at("error") ==
          "there is no input z");
    CHECK(ask(core, "run.close", {{"run", run}}) == Json::object());
    CHECK(ask(core, "run.state", {{"run", run}}).contains("error"));
}

TEST_CASE("scan by scan, inputs are read by the next scan") {
    AskedCore core;
    const Json run =
        ask(core, "run.open",
            {{"text", chart_text("nine-steps")}, {"style", "clocked"}, {"period", "10ms"}})
            .at("run");
    ask(core, "run.do", {{"run", run}, {"scan", true}});
    Json state = ask(core, "run.do", {{"run", run}, {"set", {{"m", 1}}}});
    CHECK(state.at("situation") == Json{"1"});
    CHECK(state.at("inputs").at("m") == 1);
    state = ask(core, "run.do", {{"run", run}, {"scan", true}});
    CHECK(state.at("now_ms") == 10);
    CHECK(state.at("situation") == Json{"2", "5"});
    CHECK(state.at("gates").at("agrees") == true);
    state = ask(core, "run.do", {{"run", run}, {"advance_ms", 100}});
    CHECK(state.at("now_ms") == 110);
}

}  // namespace grafwire::testing
