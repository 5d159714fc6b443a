#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

TEST_CASE("a graph is forced to nothing, to listed steps, to its initial situation") {
    const char* const grafcet = R"(
input a, b, c
graph A {
  initial 0
  step 1 : B{}
  step 2 : B{11, 12}
  step 3 : B{INIT}
  0 -> 1 : a
  1 -> 2 : b
  2 -> 3 : c
}
graph B {
  initial 10  step 11  step 12  initial 13
  10 -> 11 : 1
}
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : b=1\n 30ms : c=1", 10 * millisecond,
                "X0 X1 X2 X3 X10 X11 X12 X13") == R"(
0 1 0 0 0 0 1 0 1
10 0 1 0 0 0 0 0 0
20 0 0 1 0 0 1 1 0
30 0 0 0 1 1 0 0 1
)");
}

TEST_CASE("while a graph is forced its transitions are evaluated and overruled") {
    // The source transition of B clears in every scan, and its action counts every time.
    const char* const grafcet = R"(
counter n : 0..9
graph A { initial 0 : B{10} }
graph B {
  step 10  step 11
  -> 11 : 1 do n := n + 1
}
)";
    CHECK(scans(grafcet, "20ms : end", 10 * millisecond, "X10 X11 n") == R"(
0 1 0 1
10 1 0 2
20 1 0 3
)");
}

TEST_CASE("forced to 0 and to 1 at once: 1 wins") {
    const char* const grafcet = R"(
input a
graph A { initial 0   step 1 : B{}     0 -> 1 : a }
graph C { initial 20  step 21 : B{11}  20 -> 21 : a }
graph B { initial 10  step 11  step 12   10 -> 12 : 1 }
)";
    CHECK(scans(grafcet, "10ms : a=1", 10 * millisecond, "X1 X21 X10 X11 X12") == R"(
0 0 0 0 0 1
10 1 1 0 1 0
)");
}

TEST_CASE("forcing is one pass a scan") {
    // At 10 the order of 10 is still given, since SBR 4 left it active; that of 11, which forcing
    // activates, is given at 20.
    const char* const grafcet = R"(
input a
graph A { initial 0  step 1 : B{11}  0 -> 1 : a }
graph B { initial 10 : C{20}  step 11 : C{21} }
graph C { step 20  step 21 }
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "X1 X10 X11 X20 X21") == R"(
0 0 1 0 1 0
10 1 0 1 1 0
20 1 0 1 0 1
)");
}

TEST_CASE("a step that a transition deactivates gives no order any more") {
    const char* const grafcet = R"(
input a
graph A { initial 0 : B{11}  step 1  0 -> 1 : a }
graph B { initial 10  step 11  11 -> 10 : 1 }
)";
    CHECK(scans(grafcet, "20ms : a=1", 10 * millisecond, "X10 X11") == R"(
0 0 1
10 0 1
20 1 0
)");
}

TEST_CASE("freezing keeps a graph as it is from the next scan on") {
    const char* const grafcet = R"(
input a, b
graph A {
  initial 0  step 1 : B{*}
  0 -> 1 : a
  1 -> 0 : /a
}
graph B {
  initial 10  step 11
  10 -> 11 : b
  11 -> 10 : /b
  -> 10 : X1 . X0
}
)";
    CHECK(scans(grafcet, "10ms : a=1 b=1\n 20ms : b=0\n 30ms : a=0\n 40ms : end", 10 * millisecond,
                "X0 X1 X10 X11") == R"(
0 1 0 1 0
10 0 1 0 1
20 0 1 0 1
30 1 0 0 1
40 1 0 1 0
)");
}

TEST_CASE("a source transition of a frozen graph is not cleared") {
    const char* const grafcet = R"(
graph A { initial 0 : B{*} }
graph B { step 10  step 11  -> 10 : X11  -> 11 : X0 }
)";
    // The first scan begins with nothing frozen.
    CHECK(scans(grafcet, "20ms : end", 10 * millisecond, "X10 X11") == R"(
0 0 1
10 0 1
20 0 1
)");
}

TEST_CASE("a frozen graph can still be forced") {
    const char* const grafcet = R"(
input b, c
graph A { initial 0 : B{*} }
graph C { initial 20  step 21 : B{12}  20 -> 21 : c  21 -> 20 : /c }
graph B { initial 10  step 11  step 12  10 -> 11 : b  12 -> 10 : b }
)";
    CHECK(scans(grafcet, "10ms : b=1\n 20ms : c=1\n 30ms : c=0\n 40ms : end", 10 * millisecond,
                "X20 X21 X10 X11 X12") == R"(
0 1 0 1 0 0
10 1 0 1 0 0
20 0 1 0 0 1
30 1 0 0 0 1
40 1 0 0 0 1
)");
}

TEST_CASE("one step can force one graph and freeze another") {
    const char* const grafcet = R"(
input a
graph A { initial 0  step 1 : B{11}, C{*}  0 -> 1 : a }
graph B { initial 10  step 11  11 -> 10 : 1 }
graph C { initial 20  step 21  20 -> 21 : X11 }
)";
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "X10 X11 X20 X21") == R"(
0 1 0 1 0
10 0 1 1 0
20 0 1 1 0
)");
}

}  // namespace grafwire::testing
