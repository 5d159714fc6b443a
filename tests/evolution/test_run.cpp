#include <doctest/doctest.h>

#include "evolution/run_text.h"
#include "trace/trace.h"

namespace grafwire::testing {

TEST_CASE("the press with its macro-step, its counter and its enclosed graph") {
    const char* const press = R"(
grafcet press "Hierarchy"
input start, stop, part, up, down
output "press", lamp
counter pieces : 0..9
graph G1 {
  initial 1
  macro M2 = cycle
  step 3
  1 -> M2 : start
  M2 -> 3 : part do pieces := pieces + 1
  3 -> 1 : /start
}
expansion cycle {
  entry E2
  step 21 : "press"
  exit S2
  E2 -> 21 : up
  21 -> S2 : down
}
graph G2 {
  initial 50 encloses G3{60}
  step 51
  50 -> 51 : stop
  51 -> 50 : /stop
}
graph G3 {
  initial 60
  step 61 : lamp
  60 -> 61 : part
  61 -> 60 : /part
}
)";
    const Grafcet grafcet = grafcet_from(press);
    const char* const stimuli = R"(
1s : start=1
2s : up=1
3s : down=1
4s : part=1
5s : stop=1
6s : start=0 stop=0
7s : Init=1
)";
    CHECK(write_csv(run_until_stable(grafcet, stimuli_from(stimuli, grafcet)).trace) ==
          "time_ms,start,stop,part,up,down,Init,AUdur,AUdoux,"
          "X1,XE2,X21,XS2,X3,X50,X51,X60,X61,press,lamp,pieces\n"
          "0,0,0,0,0,0,0,0,0,1,0,0,0,0,1,0,1,0,0,0,0\n"
          "1000,1,0,0,0,0,0,0,0,0,1,0,0,0,1,0,1,0,0,0,0\n"
          "2000,1,0,0,1,0,0,0,0,0,0,1,0,0,1,0,1,0,1,0,0\n"
          "3000,1,0,0,1,1,0,0,0,0,0,0,1,0,1,0,1,0,0,0,0\n"
          "4000,1,0,1,1,1,0,0,0,0,0,0,0,1,1,0,0,1,0,1,1\n"
          "5000,1,1,1,1,1,0,0,0,0,0,0,0,1,0,1,0,0,0,0,1\n"
          "6000,0,0,1,1,1,0,0,0,1,0,0,0,0,1,0,0,1,0,1,1\n"
          "7000,0,0,1,1,1,1,0,0,1,0,0,0,0,1,0,1,0,0,0,1\n");
}

TEST_CASE("instants: at 0, at each line, at each end of a delay, and at the end; none after it") {
    const char* const grafcet = R"(
input a
output o
graph G { initial 1 : o if 300ms/X1 + 700ms/X1 + 1200ms/X1 }
)";
    CHECK(until_stable(grafcet, "100ms :\n 100ms : a=1\n 500ms : a=1\n 1s : end", "a o") == R"(
0 0 0
100 1 0
300 1 1
500 1 1
700 1 1
1000 1 1
)");
    CHECK(until_stable(grafcet, "700ms : end", "o") == "\n0 0\n300 1\n700 1\n");
    CHECK(until_stable(grafcet, "", "o") == "\n0 0\n");
    CHECK(until_stable(grafcet, "0.25ms : a=1", "a") == "\n0 0\n0.25 1\n");
}

TEST_CASE("scan by scan: up to and including the end; a scan sees every change up to its time") {
    const char* const grafcet = R"(
input a, b
counter n : 0..9
graph G { initial 1  1 -> 1 : ↑a do n := n + 1 }
)";
    const char* const stimuli = R"(
0ms  : b=1
5ms  : a=1
7ms  : b=0
12ms : a=0
17ms : a=1
20ms : b=1 b=0
25ms : a=0
)";
    CHECK(scans(grafcet, stimuli, 10 * millisecond, "a b n") == "\n0 0 1 0\n10 1 0 1\n20 1 0 1\n");
    CHECK(scans(grafcet, stimuli, 5 * millisecond, "a b n") ==
          "\n0 0 1 0\n5 1 1 1\n10 1 0 1\n15 0 0 1\n20 1 0 2\n25 0 0 2\n");
    CHECK(scans(grafcet, stimuli, 26 * millisecond, "a") == "\n0 0\n");
    CHECK(scans(grafcet, stimuli, never - 1, "a") == "\n0 0\n");
}

TEST_CASE("broken assumptions are reported once each, where they are broken first") {
    const Grafcet grafcet = grafcet_from(R"(
input a, b, c
assume /(a . b)
assume a + b + /c
assume /Init ⊕ 0
graph G { initial 1  step 2  1 -> 2 : a . b . c }
)");
    const Stimuli stimuli = stimuli_from(R"(
0ms  : c=1
10ms : a=1
20ms : b=1
30ms : b=0
40ms : b=1 Init=1
)",
                                         grafcet);
    const auto listed = [](const RunResult& result) {
        std::string text;
        for (const auto& broken : result.broken_assumptions) {
            text += format_milliseconds(broken.at) + ":" + std::to_string(broken.assumption) + " ";
        }
        return text;
    };
    CHECK(listed(run_until_stable(grafcet, stimuli)) == "0:1 20:0 40:2 ");
    CHECK(listed(run_scans(grafcet, stimuli, 15 * millisecond)) == "0:1 ");
    CHECK(listed(run_scans(grafcet, stimuli, 20 * millisecond)) == "0:1 20:0 40:2 ");
    // Inputs that nothing sets are 0 from the start.
    const Grafcet contact = grafcet_from("input a assume a graph G { initial 1 }");
    CHECK(listed(run_until_stable(contact, stimuli_from("5ms : a=1", contact))) == "0:0 ");
}

}  // namespace grafwire::testing
