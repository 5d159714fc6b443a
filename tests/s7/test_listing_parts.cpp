// What the parts of a generated listing look like: conditions, counters, timers, forcing, SBR 0.

#include <doctest/doctest.h>

#include "s7/made_listing.h"

namespace grafwire::testing {

namespace {

/// One subroutine of the listing of a chart.
std::string part_of(const std::string& chart, int number) {
    const MadeListing result = make_listing(chart);
    REQUIRE_MESSAGE(result.made, result.messages);
    return subroutine_text(result.made->listing, number);
}

}  // namespace

TEST_CASE("conditions are written as one reads a ladder network aloud") {
    CHECK(part_of(R"(
        input a, b, c, d
        graph G0 {
          initial 0
          (0) 0 -> 0 : a . /b + c
          (1) 0 -> 0 : (a + b) . (c + /d)
          (2) 0 -> 0 : /(a . b)
          (3) 0 -> 0 : a ⊕ /b
          (4) 0 -> 0 : a ⊕ b ⊕ c
          (5) 0 -> 0 : =1
        })",
                  3) == R"(-- // (0) 0 -> 0 : a./b + c
  LD    E0.0
  UN    E0.1
  O     E0.2
  U     V0.0
  =     V80.0
-- // (1) 0 -> 0 : (a + b).(c + /d)
  LD    E0.0
  O     E0.1
  LD    E0.2
  ON    E0.3
  ULD
  U     V0.0
  =     V80.1
-- // (2) 0 -> 0 : /(a.b)
  LD    E0.0
  U     E0.1
  NOT
  U     V0.0
  =     V80.2
-- // (3) 0 -> 0 : a ⊕ /b
  LD    E0.0
  U     E0.1
  LDN   E0.0
  UN    E0.1
  OLD
  U     V0.0
  =     V80.3
-- // a part of (4) 0 -> 0 : a ⊕ b ⊕ c
  LD    E0.0
  UN    E0.1
  LDN   E0.0
  U     E0.1
  OLD
  =     V6.0
-- // (4) 0 -> 0 : a ⊕ b ⊕ c
  LD    V6.0
  UN    E0.2
  LDN   V6.0
  U     E0.2
  OLD
  U     V0.0
  =     V80.4
-- // (5) 0 -> 0 : 1
  LD    SM0.0
  U     V0.0
  =     V80.5
)");
}

TEST_CASE("a condition deeper than the stack goes by way of working bits") {
    std::string deep = "a";
    for (int i = 0; i < 5; ++i) deep = "a + b.(" + deep + ")";
    CHECK(part_of("input a, b\ngraph G0 { initial 0\n(0) 0 -> 0 : " + deep + " }", 3) ==
          R"(-- // a part of (0) 0 -> 0 : a + b.(a + b.(a + b.(a + b.(a + b.a))))
  LD    E0.0
  LD    E0.1
  LD    E0.0
  LD    E0.1
  LD    E0.0
  LD    E0.1
  LD    E0.0
  LD    E0.1
  U     E0.0
  OLD
  ULD
  OLD
  ULD
  OLD
  ULD
  OLD
  =     V6.0
-- // (0) 0 -> 0 : a + b.(a + b.(a + b.(a + b.(a + b.a))))
  LD    E0.0
  LD    E0.1
  U     V6.0
  OLD
  U     V0.0
  =     V80.0
)");
}

