#include <doctest/doctest.h>

#include "evolution/run_text.h"

namespace grafwire::testing {

namespace {

std::string shown(std::string_view condition) {
    return "input a, b\noutput o\ngraph G { initial 1 : o if " + std::string(condition) + " }";
}

}  // namespace

TEST_CASE("an on-delay, and its interruption") {
    const char* const stimuli = R"(
1s   : a=1
1.5s : a=0
1.6s : a=1
3s   : a=0
4s   : end
)";
    CHECK(until_stable(shown("1s/a"), stimuli, "a o") == R"(
0 0 0
1000 1 0
1500 0 0
1600 1 0
2600 1 1
3000 0 0
4000 0 0
)");
}

TEST_CASE("an off-delay, and its interruption") {
    const char* const stimuli = R"(
1s   : a=1
5s   : a=0
6s   : a=1
6.5s : a=0
9s   : end
)";
    CHECK(until_stable(shown("1s/a/2s"), stimuli, "a o") == R"(
0 0 0
1000 1 0
2000 1 1
5000 0 1
6000 1 1
6500 0 1
8500 0 0
9000 0 0
)");
    CHECK(until_stable(shown("0s/a/2s"), "1s : a=1\n 1.5s : a=0\n 4s : end", "a o") == R"(
0 0 0
1000 1 1
1500 0 1
3500 0 0
4000 0 0
)");
}

TEST_CASE("time conditions are 0 at the start and count from there") {
    CHECK(until_stable(shown("1s/a"), "0s : a=1\n 2s : end", "o") == "\n0 0\n1000 1\n2000 1\n");
    CHECK(until_stable(shown("1s/X1"), "2s : end", "o") == "\n0 0\n1000 1\n2000 1\n");
    CHECK(until_stable(shown("0s/a"), "0s : a=1", "o") == "\n0 1\n");
}

TEST_CASE("nested time conditions") {
    CHECK(until_stable(shown("1s/(1s/a)"), "1s : a=1\n 5s : a=0\n 6s : end", "a o") == R"(
0 0 0
1000 1 0
2000 1 0
3000 1 1
5000 0 0
6000 0 0
)");
    // In 1s/2s/a/3s the 3s belongs to the inner condition.
    CHECK(until_stable(shown("1s/2s/a/3s"), "1s : a=1\n 5s : a=0\n 9s : end", "a o") == R"(
0 0 0
1000 1 0
3000 1 0
4000 1 1
5000 0 1
8000 0 0
9000 0 0
)");
    // The outer condition reads the inner one as it is after the same scan.
    CHECK(scans(shown("0s/(0s/a)"), "10ms : a=1\n 20ms : a=0", 10 * millisecond, "o") ==
          "\n0 0\n10 1\n20 0\n");
}

TEST_CASE(
    "a delay whose input returns at the moment of its end does not end, both ways of running") {
    const char* const grafcet = R"(
input a
graph G { initial 1  step 2  1 -> 2 : 1s/a }
)";
    const std::string rows = R"(
0 1 0
1000 1 0
2000 1 0
3000 1 0
)";
    CHECK(until_stable(grafcet, "1s : a=1\n 2s : a=0\n 3s : end", "X1 X2") == rows);
    CHECK(scans(grafcet, "1s : a=1\n 2s : a=0\n 3s : end", second, "X1 X2") == rows);
}

TEST_CASE("at the end of a delay the inputs of that moment are read beside it") {
    // b comes as the delay ends, and a receptivity sees both; c asks for the delay in place of a.
    const char* const grafcet = R"(
input a, b, c
graph G { initial 1  step 2  1 -> 2 : b . 1s/(a + c) }
graph H { initial 3  step 4  3 -> 4 : /b . 1s/(a + c) }
)";
    CHECK(until_stable(grafcet, "1s : a=1\n 2s : b=1 a=0 c=1", "X2 X4") ==
          "\n0 0 0\n1000 0 0\n2000 1 0\n");
}

TEST_CASE("an off-delay whose operand returns at its end goes on, from the inside outwards") {
    const char* const grafcet = R"(
input a
output o, p
graph G { initial 1 : o if 1s/a/2s, p if 1s/(1s/a/2s) }
)";
    // The inner condition ends at 2 s, the outer one a second later.
    CHECK(until_stable(grafcet, "1s : a=1\n 3s : a=0\n 5s : a=1\n 6s : end", "o p") == R"(
0 0 0
1000 0 0
2000 1 0
3000 1 1
5000 1 1
6000 1 1
)");
}

