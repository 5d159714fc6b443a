// Whatever is asked, there is an answer.

#include <doctest/doctest.h>

#include <string>

#include "playground/asked.h"

namespace grafwire::testing {

namespace {

constexpr const char* requests[] = {
    "version",   "words",    "chart",     "format",     "draw",        "schematic",
    "equations", "exports",  "export",    "script",     "check",       "run.open",
    "run.do",    "run.back", "run.state", "run.timing", "run.stimuli", "run.close"};

}  // namespace

TEST_CASE("what is no request is answered with an error") {
    AskedCore core;
    for (const std::string text : {"", "{", "[]", "7", "null", "{}", R"({"name":3})",
                                   R"({"name":"chart","args":[]})", "{\"name\":\"\xff\"}"}) {
        CAPTURE(text);
        const Json answer = Json::parse(core.call(text));
        CHECK(answer.contains("error"));
    }
    CHECK(ask("chart ").at("error") == "there is no request chart ");
}

TEST_CASE("every request survives arguments that are missing, and of other types") {
    AskedCore core;
    const Json wrong[] = {nullptr,
                          true,
                          -1,
                          1e300,
                          "",
                          "\xc3\xa9",
                          Json::array({1, "a"}),
                          Json{{"a", 1}, {"b", Json::array()}}};
    constexpr const char* names[] = {
        "text",   "lang", "style", "cdx", "modes",   "period",    "kind",  "format",    "stimuli",
        "assume", "set",  "run",   "at",  "against", "situation", "at_ms", "max_cases", "io"};
    const std::string chart = chart_text("single-sequence");
    for (const std::string request : requests) {
        CAPTURE(request);
        CHECK(ask(core, request).is_object());
        for (const std::string name : names) {
            for (const Json& value : wrong) {
                Json args{{"text", chart}, {"max_cases", 10}};
                args[name] = value;
                CHECK(ask(core, request, args).is_object());
            }
        }
    }
    const Json answer = ask("format", {{"text", 5}, {"lang", "fr"}});
    CHECK(answer == Json{{"error", "text : l'argument est d'un autre type"}});
}

TEST_CASE("errors are in the language asked for") {
    CHECK(ask("run.state", {{"run", 7}}).at("error") == "this run is not open");
    CHECK(ask("run.state", {{"run", 7}, {"lang", "fr"}}).at("error") ==
          "cette exécution n'est pas ouverte");
    CHECK(ask("check", {{"text", "grafcet"}, {"lang", "fr"}}).at("error") ==
          "le GRAFCET a des erreurs");
    CHECK(ask("equations", {{"text", chart_text("rule-5")}, {"cdx", "none"}}).at("error") ==
          "cdx: there is no none");
}

}  // namespace grafwire::testing
