#include <doctest/doctest.h>

#include "plc/long_times.h"
#include "plc/pl7_machine.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/plc_machine.h"

namespace grafwire::testing {

namespace {

const PlcLanguage pl7{"pl7-2", pl7_machine, {}};

/// The listing of a chart; empty where it is refused.
std::string listing(const Grafcet& grafcet) {
    Diagnostics diagnostics;
    return plc_format_named("pl7-2")->write(grafcet, program_from(grafcet, {}), {}, diagnostics);
}

void check_has(const std::string& text, const std::string& part) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, part << " is not in\n" << text);
}

}  // namespace

TEST_CASE("PL7-2: all examples run like the reference") {
    CHECK(check_examples(pl7) == 0);
}

TEST_CASE("PL7-2: random charts run like the reference") {
    std::size_t refused = 0;
    std::size_t preset = 0;
    check_property(
        [&](const RandomCase& item) -> std::string {
            const auto grafcet = read_grafcet(with_long_times(item.chart));
            if (!grafcet) return "the chart with longer times is not read";
            if (listing(*grafcet).find("--(S) X") != std::string::npos) ++preset;
            const auto stimuli = ten_times_as_long(*read_stimuli(item.stimuli, *grafcet));
            return difference(pl7, *grafcet, stimuli, {10 * millisecond, 15 * millisecond},
                              &refused);
        },
        Features(), 970'000, 200);
    CHECK(refused <= case_count(200) / 20);
    CHECK(preset >= case_count(200) / 3);
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
    const std::string text = listing(*grafcet);
    const auto has = [&](const std::string& part) { check_has(text, part); };
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
    has("** LABEL 9    sums of (1) up -> 0 : 5s/top/300ms + [c + 1 = 3 - c]\n   =1 --[W0 + 1 -> "
        "W1]\n   =1 --[3 - W0 -> W2]\n");
    has("   (B8 + [W1 = W2]) . B1 --(#)\n");
    has("   X2 --T0 TB=10ms P=200\n");
    has("   X10 . (I0,0 . /I0,1 + /I0,0 . I0,1) . /I0,4 --( ) O0,1\n");
    has("--T1 TB=10ms P=500\n   T1,D --(S) ");
    has("   I0,3 --( ) SY22\n");
    const auto stimuli = read_stimuli(
        "0ms : call=1\n10ms : top=1\n500ms : top=0 call=0\n2600ms : call=1\n9s : top=1\n"
        "15s : Init=1\n15100ms : Init=0 AUdur=1\n15200ms : AUdur=0\n16s : end\n",
        *grafcet);
    REQUIRE(stimuli);
    CHECK(difference(pl7, *grafcet, *stimuli, {10 * millisecond, 70 * millisecond}) == "");
}

TEST_CASE("PL7-2: forcing orders and enclosures preset the situation that they ask for") {
    const auto grafcet = read_grafcet(R"(
input a, b
output lamp
graph G1 {
  initial 1 encloses G3{30}
  step 2 : G2{21}
  1 -> 2 : a
  2 -> 1 : /a . b
}
graph G2 {
  initial 20
  step 21 : lamp
  20 -> 21 : ↑b
  21 -> 20 : b
}
graph G3 { initial 30 step 31 30 -> 31 : b }
)");
    REQUIRE(grafcet);
    const std::string text = listing(*grafcet);
    check_has(text, R"(
** LABEL 4    transition condition of (1) 2 -> 1 : /a.b
   /I0,0 . I0,1 --( ) B2

** LABEL 5    step 1 is to be active, before any order
   I0,2 + X1 . /I0,0 + X2 . B2 --( ) B3

** LABEL 6    step 2 is to be active, before any order
   /I0,2 . (X2 . /B2 + X1 . I0,0) --( ) B4

** LABEL 7    step 20 is to be active, before any order
   I0,2 + X20 . /B1 + X21 . I0,1 --( ) B5

** LABEL 8    step 21 is to be active, before any order
   /I0,2 . (X21 . /I0,1 + X20 . B1) --( ) B6

** LABEL 9    step 30 is to be active, before any order
   I0,2 + X30 . /I0,1 --( ) B7

** LABEL 10   step 31 is to be active, before any order
   /I0,2 . (X31 + X30 . I0,1) --( ) B8

** LABEL 11   forcing orders on G2
   B4 . (B5 + B6 . /B4) + B4 . /B6 --( ) SY23
   B5 . /B4 --( ) B5
   B6 . /B4 + B4 --( ) B6

** LABEL 12   G3 is enclosed by step 1
   /B3 . (B7 + B8) --(S) SY23
   /B3 --(R) B7
   /B3 --(R) B8

** LABEL 13   activation links of G3
   B3 . /X1 . /I0,2 . /B7 --(S) SY23
   B3 . /X1 . /I0,2 --(S) B7

** LABEL 14   AUdur: every step
   I0,3 --(S) SY23
   I0,3 --(R) B3
)");
    check_has(text, R"(
** LABEL 15   Init: initial situation
   I0,2 . /SY23 --( ) SY21

** LABEL 16   presetting of step 1
   SY23 . B3 --(S) X1
   SY23 . /B3 --(R) X1
)");
    check_has(text, "\n** X2 --> X1   (1) 2 -> 1 : /a.b\n   B2 --(#)\n");
    CHECK(text.find("SY22 ") == std::string::npos);
    const auto stimuli = read_stimuli(
        "0ms : b=1\n30ms : b=0\n50ms : a=1\n80ms : b=1\n100ms : a=0\n130ms : b=0\n"
        "150ms : a=1\n170ms : Init=1\n200ms : Init=0\n220ms : AUdur=1 Init=1\n"
        "240ms : AUdur=0\n260ms : Init=0\n300ms : AUdur=1\n320ms : AUdur=0\n340ms : end\n",
        *grafcet);
    REQUIRE(stimuli);
    CHECK(difference(pl7, *grafcet, *stimuli, {10 * millisecond}) == "");
}

TEST_CASE("PL7-2: sources and sinks get a step, which AUdur leaves alone") {
    const auto grafcet = read_grafcet(R"(
input a, b
output lamp
graph G { initial 1 step 0 : lamp step up -> up, 0 : ↑a up -> : b 0, 1 -> : b }
)");
    REQUIRE(grafcet);
    const std::string text = listing(*grafcet);
    check_has(text, R"(
   # X1   1
     X0   0
     X2   up
   # X3   always active, for source transitions
     X4   sink, for sink transitions

** X3 --> X3 X2 X0   (0) -> up, 0 : ↑a
   B1 --(#)

** X2 --> X4   (1) up -> : b
   I0,1 --(#)
)");
    check_has(text, R"(
** LABEL 4    AUdur: no step active
   I0,3 --( ) SY23

** LABEL 5    Init: initial situation
   I0,2 . /SY23 --( ) SY21

** LABEL 6    SY23: no step active
   SY23 --(R) X1
   SY23 --(R) X0
   SY23 --(R) X2

)");
    const auto stimuli = read_stimuli(
        "0ms : a=0\n10ms : a=1\n20ms : a=0\n40ms : a=1 AUdur=1\n50ms : a=0\n60ms : AUdur=0\n"
        "70ms : a=1\n90ms : b=1\n110ms : Init=1 a=0\n120ms : a=1\n140ms : a=0 Init=0\n"
        "150ms : a=1\n170ms : Init=1 AUdur=1\n180ms : AUdur=0\n190ms : Init=0\n200ms : end\n",
        *grafcet);
    REQUIRE(stimuli);
    CHECK(difference(pl7, *grafcet, *stimuli, {10 * millisecond}) == "");
}

TEST_CASE("PL7-2: what it cannot express is refused, with its place") {
    const auto refusal = [](const std::string& chart) -> std::string {
        const auto grafcet = read_grafcet(chart);
        REQUIRE(grafcet);
        Diagnostics diagnostics;
        const std::string text =
            plc_format_named("pl7-2")->write(*grafcet, program_from(*grafcet, {}), {}, diagnostics);
        CHECK(text.empty() == diagnostics.has_errors());
        if (!diagnostics.has_errors()) return "";
        const Diagnostic& first = diagnostics.items().front();
        return std::to_string(first.where.line) + ": " + first.message.english;
    };
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
    CHECK(refusal("input a\n" + many.substr(0, many.rfind("step 96")) + "-> 1 : a 1 -> : a }") ==
          "0: the program needs 97 steps, and PL7-2 has 96; divide the GRAFCET");
}

TEST_CASE("PL7-2: the interpreter refuses what is no listing") {
    const auto grafcet = read_grafcet("graph G { initial 1 }");
    REQUIRE(grafcet);
    const auto run = [&](const std::string& rungs, const std::string& chart = "",
                         const std::string& posterior = "") {
        pl7_machine("ASSIGNMENT\n   X1       X1\nPRELIMINARY PROCESSING\n** LABEL 1 x\n" + rungs +
                        "SEQUENTIAL PROCESSING\n   # X1   1\n" + chart +
                        "POSTERIOR PROCESSING\n** LABEL 1 y\n" + posterior,
                    *grafcet)
            ->scan(0);
    };
    CHECK_NOTHROW(run("   =1 --( ) SY23\n   =1 --(R) X1\n"));
    CHECK_NOTHROW(run("   I0,0 . (/B1 + [W0 < 5]) --(S) B2\n   =1 --[W0 + 1 -> W1]\n",
                      "** X1 --> X1   t\n   B2 --(#)\n"));
    for (const char* wrong :
         {"   I0,24 --( ) B1\n", "   B1 --( ) I0,0\n", "   B1 --( ) X1\n", "   B1 ( ) B1\n",
          "   B1 B2 --( ) B3\n", "   (B1 --( ) B2\n", "   B1 --(#)\n", "   [W0 < W1 --( ) B1\n",
          "   =1 --[32767 -> W0]\n   =1 --[W0 + 1 -> W0]\n", "   B1 --T0 TB=1ms P=5\n",
          "   /(B1 + B2) --( ) B3\n", "   =1 --( ) SY23\n   =1 --( ) X1\n",
          "   =1 --( ) SY23\n   =1 --(S) X2\n", "   =1 --(S) X1\n",
          "   =1 --( ) SY23\n   =1 --( ) SY21\n   =1 --(S) X1\n"}) {
        CHECK_THROWS_AS_MESSAGE(run(wrong), PlcError, wrong);
    }
    for (const char* posterior : {"   B1 --(R) X1\n", "   B1 --( ) SY23\n", "   B1 --( ) SY21\n"}) {
        CHECK_THROWS_AS_MESSAGE(run("", "", posterior), PlcError, posterior);
    }
    CHECK_THROWS_AS(run("", "** X1 --> X2   t\n   B2 --(#)\n"), PlcError);
    CHECK_THROWS_AS(run("", "** X1 --> X1   t\n"), PlcError);
}

}  // namespace grafwire::testing