TEST_CASE("a condition without delay waits for the end of the first repetition") {
    // At 10 the receptivity of the first repetition still reads 0s/a as 0, so ↑a meets it never.
    const char* const grafcet = R"(
input a
graph G { initial 1  step 2  1 -> 2 : ↑a . 0s/a }
graph H { initial 10  step 11  10 -> 11 : 0s/a }
graph I { initial 20  step 21  20 -> 21 : ↑(0s/a) }
)";
    CHECK(until_stable(grafcet, "10ms : a=1", "X2 X11 X21") == "\n0 0 0 0\n10 0 1 1\n");
    CHECK(scans(grafcet, "10ms : a=1\n 20ms : end", 10 * millisecond, "X2 X11 X21") ==
          "\n0 0 0 0\n10 0 0 0\n20 0 1 1\n");
}

TEST_CASE("scan by scan a delay counts from the scan that saw its operand") {
    // Seen at 300, due at 1300, which the scan at 1500 finds; receptivities see it at 1800.
    const char* const grafcet = R"(
input a
output o
graph G { initial 1 : o if 1s/a  step 2  1 -> 2 : 1s/a }
)";
    CHECK(scans(grafcet, "100ms : a=1\n 1900ms : end", 300 * millisecond, "a o X2") == R"(
0 0 0 0
300 1 0 0
600 1 0 0
900 1 0 0
1200 1 0 0
1500 1 1 0
1800 1 0 1
)");
    // Due exactly at a scan.
    CHECK(scans(grafcet, "100ms : a=1\n 3s : end", 500 * millisecond, "o X2") ==
          "\n0 0 0\n500 0 0\n1000 0 0\n1500 1 0\n2000 0 1\n2500 0 1\n3000 0 1\n");
    // A fall that no scan sees interrupts nothing.
    CHECK(scans(grafcet, "100ms : a=1\n 1010ms : a=0\n 1020ms : a=1\n 1500ms : end",
                500 * millisecond, "o") == "\n0 0\n500 0\n1000 0\n1500 1\n");
}

TEST_CASE("the time of a step starts anew at each activation") {
    const char* const grafcet = R"(
input a
graph G {
  initial 1  step 2  step 3
  1 -> 2 : a
  2 -> 1 : /a
  2 -> 3 : 1s/X2
}
)";
    CHECK(until_stable(grafcet, "1s : a=1\n 1.9s : a=0\n 1.95s : a=1\n 4s : end", "X1 X2 X3") == R"(
0 1 0 0
1000 0 1 0
1900 1 0 0
1950 0 1 0
2950 0 0 1
4000 0 0 1
)");
    // One that ends at the very instant at which the step is left: both transitions are cleared.
    CHECK(until_stable(grafcet, "1s : a=1\n 2s : a=0\n 3s : end", "X1 X2 X3") == R"(
0 1 0 0
1000 0 1 0
2000 1 0 1
3000 1 0 1
)");
}

TEST_CASE("delays that fall due together end together, and delays run over freezing") {
    const char* const grafcet = R"(
input a, stop
graph F { initial 0  step 1 : G{*}  0 -> 1 : stop  1 -> 0 : /stop }
graph G {
  initial 10  step 11
  10 -> 11 : 1s/a . 500ms/(500ms/a)
}
)";
    CHECK(until_stable(grafcet, "1s : a=1\n 3s : end", "X10 X11") == R"(
0 1 0
1000 1 0
1500 1 0
2000 0 1
3000 0 1
)");
    CHECK(until_stable(grafcet, "1s : a=1 stop=1\n 3s : stop=0", "X10 X11") == R"(
0 1 0
1000 1 0
1500 1 0
2000 1 0
3000 0 1
)");
}

TEST_CASE("delayed and time-limited actions") {
    CHECK(until_stable("output o, p\ngraph G { initial 5 : o if 3s/X5, p if /(3s/X5) }", "4s : end",
                       "o p") == "\n0 0 1\n3000 1 0\n4000 1 0\n");
}

}  // namespace grafwire::testing
