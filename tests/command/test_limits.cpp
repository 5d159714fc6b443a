// What is large, or wrong in very many places, costs what it is worth: texts that are written grow
// as the chart does, messages are no longer than people read, and where a limit is, it is said.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <functional>

#include "command/charts.h"
#include "support/run_program.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

using Request = std::vector<std::string>;

/// `prefix0 separator prefix1 separator …`
std::string list_of(std::size_t count, const std::string& prefix, const std::string& separator) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += (i == 0 ? "" : separator) + prefix + std::to_string(i);
    }
    return text;
}

std::string declared(std::size_t count, const std::string& before, const std::string& behind = "") {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += fmt::format("{}{}{}\n", before, i, behind);
    return text;
}

/// A transition with an exclusive OR of so many inputs.
std::string exclusive_or_chart(std::size_t count) {
    return declared(count, "input i") +
           "graph G { initial 0 step 1 step 2 0 -> 1 : " + list_of(count, "i", " ⊕ ") +
           " 1 -> 2 : i0 2 -> 0 : /i0 }\n";
}

/// So many steps at once, by one divergence and one convergence.
std::string parallel_chart(std::size_t count) {
    return "input a\ninput b\ngraph G {\ninitial 0\nstep last\n" + declared(count, "step p") +
           "0 -> " + list_of(count, "p", ", ") + " : a\n" + list_of(count, "p", ", ") +
           " -> last : b\nlast -> 0 : /a\n}\n";
}

/// A comparison with the sum of so many counters.
std::string sum_chart(std::size_t count) {
    return "input a\n" + declared(count, "counter c", " : 0..3") +
           "graph G { initial 0 step 1 : c0 := c0 + 1 on ↑a 0 -> 1 : [" +
           list_of(count, "c", " + ") + " >= 3] 1 -> 0 : a }\n";
}

/// How long the text is that a request makes of a chart on standard input.
std::size_t length_of(const Request& request, const std::string& chart) {
    const Ran ran = grafwire_with(request, chart);
    CHECK(ran.status == 0);
    return ran.out.size();
}

/// Two times the chart is at most three times the text (names get longer as well).
void check_growth(const Request& request, const std::function<std::string(std::size_t)>& chart,
                  std::size_t count) {
    CAPTURE(request);
    const std::size_t once = length_of(request, chart(count));
    const std::size_t twice = length_of(request, chart(2 * count));
    CHECK(once > 0);
    CHECK(twice <= 3 * once);
}

/// Runs grafwire with so many seconds of work, many times what it needs.
Ran within_seconds(int seconds, const Request& request) {
    const int bound = is_slow_build ? 10 * seconds : seconds;
    std::string line =
        fmt::format("ulimit -t {} && exec '{}'", bound, std::string(GRAFWIRE_PROGRAM));
    for (const std::string& word : request) line += " '" + word + "'";
    return run_program({"sh", "-c", line});
}

}  // namespace

TEST_CASE("an exclusive OR is written in a length that grows as its inputs do") {
    for (const std::string format : {"pl7-2", "st", "il", "c", "text", "s7-200"}) {
        const Request request{"plc", "-", "--to", format};
        check_growth(request, exclusive_or_chart, format == "s7-200" ? 10 : 40);
    }
    // Diagrams say with every rung of a part what it is part of, but not for ever.
    for (const std::string format : {"ladder", "plcopen"}) {
        check_growth({"plc", "-", "--to", format}, exclusive_or_chart, 500);
    }
}

