#include <doctest/doctest.h>

#include "plc/long_times.h"
#include "plc/pl7_machine.h"
#include "plc/plc_machine.h"
#include "random/random_cases.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

const PlcLanguage pl7{"pl7-2", pl7_machine, {}};

/// What the controller's own GRAFCET has.
Features pl7_features() {
    Features features;
    features.orders = false;
    features.enclosures = false;
    features.sources_and_sinks = false;
    return features;
}

}  // namespace

TEST_CASE("PL7-2: the examples that it can express run like the reference") {
    CHECK(check_examples(pl7) == 4);
}

TEST_CASE("PL7-2: random charts run like the reference") {
    std::size_t refused = 0;
    check_property(
        [&](const RandomCase& item) -> std::string {
            const auto grafcet = read_grafcet(with_long_times(item.chart));
            if (!grafcet) return "the chart with longer times is not read";
            const auto stimuli = ten_times_as_long(*read_stimuli(item.stimuli, *grafcet));
            return difference(pl7, *grafcet, stimuli, {10 * millisecond, 15 * millisecond},
                              &refused);
        },
        pl7_features(), 970'000, 200);
    CHECK(refused < case_count(200) / 5);
}

TEST_CASE("PL7-2: a chart as it is listed") {
    const auto grafcet = read_grafcet(R"(grafcet lift "Monte-charge"
input call, top
output "KM up", lamp
var m
counter c : 0..3
graph G1 {
  initial 0
  step up : "KM up", c := c + 1
  (0) 0 -> up : ↑call . /(top + m) do set m
  (1) up -> 0 : 5s/top/300ms + [c + 1 = 3 - c]
}
graph G2 {
  initial 10 : lamp if call ⊕ top
  step 100 : G1{*}
  10 -> 100 : top
  100 -> 10 : 2s/X100
}
)");
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    const std::string text =
        plc_format_named("pl7-2")->write(program_from(*grafcet, {}), {}, diagnostics);
    const auto has = [&](const std::string& part) {
        CHECK_MESSAGE(text.find(part) != std::string::npos, part << " is not in\n" << text);
    };
    has(R"(
   I0,0     call
   I0,1     top
   I0,2     Init
   I0,3     AUdur
   I0,4     AUdoux
   O0,0     KM up
   O0,1     lamp
   B0       m
   W0       c
   X0       X0
   X1       Xup
   X10      X10
   X2       X100
)");
    has("   # X0   0\n     X1   up\n   # X10  10\n     X2   100\n");
    has("\n** X10 --> X2   (2) 10 -> 100 : top\n   I0,1 . B2 --(#)\n");
    has("** LABEL 11   sums of (1) up -> 0 : 5s/top/300ms + [c + 1 = 3 - c]\n   =1 --[W0 + 1 -> "
        "W1]\n   =1 --[3 - W0 -> W2]\n");
    has("   (B8 + [W1 = W2]) . B1 --(#)\n");
    has("   X2 --T0 TB=10ms P=200\n");
    has("   X10 . (I0,0 . /I0,1 + /I0,0 . I0,1) . /I0,4 --( ) O0,1\n");
    has("--T1 TB=10ms P=500\n   T1,D --(S) ");
    has("   I0,2 . /I0,3 --( ) SY21\n");
    const auto stimuli = read_stimuli(
        "0ms : call=1\n10ms : top=1\n500ms : top=0 call=0\n2600ms : call=1\n9s : top=1\n"
        "15s : Init=1\n15100ms : Init=0 AUdur=1\n15200ms : AUdur=0\n16s : end\n",
        *grafcet);
    REQUIRE(stimuli);
    CHECK(difference(pl7, *grafcet, *stimuli, {10 * millisecond, 70 * millisecond}) == "");
}

TEST_CASE("PL7-2: what it cannot express is refused, with its place") {
    const auto refusal = [](const std::string& chart) -> std::string {
        const auto grafcet = read_grafcet(chart);
        REQUIRE(grafcet);
        Diagnostics diagnostics;
        const std::string text =
            plc_format_named("pl7-2")->write(program_from(*grafcet, {}), {}, diagnostics);
        CHECK(text.empty() == diagnostics.has_errors());
        if (!diagnostics.has_errors()) return "";
        const Diagnostic& first = diagnostics.items().front();
        return std::to_string(first.where.line) + ": " + first.message;
    };
    CHECK(refusal("graph G {\ninitial 1 : H{} }\ngraph H { initial 2 }") ==
          "2: PL7-2 has no forcing order; write H with transitions of its own, or take another "
          "language");
    CHECK(refusal("graph G {\ninitial 1 encloses H{2} }\ngraph H { initial 2 }") ==
          "2: PL7-2 has no enclosing step; take another language");
    CHECK(refusal("input a graph G { initial 1\n-> 1 : a }") ==
          "2: PL7-2 has no source transition; put a step before it");
    CHECK(refusal("input a graph G { initial 1\n1 -> : a }") ==
          "2: PL7-2 has no sink transition; put a step after it");
    CHECK(
        refusal("input a graph G { initial 1 1 -> 1 : 15ms/a }") ==
        "0: no timer of PL7-2 holds 15ms: it counts up to 9999 times 10 ms, 100 ms, 1 s or 1 min; "
        "choose another time");
    CHECK(refusal("counter c : 0..40000\ngraph G { initial 1 }") ==
          "1: an integer needs more than the 16 bits of a word of PL7-2; make the range of the "
          "counter smaller");
    std::string many = "graph G { initial 1\n";
    for (int step = 2; step <= 97; ++step) many += "step " + std::to_string(step) + "\n";
    CHECK(refusal(many + "}") ==
          "0: the program needs 97 steps, and PL7-2 has 96; divide the GRAFCET");
}

TEST_CASE("PL7-2: the interpreter refuses what is no listing") {
    const auto grafcet = read_grafcet("graph G { initial 1 }");
    REQUIRE(grafcet);
    const auto run = [&](const std::string& rungs, const std::string& chart = "") {
        pl7_machine("ASSIGNMENT\n   X1       X1\nPRELIMINARY PROCESSING\n** LABEL 1 x\n" + rungs +
                        "SEQUENTIAL PROCESSING\n   # X1   1\n" + chart + "POSTERIOR PROCESSING\n",
                    *grafcet)
            ->scan(0);
    };
    CHECK_NOTHROW(run("   I0,0 . (/B1 + [W0 < 5]) --(S) B2\n   =1 --[W0 + 1 -> W1]\n",
                      "** X1 --> X1   t\n   B2 --(#)\n"));
    for (const char* wrong :
         {"   I0,24 --( ) B1\n", "   B1 --( ) I0,0\n", "   B1 --( ) X1\n", "   B1 ( ) B1\n",
          "   B1 B2 --( ) B3\n", "   (B1 --( ) B2\n", "   B1 --(#)\n", "   [W0 < W1 --( ) B1\n",
          "   =1 --[32767 -> W0]\n   =1 --[W0 + 1 -> W0]\n", "   B1 --T0 TB=1ms P=5\n",
          "   /(B1 + B2) --( ) B3\n"}) {
        CHECK_THROWS_AS_MESSAGE(run(wrong), PlcError, wrong);
    }
    CHECK_THROWS_AS(run("", "** X1 --> X2   t\n   B2 --(#)\n"), PlcError);
    CHECK_THROWS_AS(run("", "** X1 --> X1   t\n"), PlcError);
}

}  // namespace grafwire::testing
