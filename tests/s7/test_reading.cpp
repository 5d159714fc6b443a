// What the reader makes of listings as people and books write them.

#include <doctest/doctest.h>

#include "s7/write_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

namespace {

std::string read_and_written(const std::string& text) {
    return write_listing(read_listing(text), {});
}

}  // namespace

TEST_CASE("networks with and without numbers, comments in any place") {
    CHECK(read_and_written(R"(// Essai
//
// de lecture
NETWORK 3 // Le premier
LD E0.4 // dcy
// et encore
= A0.0
Network
// sans numero
MEND)") == R"(// Essai
//
// de lecture

NETWORK3 // Le premier
    0 LD    E0.4      // dcy et encore
    2 =     A0.0
NETWORK4 // sans numero
    4 MEND
)");
}

TEST_CASE("what is put right is said") {
    const std::string text = R"(NETWORK1 // Execution du sous programme
SR0 au premier tour automate
  0 LD    SM0.1
  2 S     V40.1   KI
  9 S     V50.0   KI
 16 S     V60.0   K1
NETWORK2
 23 CRET
)";
    CHECK(messages_of("NETWORK1 // Execution du sous programme\nSR0 au premier tour\n"
                      "  0 LD    SM0.1\n  2 S     V40.1   KI\n  9 S     V50.0   KI\n 17 MEND\n") ==
          R"(test.awl:2:1: warning: a line is read as the continuation of the comment before it
SR0 au premier tour
^
test.awl:4:19: warning: 'KI' is read as 'K1', here and in 1 more place
  2 S     V40.1   KI
                  ^
test.awl:6:5: warning: offset 17: the instruction before it ends at 16
 17 MEND
    ^
)");
    CHECK(messages_of(text).find("CRET does not belong into the main program") !=
          std::string::npos);
    CHECK(messages_of("NETWORK5\nLD SM0.0\nNETWORK5\n= A0.0\n") ==
          R"(test.awl:3:1: warning: network 5 comes after network 5: their numbers do not ascend
NETWORK5
^
test.awl:4:1: warning: the main program ends here without MEND
= A0.0
^
)");
}

TEST_CASE("a mistyped first instruction is no continuation of a comment") {
    CHECK(messages_of("NETWORK1 // Essai\nLDX E0.4\nMEND\n").find("unknown instruction 'LDX'") !=
          std::string::npos);
    CHECK(messages_of("NETWORK1 // Essai\nRTE\nMEND\n").find("unknown instruction 'RTE'") !=
          std::string::npos);
}

TEST_CASE("names with an address") {
    const IoAssignment io = read_assignment("E0.4 = dcy\nA0.0 = \"V+\"\nVW100 = pieces\n");
    const SourceFile source{"test.awl",
                            "NETWORK1\nLD dcy\nUW>= pieces K3\n= \"V+\"\nU dvy\nMEND\n"};
    Diagnostics diagnostics;
    CHECK_FALSE(parse_listing(source, {Cpu::cpu_214, &io, false}, diagnostics));
    CHECK(
        format_diagnostics(diagnostics, source) ==
        R"(test.awl:5:3: error: 'dvy' is no address, no constant and no name with an address; did you mean 'dcy'?
U dvy
  ^
)");
    const SourceFile good{"test.awl", "NETWORK1\nLD dcy\nUW>= pieces K3\n= \"V+\"\nMEND\n"};
    Diagnostics none;
    const auto listing = parse_listing(good, {Cpu::cpu_214, &io, false}, none);
    REQUIRE(listing);
    CHECK(write_listing(*listing, {Mnemonics::simatic, false}) ==
          "NETWORK1\n      LD    E0.4\n      UW>=  VW100   K3\n      =     A0.0\n      MEND\n");
}

TEST_CASE("the published listings are read, with these remarks") {
    CHECK(messages_of(example_text("s7-200/positioning-axis.awl")) == "");
    CHECK(messages_of(example_text("s7-200/manipulator.awl"), Cpu::cpu_212) == "");
    CHECK(messages_of(example_text("s7-200/manipulator-modes.awl")) == "");
    CHECK(messages_of(example_text("s7-200/manipulator.printed.awl")).find("error") ==
          std::string::npos);
    CHECK(messages_of(example_text("s7-200/manipulator.printed.awl"), Cpu::cpu_212)
              .find("T110: the CPU 212 has 64 places of this area") != std::string::npos);
}

}  // namespace grafwire::testing
