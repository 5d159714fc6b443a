#include <doctest/doctest.h>

#include "evolution/run_text.h"
#include "trace/trace.h"

namespace grafwire::testing {

namespace {

const char* const manipulator = R"(
grafcet manipulator "Manipulateur en L"

input  v0, v1, h0, h1, dcy, au
output "V+", "H-", "H+"

graph G0 {
  initial 0 : G1{}
  step 1    : G1{10}
  step 2
  step 3    : G1{*}

  (0) 0 -> 1 : ↑dcy . /au
  (1) 1 -> 2 : 1
  (2) 2 -> 3 : au
  (3) 3 -> 0 : /au
}

graph G1 {
  initial 10 : "H+"
  step 11    : "V+"
  step 12    : "H-" if v0
  step 13

  (10) 10 -> 11 : h1
  (11) 11 -> 12 : v1
  (12) 12 -> 13 : h0
  (13) 13 -> 10 : 5s/X13
}
)";

}  // namespace

TEST_CASE("a whole life of the manipulator, until stable") {
    const char* const stimuli = R"(
0ms   : v0=1 h0=1
100ms : dcy=1
+50ms : dcy=0
1s    : h1=1 h0=0
2s    : v1=1 v0=0
2.5s  : v1=0 v0=1
3s    : au=1
3.5s  : h0=1 h1=0
4s    : au=0
5s    : dcy=1
6s    : h1=1 h0=0 dcy=0
7s    : v1=1 v0=0
8s    : h0=1
9s    : h1=0 v1=0
14s   : end
)";
    const Grafcet grafcet = grafcet_from(manipulator);
    const RunResult result = run_until_stable(grafcet, stimuli_from(stimuli, grafcet));
    CHECK_FALSE(result.unstable_at.has_value());
    // Step 1 is passed within an instant; step 13 ends 5 s after 8 s, an instant of its own.
    CHECK(write_csv(result.trace) ==
          R"(time_ms,v0,v1,h0,h1,dcy,au,Init,AUdur,AUdoux,X0,X1,X2,X3,X10,X11,X12,X13,V+,H-,H+
0,1,0,1,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0
100,1,0,1,0,1,0,0,0,0,0,0,1,0,1,0,0,0,0,0,1
150,1,0,1,0,0,0,0,0,0,0,0,1,0,1,0,0,0,0,0,1
1000,1,0,0,1,0,0,0,0,0,0,0,1,0,0,1,0,0,1,0,0
2000,0,1,0,1,0,0,0,0,0,0,0,1,0,0,0,1,0,0,0,0
2500,1,0,0,1,0,0,0,0,0,0,0,1,0,0,0,1,0,0,1,0
3000,1,0,0,1,0,1,0,0,0,0,0,0,1,0,0,1,0,0,1,0
3500,1,0,1,0,0,1,0,0,0,0,0,0,1,0,0,1,0,0,1,0
4000,1,0,1,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0
5000,1,0,1,0,1,0,0,0,0,0,0,1,0,1,0,0,0,0,0,1
6000,1,0,0,1,0,0,0,0,0,0,0,1,0,0,1,0,0,1,0,0
7000,0,1,0,1,0,0,0,0,0,0,0,1,0,0,0,1,0,0,0,0
8000,0,1,1,1,0,0,0,0,0,0,0,1,0,0,0,0,1,0,0,0
9000,0,0,1,0,0,0,0,0,0,0,0,1,0,0,0,0,1,0,0,0
13000,0,0,1,0,0,0,0,0,0,0,0,1,0,1,0,0,0,0,0,1
14000,0,0,1,0,0,0,0,0,0,0,0,1,0,1,0,0,0,0,0,1
)");
}

TEST_CASE("the manipulator scan by scan") {
    // 100: ↑dcy. 200: 1 → 2 while h1 = 0 keeps 10. 300: h1 and h0 let 10 → 11 and so on, one step
    // a scan. 600: au; 3 is active from 600 on and freezes G1 from 700 on, so 12 → 13 at 600 is
    // the last move. 800: au = 0 leads to 0, which empties G1.
    CHECK(scans(manipulator,
                "0ms : v0=1 h0=1\n 100ms : dcy=1\n 300ms : h1=1\n 400ms : v1=1 h0=0\n"
                "600ms : au=1 h0=1\n 800ms : au=0\n 900ms : end",
                100 * millisecond, "X0 X1 X2 X3 X10 X11 X12 X13 H- H+") == R"(
0 1 0 0 0 0 0 0 0 0 0
100 0 1 0 0 1 0 0 0 0 1
200 0 0 1 0 1 0 0 0 0 1
300 0 0 1 0 0 1 0 0 0 0
400 0 0 1 0 0 0 1 0 1 0
500 0 0 1 0 0 0 1 0 1 0
600 0 0 0 1 0 0 0 1 0 0
700 0 0 0 1 0 0 0 1 0 0
800 1 0 0 0 0 0 0 0 0 0
900 1 0 0 0 0 0 0 0 0 0
)");
}

}  // namespace grafwire::testing
