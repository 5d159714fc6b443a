#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

TEST_CASE("the order of writing: deactivation, clearing, activation, event") {
    const char* const grafcet = R"(
input a
var dc, cd, ca, ac, ae, ea, de
graph G {
  initial 1 : set dc on deactivation, reset cd on deactivation, set de on deactivation
  step 2 : set ca, reset ac, set ae, reset ea,
           reset ae on X2, set ea on X2, reset de on X2
  1 -> 2 : a do reset dc, set cd, reset ca, set ac
}
)";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, "dc cd ca ac ae ea de") == R"(
0 0 0 0 0 0 0 0
10 0 1 1 0 0 1 0
)");
}

TEST_CASE("within a kind the file order decides; clearing goes by the order of the transitions") {
    const char* const grafcet = R"(
input a
var p, q, r, s
graph G {
  initial 1  initial 2  step 3 : set p, reset q  step 4
  2 -> 4 : a do set r, reset s
  1 -> 3 : a do reset r, set s
}
graph H {
  initial 10  step 11 : reset p, set q
  10 -> 11 : a
}
)";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, "p q r s") == R"(
0 0 0 0 0
10 0 1 0 1
)");
}

TEST_CASE("all right-hand sides are read before anything is written") {
    const char* const grafcet = R"(
input a
output o
var v, w
counter c : 0..9
counter d : 0..9
graph G {
  initial 1
  step 2 : set v, c := 3, d := 5
  step 3 : v := w, w := v, c := d, d := c, o := [c < d] . X3
  1 -> 2 : a
  2 -> 3 : a
}
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "v w c d o") == R"(
0 0 0 0 0 0
10 1 0 3 5 0
20 0 1 5 3 1
)");
}

TEST_CASE("two increments of a counter in one scan count one") {
    const char* const grafcet = R"(
input a
counter c : 0..9
graph G { initial 1  step 2  1 -> 2 : a do c := c + 1 }
graph H { initial 10  step 11 : c := c + 1  10 -> 11 : a }
)";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, "c") == "\n0 0\n10 1\n");
}

TEST_CASE("counters start at the low end and stay in their range, also for large numbers") {
    const char* const grafcet = R"(
input a
counter c : -3..4
counter d : 0..9
counter e : 0..9
graph G {
  initial 1
  step 2 : c := c + 100, d := 4000000000 + 4000000000 - 7999999993, e := -1
  step 3 : c := -c - 100, d := -4000000000 - d, e := 4000000000
  step 4 : c := 1 - 2 + 3 - c, d := d + 4
  1 -> 2 : a
  2 -> 3 : [c = 4] . [d > e]
  3 -> 4 : [c <> 4] . [c - 1 <= -4] . [c >= -3] . [-c < 4]
}
)";
    CHECK(scans(grafcet, "10ms : a=1\n 30ms : end", 10 * millisecond, "X1 X2 X3 X4 c d e") == R"(
0 1 0 0 0 -3 0 0
10 0 1 0 0 4 7 0
20 0 0 1 0 -3 0 9
30 0 0 0 1 4 4 9
)");
}

TEST_CASE("actions follow the change of the step, whatever caused it") {
    const char* const grafcet = R"(
input a, b
counter up : 0..99
counter down : 0..99
graph A { initial 0  step 1 : B{11}  step 2 : B{}  0 -> 1 : a  1 -> 2 : b }
graph B { initial 10 : up := up + 1, down := down + 1 on deactivation
          step 11 : up := up + 10, down := down + 10 on deactivation }
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : b=1\n 30ms : Init=1\n 40ms : AUdur=1",
                10 * millisecond, "X10 X11 up down") == R"(
0 1 0 0 0
10 0 1 10 1
20 0 0 10 11
30 1 0 11 11
40 0 0 11 12
)");
}

TEST_CASE("a step that a transition activates and forcing empties again is never activated") {
    const char* const grafcet = R"(
input a
var up, down
graph A { initial 0 : B{10} }
graph B { initial 10  step 11 : set up, set down on deactivation  10 -> 11 : a }
)";
    CHECK(scans(grafcet, "0ms : a=1\n 10ms : end", 10 * millisecond, "X10 X11 up down") == R"(
0 1 0 0 0
10 1 0 0 0
)");
}

TEST_CASE("event actions run while their step is active, on what the expression is then") {
    const char* const grafcet = R"(
input a, s
output o
var v
counter n : 0..9
graph G {
  initial 1 : n := n + 1 on ↑s, set o on ↑s . v, v := /v on ↓s
  step 2
  1 -> 2 : a
}
)";
    CHECK(scans(grafcet,
                "10ms : s=1\n 20ms : s=0\n 30ms : s=1\n 40ms : s=0\n 50ms : a=1 s=1\n 60ms : s=0",
                10 * millisecond, "X1 n o v") == R"(
0 1 0 0 0
10 1 1 0 0
20 1 1 0 1
30 1 2 1 1
40 1 2 1 0
50 0 2 1 0
60 0 2 1 0
)");
}

TEST_CASE("stored actions run in every repetition of an instant") {
    const char* const grafcet = R"(
input a
counter c : 0..9
var passed
graph G {
  initial 1
  step 2 : set passed
  step 3
  1 -> 2 : a do c := c + 1
  2 -> 3 : 1 do c := c + 1
}
)";
    CHECK(until_stable(grafcet, "10ms : a=1", "X1 X2 X3 c passed") == R"(
0 1 0 0 0 0
10 0 0 1 2 1
)");
}

TEST_CASE("writes take effect on receptivities in the next scan, on outputs and delays at once") {
    const char* const grafcet = R"(
input a
output o
var v
graph G { initial 1  step 2 : set v  1 -> 2 : a }
graph H { initial 10 : o if v . 0s/v  step 11  10 -> 11 : v . X2 }
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "v o X11") == R"(
0 0 0 0
10 1 1 0
20 1 0 1
)");
}

}  // namespace grafwire::testing