TEST_CASE("counters: comparisons, sums, and what holds them in their range") {
    const std::string chart = R"(
        input a
        counter n : 0..9
        counter m : -3..3
        graph G0 {
          initial 0 : n := n + 1 on ↑a
          step 1 : m := n - 5, n := 7
          (0) 0 -> 1 : [n < 5] . [n <> m]
          (1) 1 -> 0 : [n + m >= 3]
        })";
    CHECK(part_of(chart, 3) == R"(-- // (0) 0 -> 1 : [n < 5].[n <> m]
  LDW>= VW100   K5
  NOT
  LDW=  VW100   VW102
  NOT
  ULD
  U     V0.0
  =     V80.0
-- // (1) 1 -> 0 : [n + m >= 3]: the sums
  LD    SM0.0
  MOVW  VW100   VW2
  +I    VW102   VW2
-- // a part of (1) 1 -> 0 : [n + m >= 3]
  LDW>= VW2     K3
  =     V6.2
-- // (1) 1 -> 0 : [n + m >= 3]
  LD    V6.2
  U     V0.0
  =     V80.1
)");
    CHECK(part_of(chart, 5) == R"(-- // Tpulse
  LD    SM0.0
  CALL  K10
-- // There are no forcing orders
  NOP   K0
-- // Ts = (Ts and not Tf0) or Tf1
  LD    SM0.0
  MOVD  VD70    VD2
  INVD  VD2
  UNDD  VD20    VD2
  ORD   VD60    VD2
  MOVD  VD2     VD20
  MOVD  VD74    VD2
  INVD  VD2
  UNDD  VD24    VD2
  ORD   VD64    VD2
  MOVD  VD2     VD24
  MOVW  VW78    VW2
  INVW  VW2
  UNDW  VW28    VW2
  ORW   VW68    VW2
  MOVW  VW2     VW28
-- // Tpulse
  LD    SM0.0
  CALL  K10
-- // value of n on an event in step 0: the sum
  LD    SM0.0
  MOVW  VW100   VW2
  +I    K1      VW2
-- // not above 9
  LDW>= VW2     K9
  MOVW  K9      VW2
-- // value of n on an event in step 0
  LD    SM0.0
  MOVW  VW2     VW104
-- // m on activation of step 1: the sum
  LD    SM0.0
  MOVW  VW100   VW2
  -I    K5      VW2
-- // not above 3
  LDW>= VW2     K3
  MOVW  K3      VW2
-- // not below -3
  LDW<= VW2     K-3
  MOVW  K-3     VW2
-- // m on activation of step 1
  LD    V30.1
  MOVW  VW2     VW102
-- // n on activation of step 1
  LD    V30.1
  MOVW  K7      VW100
-- // n on an event in step 0
  LD    V20.0
  U     V6.1
  MOVW  VW104   VW100
)");
}

TEST_CASE("time conditions") {
    const std::string chart = R"(
        input a
        graph G0 {
          initial 0
          (0) 0 -> 0 : 5s/X0
          (1) 0 -> 0 : 20ms/a
          (2) 0 -> 0 : 3ms/a
          (3) 0 -> 0 : 1s/a/2s
          (4) 0 -> 0 : 0s/(a + X0)/200ms
        })";
    CHECK(part_of(chart, 6) == R"(-- // 5s/X0
  LD    V20.0
  TON   T37     K50
-- // 20ms/a
  LD    E0.0
  TON   T33     K2
-- // 3ms/a
  LD    E0.0
  TON   T32     K3
-- // value of 3ms/a
  LD    T32
  =     V6.0
-- // 1s/a/2s
  LD    E0.0
  TON   T38     K10
-- // off-delay of 1s/a/2s
  LDN   E0.0
  TON   T39     K20
-- // value of 1s/a/2s
  LD    T38
  LD    V6.1
  UN    T39
  OLD
  =     V6.1
-- // off-delay of 0s/(a + X0)/200ms
  LD    E0.0
  O     V20.0
  NOT
  TON   T40     K2
-- // value of 0s/(a + X0)/200ms
  LD    E0.0
  O     V20.0
  LD    V6.2
  UN    T40
  OLD
  =     V6.2
)");
    CHECK(part_of(chart, 3) == R"(-- // (0) 0 -> 0 : 5s/X0
  LD    T37
  U     V0.0
  =     V80.0
-- // (1) 0 -> 0 : 20ms/a
  LD    T33
  U     V0.0
  =     V80.1
-- // (2) 0 -> 0 : 3ms/a
  LD    V6.0
  U     V0.0
  =     V80.2
-- // (3) 0 -> 0 : 1s/a/2s
  LD    V6.1
  U     V0.0
  =     V80.3
-- // (4) 0 -> 0 : 0s/(a + X0)/200ms
  LD    V6.2
  U     V0.0
  =     V80.4
)");
}

