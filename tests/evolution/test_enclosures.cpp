#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

namespace {

const char* const nested = R"(
input a, b, c, d
var seen
graph G2 {
  initial 50
  step 51 encloses G3{60}
  50 -> 51 : a
  51 -> 50 : /a
  51 -> 51 : d
}
graph G3 {
  step 60 encloses G4{70} : set seen
  step 61
  60 -> 61 : b
}
graph G4 {
  step 70  step 71
  70 -> 71 : c
}
)";

}  // namespace

TEST_CASE("activation links are added from the outermost inwards, in the same scan") {
    CHECK(scans(nested,
                "0ms  : c=1\n"
                "10ms : a=1\n"
                "30ms : b=1\n"
                "40ms : a=0 b=0\n"
                "50ms : a=1\n",
                10 * millisecond, "X50 X51 X60 X61 X70 X71 seen") == R"(
0 1 0 0 0 0 0 0
10 0 1 1 0 1 0 1
20 0 1 1 0 0 1 1
30 0 1 0 1 0 0 1
40 1 0 0 0 0 0 1
50 0 1 1 0 1 0 1
)");
}

TEST_CASE("an enclosing step that keeps its bit does not start its graph anew") {
    CHECK(scans(nested, "10ms : a=1\n 20ms : b=1\n 30ms : d=1\n 40ms : end", 10 * millisecond,
                "X51 X60 X61") == R"(
0 0 0 0
10 1 1 0
20 1 0 1
30 1 0 1
40 1 0 1
)");
}

TEST_CASE("no link is added to a graph that an order bears on, freezing included") {
    const char* const grafcet = R"(
input a, f, g, h
graph A {
  initial 0
  step 1 : G3{61}
  step 2 : G3{*}
  step 3 : G3{}
  0 -> 1 : f
  0 -> 2 : g
  0 -> 3 : h
}
graph G2 {
  initial 50  step 51 encloses G3{60}
  50 -> 51 : a
}
graph G3 { step 60  step 61 }
)";
    const char* const columns = "X1 X2 X3 X51 X60 X61";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, columns) ==
          "\n0 0 0 0 0 0 0\n10 0 0 0 1 1 0\n");
    CHECK(scans(grafcet, "10ms : a=1 f=1", 10 * millisecond, columns) ==
          "\n0 0 0 0 0 0 0\n10 1 0 0 1 0 1\n");
    CHECK(scans(grafcet, "10ms : a=1 g=1", 10 * millisecond, columns) ==
          "\n0 0 0 0 0 0 0\n10 0 1 0 1 0 0\n");
    CHECK(scans(grafcet, "10ms : a=1 h=1\n 20ms : end", 10 * millisecond, columns) ==
          "\n0 0 0 0 0 0 0\n10 0 0 1 1 0 0\n20 0 0 1 1 0 0\n");
}

TEST_CASE("while the enclosing step is inactive its graph is empty, whatever forces it") {
    const char* const grafcet = R"(
input a
graph A { initial 0 : G3{61} }
graph G2 { initial 50  step 51 encloses G3{60}  50 -> 51 : a }
graph G3 { step 60  step 61  -> 60 : 1 }
)";
    CHECK(scans(grafcet, "20ms : a=1", 10 * millisecond, "X51 X60 X61") == R"(
0 0 0 0
10 0 0 0
20 1 0 1
)");
}

TEST_CASE("a forced graph empties and starts what its steps enclose") {
    // At 10 forcing activates 51, which activates 60; at 20 forcing deactivates 51 again.
    const char* const grafcet = R"(
input a
graph A { initial 0  step 1 : G2{51}  step 2 : G2{50}  0 -> 1 : a  1 -> 2 : 1 }
graph G2 { initial 50  step 51 encloses G3{60} }
graph G3 { step 60 }
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "X50 X51 X60") == R"(
0 1 0 0
10 0 1 1
20 1 0 0
)");
}

TEST_CASE("a step that has just begun enclosing keeps what source transitions activated") {
    const char* const grafcet = R"(
input a
graph G2 { initial 50  step 51 encloses G3{60}  50 -> 51 : a }
graph G3 { step 60  step 61  -> 61 : a }
)";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, "X51 X60 X61") == R"(
0 0 0 0
10 1 1 1
)");
}

TEST_CASE("Init sets the initial situation and adds no links") {
    const char* const grafcet = R"(
input a
graph G2 { initial 50 encloses G3{61}  step 51  50 -> 51 : a  51 -> 50 : /a }
graph G3 { initial 60  step 61 }
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : Init=1\n 30ms : Init=0\n 40ms : a=0\n",
                10 * millisecond, "X50 X51 X60 X61") == R"(
0 1 0 1 0
10 0 1 0 0
20 1 0 1 0
30 0 1 0 0
40 1 0 0 1
)");
}

}  // namespace grafwire::testing
