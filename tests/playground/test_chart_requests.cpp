#include <doctest/doctest.h>

#include <string>

#include "playground/asked.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// The part of a text that begins and ends there, counted as browsers count.
std::string part_of(const std::string& text, const Json& place) {
    const auto byte_at = [&](std::size_t units) {
        std::size_t at = 0;
        for (std::size_t count = 0; count < units; ++at) {
            const auto lead = static_cast<unsigned char>(text.at(at));
            if ((lead & 0xc0U) != 0x80) count += lead >= 0xf0 ? 2 : 1;
        }
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80) ++at;
        return at;
    };
    const std::size_t from = byte_at(place.at("from").get<std::size_t>());
    return text.substr(from, byte_at(place.at("to").get<std::size_t>()) - from);
}

}  // namespace

TEST_CASE("messages stand where the text is that they are about") {
    const std::string text =
        "grafcet g # \xf0\x9f\x98\x80 é\ninput \"é\xf0\x9f\x98\x80\", b\ngraph G {\n  initial 0\n"
        "  step 1 : KM9\n  0 -> 1 : \"é\xf0\x9f\x98\x80\" . nowhere\n  1 -> 0 : b . )\n}\n";
    const Json diagnostics = ask("chart", {{"text", text}}).at("diagnostics");
    REQUIRE(!diagnostics.empty());
    for (const Json& item : diagnostics) {
        CAPTURE(item.dump());
        const std::string part = part_of(text, item);
        if (item.at("code") == "unknown-name") CHECK((part == "nowhere" || part == "KM9"));
        if (item.at("code") == "unexpected-token") CHECK(part == ")");
        CHECK(item.at("from") <= item.at("to"));
    }
}

TEST_CASE("a chart is told in its parts, each with its place") {
    const std::string text = chart_text("nine-steps");
    const Json answer = ask("chart", {{"text", text}});
    CHECK(answer.at("diagnostics").empty());
    const Json& chart = answer.at("chart");
    CHECK(chart.at("name") == "nine_steps");
    CHECK(chart.at("steps").size() == 9);
    CHECK(chart.at("transitions").size() == 9);
    CHECK(chart.at("controls") == Json{"Init", "AUdur", "AUdoux"});
    for (const char* kind : {"inputs", "outputs", "steps"}) {
        for (const Json& part : chart.at(kind)) CHECK(part_of(text, part) == part.at("name"));
    }
    const Json& first = chart.at("transitions").at(0);
    CHECK(first.at("name") == "(1)");
    CHECK(first.at("from_steps") == Json{"1"});
    CHECK(first.at("to_steps") == Json{"2", "5"});
    CHECK(first.at("condition") == "m");
    const std::string file = example("nine-steps.grafcet");
    CHECK(chart.at("description") == grafwire_with({"info", file}).out);
}

TEST_CASE("words are those of the language, in both languages") {
    const Json words = ask("words", {{"lang", "fr"}});
    CHECK(words.at("keywords").size() == 29);
    bool has_step = false;
    for (const Json& word : words.at("keywords")) {
        has_step |= word == Json{{"en", "step"}, {"fr", "étape"}};
    }
    CHECK(has_step);
    CHECK(words.at("operators").at(0).at("words") == Json{"and", "et"});
    CHECK(words.at("styles").size() == choices_of("netlist", "--style").size());
}

TEST_CASE("a drawing with a situation is the one of that moment") {
    const std::string text = chart_text("single-sequence");
    const std::string stimuli = example_text("single-sequence.stim");
    const Json moment =
        ask("draw", {{"text", text}, {"stimuli", stimuli}, {"at", "0"}, {"notation", "slash"}});
    const Json state = ask("draw", {{"text", text},
                                    {"notation", "slash"},
                                    {"situation", {{"active", {"0"}}, {"enabled", {"(1)"}}}}});
    CHECK(contains(moment.at("svg"), "step initial active"));
    CHECK(contains(state.at("svg"), "step initial active"));
    CHECK(contains(ask("draw", {{"text", text}}).at("svg"), "step initial\""));
    CHECK(ask("draw", {{"text", text}, {"stimuli", stimuli}, {"at", "soon"}}).at("error") ==
          "soon: this is no duration such as 10ms");
}

TEST_CASE("a schematic has the nets of a run by their names") {
    const Json args{{"text", chart_text("single-sequence")}, {"style", "nand"}};
    const Json run = ask("run.open", args);
    const std::string svg = ask("schematic", args).at("svg");
    for (const auto& item : run.at("gates").at("values").items()) {
        const std::string net = item.key();
        if (net == "AUdoux") continue;  // nothing reads it here
        CAPTURE(net);
        CHECK(contains(svg, "data-net=\"" + net + "\""));
    }
    Json us = args;
    us["symbols"] = "us";
    CHECK(ask("schematic", us).at("svg") != svg);
    us["symbols"] = "other";
    CHECK(ask("schematic", us).at("error") == "symbols: there is no other");
}

TEST_CASE("stimuli are told as values") {
    const Json script = ask("script", {{"text", "input a, b\ngraph G { initial 0\n 0 -> 0 : a }"},
                                       {"stimuli", "0ms : a=1\n+1500us : b=1 a=0\n2s : end\n"}});
    CHECK(script == Json{{"instants",
                          {{{"at_ms", 0.0}, {"set", {{"a", 1}}}},
                           {{"at_ms", 1.5}, {"set", {{"b", 1}, {"a", 0}}}}}},
                         {"end_ms", 2000.0}});
}

}  // namespace grafwire::testing
