#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

TEST_CASE("an edge lasts one scan, and the values at the start have none") {
    const char* const grafcet = R"(
input a, b
counter up : 0..9
counter down : 0..9
graph G {
  initial 1
  1 -> 1 : ↑a do up := up + 1
  1 -> 1 : ↓b do down := down + 1
}
)";
    CHECK(scans(grafcet, "0ms : a=1 b=1\n 10ms : a=0\n 20ms : a=1 b=0\n 30ms : b=1\n 40ms : b=0",
                10 * millisecond, "up down") == R"(
0 0 0
10 0 0
20 1 1
30 1 1
40 1 2
)");
    CHECK(until_stable(grafcet,
                       "0ms : a=1 b=1\n 10ms : a=0\n 20ms : a=1 b=0\n 30ms : b=1\n 40ms : b=0",
                       "up down") == R"(
0 0 0
10 0 0
20 1 1
30 1 1
40 1 2
)");
}

TEST_CASE("edges of expressions, and edges within edges") {
    const char* const grafcet = R"(
input a, b
counter both : 0..9
counter nested : 0..9
graph G {
  initial 1
  1 -> 1 : ↑(a . b) do both := both + 1
  1 -> 1 : ↓↑a do nested := nested + 1
}
)";
    // ↑a is 1 at 10 and 50, so ↓↑a is 1 at 20 and 60.
    CHECK(scans(grafcet,
                "10ms : a=1\n 20ms : b=1\n 30ms : a=0\n 40ms : b=0\n 50ms : a=1 b=1\n 60ms : end",
                10 * millisecond, "both nested") == R"(
0 0 0
10 0 0
20 1 1
30 1 1
40 1 1
50 2 1
60 2 2
)");
    // Until stable, ↑a falls in the second repetition of the same instant.
    CHECK(until_stable(grafcet, "10ms : a=1\n 20ms : b=1", "both nested") == R"(
0 0 0
10 0 1
20 1 1
)");
}

TEST_CASE("an edge is seen by the transitions of its scan alone, enabled or not") {
    const char* const grafcet = R"(
input a, b
graph G {
  initial 1  step 2  step 3
  1 -> 2 : b
  2 -> 3 : ↑a
}
)";
    CHECK(scans(grafcet, "10ms : a=1 b=1\n 20ms : a=0\n 30ms : a=1\n", 10 * millisecond,
                "X1 X2 X3") == R"(
0 1 0 0
10 0 1 0
20 0 1 0
30 0 0 1
)");
}

TEST_CASE("the edge of a step comes in the scan or repetition after the change") {
    const char* const grafcet = R"(
input a
graph G { initial 1  step 5  1 -> 5 : a }
graph H { initial 10  step 11  10 -> 11 : ↑X5 }
graph I { initial 20  step 21  20 -> 21 : ↓X1 . ↑X5 }
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "X5 X11 X21") == R"(
0 0 0 0
10 1 0 0
20 1 1 1
)");
    CHECK(until_stable(grafcet, "10ms : a=1", "X5 X11 X21") == "\n0 0 0 0\n10 1 1 1\n");
}

TEST_CASE("the edges of the X of graphs and macro-steps, of vars, counters and stored outputs") {
    const char* const grafcet = R"(
input a
output o
var v
counter c : 0..5
counter seen : 0..99
graph G {
  initial 1
  macro M = m
  step 2 : set o, set v, c := 3
  step 3 : reset v
  1 -> M : a
  M -> 2 : 1
  2 -> 3 : 1
  3 -> : 1
}
expansion m { entry E  exit S  E -> S : 1 }
graph H {
  initial 10
  10 -> 10 : ↑XM do seen := seen + 1
  10 -> 10 : ↓XM . ↑o . ↑v . ↑[c > 2] do seen := seen + 10
  10 -> 10 : ↓v do seen := seen + 20
  10 -> 10 : ↓XG do seen := seen + 40
}
)";
    // 10: E.  20: S (↑XM).  30: 2, writes.  40: 3 (↓XM …), resets v.  50: sink (↓v).  60: ↓XG.
    CHECK(scans(grafcet, "10ms : a=1\n 60ms : end", 10 * millisecond, "XE XS X2 X3 o v c seen") ==
          R"(
0 0 0 0 0 0 0 0 0
10 1 0 0 0 0 0 0 0
20 0 1 0 0 0 0 0 1
30 0 0 1 0 1 1 3 1
40 0 0 0 1 1 0 3 11
50 0 0 0 0 1 0 3 31
60 0 0 0 0 1 0 3 71
)");
}

TEST_CASE("the memory of an edge starts with the value of its operand at the start") {
    const char* const grafcet = R"(
input a
counter n : 0..9
graph G {
  initial 1
  1 -> 1 : ↑X1 + ↑/a + ↑[n = 0] + ↑XG + ↓(0s/a) do n := n + 1
}
)";
    CHECK(scans(grafcet, "20ms : end", 10 * millisecond, "n") == "\n0 0\n10 0\n20 0\n");
}

}  // namespace grafwire::testing