TEST_CASE("an exclusive OR within others is drawn in PL7-2 as well") {
    std::string nested = "a";
    for (int i = 0; i < 40; ++i) nested = (i % 2 == 0 ? "/(b ⊕ " : "(b . c ⊕ ") + nested + ")";
    const Ran ran =
        grafwire_with({"plc", "-", "--to", "pl7-2"},
                      "input a\ninput b\ninput c\ngraph G { initial 0 step 1 0 -> 1 : " + nested +
                          " 1 -> 0 : a }\n");
    CHECK(ran.status == 0);
    CHECK(ran.out.size() < 10'000);
}

TEST_CASE("parallel steps are written in a length that grows as they do") {
    for (const std::string style : {"clocked", "nand", "gates", "rs"}) {
        check_growth({"netlist", "-", "--style", style, "--to", "blif"}, parallel_chart, 600);
    }
    for (const std::string format : {"ladder", "ladder-svg", "plcopen", "st", "c"}) {
        check_growth({"plc", "-", "--to", format}, parallel_chart, 600);
    }
}

TEST_CASE("a sum of counters takes gates that grow as they do") {
    check_growth({"netlist", "-", "--style", "clocked", "--to", "blif"}, sum_chart, 60);
}

TEST_CASE("messages about very many faults, or very long names, stay readable") {
    constexpr std::size_t most = 100'000;
    const ScratchFolder folder;
    const std::string manipulator = example("manipulator.grafcet");
    const std::string long_name(1'000'000, 'n');
    const std::string bad_io = folder.file("bad.io", declared(20'000, "foo bar "));
    const std::string long_io = folder.file("long.io", "E0.0 = " + long_name + "\n");
    const std::string blif =
        folder.file("long.blif", ".model m\n.inputs a\n.outputs y\n.names a " + long_name +
                                     "\n1 1\n.unknown" + long_name + "\n.end\n");
    const std::string unused = folder.file(
        "unused.grafcet", declared(20'000, "input " + std::string(70, 'x')) +
                              "input a\ngraph G { initial 0 step 1 0 -> 1 : a 1 -> 0 : /a }\n");
    const std::string many = folder.file(
        "many.grafcet", declared(5'000, "input i") + "graph G { initial 0 step 1 0 -> 1 : " +
                            list_of(5'000, "i", " . ") + " 1 -> 0 : i0 }\n");
    // Steps that never come to rest.
    std::string restless = "input a\ngraph G {\ninitial 0\n";
    for (int i = 0; i < 5'000; ++i) {
        restless += fmt::format("step p{0} step q{0} p{0} -> q{0} : 1 q{0} -> p{0} : 1\n", i);
    }
    restless += "0 -> " + list_of(5'000, "p", ", ") + " : a\n}\n";
    const std::string unstable = folder.file("unstable.grafcet", restless);
    const std::string stim = folder.file("a.stim", "0ms : a=1\n");
    for (const Request& request : std::vector<Request>{
             {"plc", manipulator, "--to", "s7-200", "--io", bad_io},
             {"plc", manipulator, "--to", "s7-200", "--io", long_io},
             {"plc", many, "--to", "s7-200"},
             {"plc", many, "--to", "pl7-2"},
             {"info", unused},
             {"check", rule_5_chart, "--style", "nand", "--assume", std::string(100'000, 'n')},
             {"check", rule_5_chart, "--against", blif},
             {"run", unstable, stim, "-o", "/dev/null"}}) {
        CAPTURE(request.front());
        const Ran ran = grafwire_with(request);
        CHECK(!ran.err.empty());
        CHECK(ran.err.size() < most);
    }
}

TEST_CASE("names are suggested for the first wrong ones only") {
    const ScratchFolder folder;
    const std::string wrong = folder.file("wrong.io", [] {
        std::string text;
        for (int i = 0; i < 8'000; ++i) {
            text += fmt::format("V{}.{} = wrong_input_{}\n", i / 8, i % 8, i);
        }
        return text;
    }());
    const std::string chart =
        folder.file("a.grafcet", declared(8'000, "input given_input_") +
                                     "graph G { initial 0 step 1 0 -> 1 : given_input_0 1 -> 0 : "
                                     "/given_input_0 }\n");
    const std::string unknown =
        folder.file("b.grafcet", declared(8'000, "input given_input_") +
                                     "graph G { initial 0 step 1 0 -> 1 : " +
                                     list_of(8'000, "wrong_input_", " . ") + " 1 -> 0 : 1 }\n");
    CHECK(within_seconds(20, {"plc", chart, "--to", "s7-200", "--io", wrong}).status == 2);
    CHECK(within_seconds(20, {"info", unknown}).status == 2);
}

TEST_CASE("a run of more scans than a trace can hold is refused, and the limit said") {
    const ScratchFolder folder;
    const std::string stim = folder.file("long.stim", "0ms : s=0\n2560h : s=1\n");
    const std::string awl = example("s7-200/manipulator.awl");
    const std::string io = example("s7-200/manipulator.io");
    const std::string end = folder.file("end.stim", "2560h : end\n");
    for (const Request& request : std::vector<Request>{
             {"run", rule_5_chart, stim, "--scan", "1us"},
             {"run", rule_5_chart, stim, "--scan", "1us", "--explain"},
             {"simulate", rule_5_chart, stim, "--style", "clocked", "--scan", "1us"},
             {"s7", "run", awl, "--stim", end, "--scan", "1us", "--io", io}}) {
        CAPTURE(request);
        const Ran ran = within_seconds(20, request);
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK(contains(ran.err, "more than a trace may hold, 100000000 values; take a longer"));
    }
    const Ran french = grafwire_with({"--lang", "fr", "run", rule_5_chart, stim, "--scan", "1us"});
    CHECK(french.status == 2);
    CHECK(contains(french.err, "dépassent ce qu'une trace peut contenir, 100000000 valeurs"));
    CHECK(grafwire_with({"run", rule_5_chart, stim, "--scan", "1h"}).status == 0);
}

}  // namespace grafwire::testing
