#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

TEST_CASE("rule 1: the initial steps are active from the start, as if since always") {
    const char* const grafcet = R"(
input a
var v, w
graph G {
  initial 1 : set v
  step 2 : set w
  1 -> 2 : ↑X1 + a
}
)";
    CHECK(scans(grafcet, "20ms : a=1", 10 * millisecond, "X1 X2 v w") == R"(
0 1 0 0 0
10 1 0 0 0
20 0 1 0 1
)");
}

TEST_CASE("rule 2: a transition is cleared once all its preceding steps are active") {
    const char* const grafcet = R"(
input a, b
graph G {
  initial 1
  step 2
  step 3
  initial 4
  1, 2 -> 3 : a
  4 -> 2 : b
}
)";
    CHECK(scans(grafcet, "0ms : a=1\n 20ms : b=1\n 30ms : end", 10 * millisecond, "X1 X2 X3 X4") ==
          R"(
0 1 0 0 1
10 1 0 0 1
20 1 1 0 0
30 0 0 1 0
)");
}

TEST_CASE("rule 3: clearing activates all following and deactivates all preceding steps") {
    const char* const grafcet = R"(
input a
graph G {
  initial 1  initial 2  step 3  step 4
  1, 2 -> 3, 4 : a
}
)";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, "X1 X2 X3 X4") == R"(
0 1 1 0 0
10 0 0 1 1
)");
}

TEST_CASE("rule 4: transitions that can be cleared at once are cleared at once") {
    const char* const grafcet = R"(
input a
graph G {
  initial 1  step 2  step 3
  1 -> 2 : a
  1 -> 3 : a
}
graph H {
  initial 10  step 11
  10 -> 11 : a . X1
}
)";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, "X1 X2 X3 X10 X11") == R"(
0 1 0 0 1 0
10 0 1 1 0 1
)");
}

TEST_CASE("the receptivities of a scan all read the situation at its start") {
    const char* const grafcet = R"(
input a
graph G {
  initial 1  step 2  step 3
  1 -> 2 : a
  2 -> 3 : 1
}
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "X1 X2 X3") == R"(
0 1 0 0
10 0 1 0
20 0 0 1
)");
}

TEST_CASE("rule 5: a step both activated and deactivated stays active") {
    SUBCASE("two tokens side by side") {
        const char* const grafcet = R"(
input a
graph G {
  initial 1  initial 2  step 3
  1 -> 2 : a
  2 -> 3 : a
}
)";
        CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "X1 X2 X3") == R"(
0 1 1 0
10 0 1 1
20 0 0 1
)");
    }
    SUBCASE("its bit is kept: no activation, no edge, no new delay; the clearing counts") {
        const char* const grafcet = R"(
input a
output late
var act, deact, edge
counter cleared : 0..9
graph G {
  initial 0
  step 1 : set act, set deact on deactivation, late if 25ms/X1
  0 -> 1 : a
  1 -> 1 : X1 do cleared := cleared + 1
}
graph H {
  initial 10  step 11
  10 -> 11 : 1
  11 -> 11 : ↑X1 . X11 do set edge
}
graph I {
  initial 20 : reset act on ↓X0
}
)";
        // 10: 1 is activated and `act` set. 20: ↓X0 resets `act`, ↑X1 is seen, the loop clears.
        CHECK(scans(grafcet, "10ms : a=1\n 30ms : a=0\n 50ms : end", 10 * millisecond,
                    "X0 X1 act deact edge cleared late") == R"(
0 1 0 0 0 0 0 0
10 0 1 1 0 0 0 0
20 0 1 0 0 1 1 0
30 0 1 0 0 1 2 0
40 0 1 0 0 1 3 1
50 0 1 0 0 1 4 1
)");
    }
}

TEST_CASE("source transitions are enabled always, sinks leave nothing behind") {
    const char* const grafcet = R"(
input a, b
graph G {
  initial 1
  step 2
  -> 2 : ↑a
  2 -> : b
}
)";
    CHECK(scans(grafcet, "10ms : a=1\n 30ms : b=1\n 40ms : a=0\n 50ms : a=1\n 60ms : end",
                10 * millisecond, "X1 X2") == R"(
0 1 0
10 1 1
20 1 1
30 1 0
40 1 0
50 1 1
60 1 0
)");
}

}  // namespace grafwire::testing
