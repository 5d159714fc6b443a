// Where things live: numbers decide, graphs keep together, an assignment comes first; and what an
// assignment must not say.

#include <doctest/doctest.h>

#include "s7/made_listing.h"

namespace grafwire::testing {

namespace {

std::string addresses_of(const std::string& chart, const std::string& io = {}, bool modes = false,
                         s7::ListingOptions options = {}) {
    const MadeListing result = make_listing(chart, io, options, modes);
    REQUIRE_MESSAGE(result.made, result.messages);
    return s7::write_io_assignment(result.made->assignment);
}

std::string refused_addresses(const std::string& chart, const std::string& io,
                              s7::ListingOptions options = {}) {
    const MadeListing result = make_listing(chart, io, options);
    CHECK_FALSE(result.made);
    return result.messages;
}

}  // namespace

TEST_CASE("a number nm with m <= 7 stands in byte n, bit m") {
    CHECK(addresses_of(R"(
        input a
        graph G1 {
          initial 10
          step 18
          step 20
          step named
          step 07
          (13) 10 -> 18 : a
          18 -> 20 : a
          (77) 20 -> named, 07 : a
          (157) named, 07 -> 10 : a
        }
        graph other {
          initial 97
          step 98
          97 -> 98 : a
        })") == R"(E0.0   = a
V21.0  = X10
V21.1  = X18
V22.0  = X20
V21.2  = Xnamed
V21.3  = X07
V29.7  = X97
V29.0  = X98
V81.3  = (13)
V81.0  = (1)
V87.7  = (77)
V95.7  = (157)
V80.0  = (4)
V0.1   = G1
V0.0   = other
)");
}

TEST_CASE("graphs without numbers begin bytes of their own, and fill what is left") {
    CHECK(addresses_of(R"(
        graph G0 { initial a  step b  a -> b : =1  b -> a : =1 }
        graph G1 { initial c  step 2  c -> 2 : =1 }
        graph G2 { initial d  step e  d -> e : =1 })") == R"(V21.0  = Xa
V21.1  = Xb
V20.0  = Xc
V20.2  = X2
V22.0  = Xd
V22.1  = Xe
V80.0  = (0)
V80.1  = (1)
V81.0  = (2)
V82.0  = (3)
V0.0   = G0
V0.1   = G1
V0.2   = G2
)");
}

TEST_CASE("wide tables follow the chart") {
    s7::ListingOptions wide;
    wide.wide_tables = true;
    CHECK(addresses_of(R"(
        input a
        graph G0 { initial 20  step 10  20 -> 10 : a }
        graph G1 { initial 5  5 -> 5 : ↑a })",
                       {}, false, wide) == R"(E0.0   = a
V14.0  = X20
V14.1  = X10
V15.0  = X5
V38.0  = (0)
V39.0  = (1)
V0.0   = G0
V0.1   = G1
)");
}

TEST_CASE("inputs, control inputs that are read, outputs, vars and counters take what is free") {
    const std::string chart = R"(
        input a, b, "c 1"
        output o, p
        var u
        counter n : 0..9
        graph G0 { initial 0 : o, set p on ↑a, n := n + 1 on ↑b  0 -> 0 : u + "c 1" })";
    CHECK(addresses_of(chart, {}, true) == R"(E0.0   = a
E0.1   = b
E0.2   = "c 1"
E0.3   = Init
E0.4   = AUdur
E0.5   = AUdoux
A0.0   = o
A0.1   = p
V6.4   = u
VW100  = n
V20.0  = X0
V80.0  = (0)
V0.0   = G0
)");
    CHECK(addresses_of(chart,
                       "E0.1 = a\nA0.1 = p\nV6.2 = u\nVD104 = n\nI1.0 = AUdoux\nV23.1 = X0\n",
                       true) == R"(E0.1   = a
E0.0   = b
E0.2   = "c 1"
E1.0   = AUdoux
A0.0   = o
A0.1   = p
V6.2   = u
VD104  = n
V23.1  = X0
V80.0  = (0)
V0.0   = G0
)");
    CHECK(make_listing(chart, "E0.1 = a\nA0.1 = p\nE0.0 = b\nE7.7 = \"c 1\"").messages ==
          R"(3:16: 'o' has no address in the assignment; it takes A0.0
)");
}

TEST_CASE("a control input without an address is no part of the program") {
    const std::string chart = "output o\ngraph G0 { initial 0 : o  0 -> 0 : Init }";
    const MadeListing result = make_listing(chart, "E0.3 = AUdur\n", {}, true);
    REQUIRE(result.made);
    const s7::Listing& listing = result.made->listing;
    CHECK(subroutine_text(listing, 3) == R"(-- // (0) 0 -> 0 : Init
  LDN   SM0.0
  =     V80.0
)");
    CHECK(subroutine_text(listing, 4).find("E0.") == std::string::npos);
    CHECK(subroutine_text(listing, 5).find("  LD    E0.3\n  R     V20.0   K1\n") !=
          std::string::npos);
    CHECK(subroutine_text(listing, 8) == R"(-- // o
  LD    V20.0
  =     A0.0
)");
}

TEST_CASE("what an assignment must not say") {
    const std::string chart = R"(
        input start
        output lamp
        counter n : 0..9
        graph G0 { initial 0 : lamp, n := n + 1 on ↑start
(1) 0 -> 0 : start })";
    CHECK(refused_addresses(
              chart,
              "E0.0 = strat\nA0.0 = start\nE0.1 = lamp\nVB100 = n\nV19.7 = X0\nV1.0 = (1)\n"
              "VW104 = G0\n") == R"(1:1: the chart has no 'strat'; did you mean 'start'?
2:1: A0.0 cannot be the address of 'start': an input is a bit of E, M, V or SM
3:1: E0.1 cannot be the address of 'lamp': what is written is a bit of A, M or V
4:1: VB100 cannot be the address of 'n': a counter is a word or double word of V or M, like VW100
5:1: V19.7 cannot be the address of 'X0': a step is a bit of the table Ts, V20.0 … V29.7
6:1: V1.0 cannot be the address of '(1)': a transition is a bit of the table Tt, V80.0 … V99.7
7:1: VW104 cannot be the address of 'G0': a graph is a bit of the table Tfig, V0.0 … V1.7
)");
    CHECK(refused_addresses(chart, "V2.0 = lamp\nVW4 = n\nEB0 = start\n") ==
          R"(1:1: V2.0 cannot be the address of 'lamp': the method uses it itself
2:1: VW4 cannot be the address of 'n': the method uses it itself
3:1: EB0 cannot be the address of 'start': a bit is wanted, like E0.0 or V6.0
)");
    CHECK(refused_addresses(chart, "V70.0 = lamp\n") ==
          R"(1:1: V70.0 cannot be the address of 'lamp': the method uses it itself
)");
    CHECK(refused_addresses(chart, "VW9 = n") ==
          R"(1:1: VW9 cannot be the address of 'n': the method uses it itself
)");
    s7::ListingOptions wide;
    wide.wide_tables = true;
    CHECK(
        refused_addresses(chart, "V14.0 = X0", wide) ==
        R"(1:1: V14.0 cannot be the address of 'X0': in wide tables the place of a step follows from the chart; leave it out
)");
}

}  // namespace grafwire::testing
