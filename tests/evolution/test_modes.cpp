#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

namespace {

const char* const chart = R"(
input a, b
output lamp, kept
var woke, slept
counter cleared : 0..9
graph G {
  initial 1 : lamp, set woke
  step 2 : lamp if b, set kept, set slept on deactivation
  1 -> 2 : a do cleared := cleared + 1
  2 -> 1 : b
}
)";
const char* const columns = "X1 X2 lamp kept woke slept cleared";

}  // namespace

TEST_CASE("Init sets the initial situation; nothing counts as cleared") {
    CHECK(scans(chart,
                "10ms : a=1\n"
                "20ms : Init=1 a=0\n"
                "40ms : a=1\n"
                "50ms : Init=0\n",
                10 * millisecond, columns) == R"(
0 1 0 1 0 0 0 0
10 0 1 0 1 0 0 1
20 1 0 1 1 1 1 1
30 1 0 1 1 1 1 1
40 1 0 1 1 1 1 1
50 0 1 0 1 1 1 2
)");
}

TEST_CASE("AUdur empties every graph, over everything else; the actions on the change still run") {
    CHECK(scans(chart,
                "10ms : AUdur=1 a=1\n"
                "20ms : AUdur=0\n"
                "30ms : Init=1\n"
                "40ms : AUdur=1\n",
                10 * millisecond, columns) == R"(
0 1 0 1 0 0 0 0
10 0 0 0 0 0 0 1
20 0 0 0 0 0 0 1
30 1 0 1 0 1 0 1
40 0 0 0 0 1 0 1
)");
}

TEST_CASE("AUdur empties forced and enclosed graphs too") {
    const char* const grafcet = R"(
graph A { initial 0 : B{11} }
graph B { initial 10  step 11 }
graph C { initial 20 encloses D{30} }
graph D { initial 30  -> 30 : 1 }
)";
    CHECK(scans(grafcet, "10ms : AUdur=1", 10 * millisecond, "X0 X11 X20 X30") == R"(
0 1 1 1 1
10 0 0 0 0
)");
}

TEST_CASE("AUdoux switches the continuous actions off and leaves steps and stored outputs alone") {
    CHECK(scans(chart, "10ms : AUdoux=1\n 20ms : a=1\n 30ms : b=1\n 40ms : AUdoux=0 a=0\n",
                10 * millisecond, columns) == R"(
0 1 0 1 0 0 0 0
10 1 0 0 0 0 0 0
20 0 1 0 1 0 0 1
30 1 0 0 1 1 1 1
40 1 0 1 1 1 1 1
)");
}

TEST_CASE("the modes can be read in expressions") {
    const char* const grafcet = R"(
output o
graph G {
  initial 1 : o if AUdoux + Init
  step 2
  1 -> 2 : ↓AUdoux
}
)";
    CHECK(scans(grafcet, "10ms : AUdoux=1\n 20ms : AUdoux=0 Init=1\n 30ms : end", 10 * millisecond,
                "X1 X2 o") == R"(
0 1 0 0
10 1 0 0
20 1 0 1
30 1 0 1
)");
}

}  // namespace grafwire::testing
