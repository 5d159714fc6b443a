// Writing a listing and reading it back gives the same listing.

#include <doctest/doctest.h>

#include "s7/instruction_set.h"
#include "s7/random_listing.h"
#include "s7/write_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

namespace {

/// Two listings, places apart.
std::string difference(const Listing& a, const Listing& b) {
    if (a.head != b.head) return "head";
    if (a.networks.size() != b.networks.size()) return "number of networks";
    for (std::size_t n = 0; n < a.networks.size(); ++n) {
        const Network& one = a.networks[n];
        const Network& other = b.networks[n];
        const std::string where = "network " + std::to_string(one.number);
        if (one.number != other.number || one.comment != other.comment) return where;
        if (one.instructions.size() != other.instructions.size()) return where + ", size";
        for (std::size_t i = 0; i < one.instructions.size(); ++i) {
            const Instruction& x = one.instructions[i];
            const Instruction& y = other.instructions[i];
            if (x.operation != y.operation || x.width != y.width || x.compare != y.compare ||
                x.operands != y.operands || x.comment != y.comment ||
                x.printed_offset != y.printed_offset) {
                return where + ", instruction " + std::to_string(i + 1);
            }
        }
    }
    return {};
}

}  // namespace

TEST_CASE("a written listing reads back as it was") {
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const Listing listing = random_listing(seed);
        Listing with_offsets = listing;
        set_offsets(with_offsets);
        for (const Mnemonics mnemonics : {Mnemonics::simatic, Mnemonics::international}) {
            for (const bool offsets : {true, false}) {
                const std::string text = write_listing(listing, {mnemonics, offsets});
                CAPTURE(seed);
                CAPTURE(text);
                REQUIRE(difference(offsets ? with_offsets : listing, read_listing(text)) == "");
                REQUIRE(write_listing(read_listing(text), {mnemonics, offsets}) == text);
            }
        }
    }
}

TEST_CASE("what a listing looks like, in both spellings") {
    const Listing listing = read_listing(R"(// Un essai
NETWORK1 // Calcul
LD SM0.1
CALL K0
MEND
NETWORK2
SBR K0
LDN E0.4 // dcy
U T37
= A0.0
FILL KHFFFF VW0 K1
UB>= VB100 K1
S V40.1 K1
RET
)");
    CHECK(write_listing(listing, {Mnemonics::simatic, true}) == R"(// Un essai

NETWORK1 // Calcul
    0 LD    SM0.1
    2 CALL  K0
    5 MEND

NETWORK2
    6 SBR   K0
    9 LDN   E0.4      // dcy
   11 U     T37
   13 =     A0.0
   15 FILL  KHFFFF  VW0     K1
   25 UB>=  VB100   K1
   30 S     V40.1   K1
   37 RET
)");
    CHECK(write_listing(listing, {Mnemonics::international, false}) == R"(// Un essai

NETWORK1 // Calcul
      LD    SM0.1
      CALL  0
      MEND

NETWORK2
      SBR   0
      LDN   I0.4      // dcy
      A     T37
      =     Q0.0
      FILL  16#FFFF VW0     1
      AB>=  VB100   1
      S     V40.1   1
      RET
)");
}

}  // namespace grafwire::testing
