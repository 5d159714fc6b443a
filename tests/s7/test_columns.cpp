// Print with two columns.

#include <doctest/doctest.h>

#include "s7/write_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

namespace {

void check_columns(const std::string& folded, const std::string& in_order) {
    const std::string messages = messages_of(folded);
    CHECK(messages.find("the offsets do not ascend: from here on the instructions are put in "
                        "their order") != std::string::npos);
    CHECK(write_listing(read_listing(folded), {}) == write_listing(read_listing(in_order), {}));
}

}  // namespace

TEST_CASE("the right column stands beside the left one") {
    check_columns(R"(NETWORK1 // Receptivites NETWORK4
0 LD E0.5 14 LD E0.3
NETWORK2 16 U V0.1

2 UN V0.0
5 = V80.0
NETWORK3
8 LDN E0.5
10 MOVB K0 VB2
NETWORK5
22 MEND

19 = V81.0
)",
                  R"(NETWORK1 // Receptivites
0 LD E0.5
NETWORK2
2 UN V0.0
5 = V80.0
NETWORK3
8 LDN E0.5
10 MOVB K0 VB2
NETWORK4
14 LD E0.3
16 U V0.1
19 = V81.0
NETWORK5
22 MEND
)");
}

TEST_CASE("pieces of the right column stand between those of the left one") {
    // Cordier, example 1, SBR 5, in short: network 3 begins after the piece that belongs to 4.
    check_columns(R"(NETWORK1
0 LD SM0.0
NETWORK2 // Calcul de Tpulse
2 LD SM0.0
NETWORK3 // Traitement des forçages
18 INVD VD2
22 UNDD VD24 VD2
4 NOP K0
NETWORK4 // Ts=(Ts et (non Tf0)) ou Tf1
6 MOVD VD70 VD2
12 ORD VD60 VD2
28 MOVD VD2 VD20
NETWORK5
34 MEND
)",
                  R"(NETWORK1
0 LD SM0.0
NETWORK2 // Calcul de Tpulse
2 LD SM0.0
NETWORK3 // Traitement des forçages
4 NOP K0
NETWORK4 // Ts=(Ts et (non Tf0)) ou Tf1
6 MOVD VD70 VD2
12 ORD VD60 VD2
18 INVD VD2
22 UNDD VD24 VD2
28 MOVD VD2 VD20
NETWORK5
34 MEND
)");
}

TEST_CASE("a network at the foot of a column, its instructions at the end") {
    // Cordier, example 2, SBR 4, in short.
    check_columns(R"(NETWORK1
0 LD V11.1
3 S V50.0 K1
NETWORK2
NETWORK3
20 LD V11.3
23 S V51.3 K1
NETWORK4
30 MEND

10 LD V11.2
13 S V51.2 K1
)",
                  R"(NETWORK1
0 LD V11.1
3 S V50.0 K1
NETWORK2
10 LD V11.2
13 S V51.2 K1
NETWORK3
20 LD V11.3
23 S V51.3 K1
NETWORK4
30 MEND
)");
}

TEST_CASE("what columns cannot be put in order") {
    CHECK(messages_of("NETWORK1\n4 LD E0.0\n0 LD E0.1\n= A0.0\n6 MEND\n")
              .find("this instruction has none: write all of them, or none") != std::string::npos);
    CHECK(messages_of("NETWORK1\n4 LD E0.0\n0 LD E0.1\n4 MEND\n")
              .find("another instruction has the offset 4 too") != std::string::npos);
    CHECK(messages_of("NETWORK1\n2 LD E0.0\n4 MEND\n0 LD E0.0\nNETWORK2\n")
              .find("the offsets do not tell where network 2 begins") != std::string::npos);
}

}  // namespace grafwire::testing