TEST_CASE("SBR 0 begins everything at its first value") {
    CHECK(part_of(R"(
        input a
        output o
        var u, v
        counter n : -2..9
        graph G0 {
          initial 0 : set o, u := v, n := n + 1
          initial 10
          0 -> 0 : ↑a . 2s/X0 + ↑↓a + 0s/a/1s
          10 -> 10 : u
        })",
                  0) == R"(-- // Tfig = 1: no graph is frozen
  LD    SM0.0
  FILL  KHFFFF  VW0     K1
-- // All other tables = 0
  LD    SM0.0
  FILL  K0      VW10    K45
-- // Initial steps
  LD    SM0.0
  =     V10.0
  =     V20.0
  =     V11.0
  =     V21.0
-- // Memories of the chart = 0
  LD    SM0.0
  R     A0.0    K1
  R     V6.1    K1
  R     V6.3    K1
  R     V6.5    K4
-- // n
  LD    SM0.0
  MOVW  K-2     VW100
-- // memory of ↑a
  LD    E0.0
  =     V6.0
-- // memory of ↓a
  LD    E0.0
  =     V6.2
-- // memory of ↑↓a
  LD    V6.3
  =     V6.4
-- // Timers
  LD    SM0.0
  R     T37     K2
)");
}

TEST_CASE("orders, enclosures and modes") {
    const MadeListing result = make_listing(R"(
        output o
        graph G0 {
          initial 0 : G1{12}, G2{INIT}
          step 1 : G1{*}
          0 -> 1 : =1
        }
        graph G1 { step 10 : o  step 11  step 12  10 -> 11 : =1 }
        graph G2 { initial 20  step 21 encloses G3{30}  20 -> 21 : =1 }
        graph G3 { step 30  step 31  30 -> 31 : =1 })",
                                            {}, {}, true);
    REQUIRE_MESSAGE(result.made, result.messages);
    CHECK(subroutine_text(result.made->listing, 5) == R"(-- // Tpulse
  LD    SM0.0
  CALL  K10
-- // forcing orders of step 0
  LD    V20.0
  S     V71.0   K3
  S     V61.2   K1
  S     V72.0   K2
  S     V62.0   K1
-- // Ts = (Ts and not Tf0) or Tf1
  LD    SM0.0
  MOVD  VD70    VD2
  INVD  VD2
  UNDD  VD20    VD2
  ORD   VD60    VD2
  MOVD  VD2     VD20
  MOVD  VD74    VD2
  INVD  VD2
  UNDD  VD24    VD2
  ORD   VD64    VD2
  MOVD  VD2     VD24
  MOVW  VW78    VW2
  INVW  VW2
  UNDW  VW28    VW2
  ORW   VW68    VW2
  MOVW  VW2     VW28
-- // G3 is enclosed by step 21
  LDN   V22.1
  R     V23.0   K2
-- // activation links of G3
  LD    V22.1
  UN    V12.1
  UN    E0.0
  S     V23.0   K1
-- // AUdur: every step
  LD    E0.1
  R     V20.0   K2
  R     V21.0   K3
  R     V22.0   K2
  R     V23.0   K2
-- // Tpulse
  LD    SM0.0
  CALL  K10
)");
    CHECK(subroutine_text(result.made->listing, 8) == R"(-- // o
  LD    V21.0
  UN    E0.2
  =     A0.0
-- // G1 may evolve
  LDN   V20.1
  =     V0.1
)");
}

}  // namespace grafwire::testing
