// What single instructions do, and how they are strung together.

#include <doctest/doctest.h>

#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

TEST_CASE("logic on the stack") {
    Controller plc(R"(NETWORK1
LD E0.0
U E0.1
LD E0.2
UN E0.3
OLD
= A0.0
LD E0.0
O E0.1
LDN E0.2
ON E0.3
ULD
= A0.1
LD E0.0
LPS
U E0.1
= A0.2
LRD
U E0.2
= A0.3
LPP
NOT
= A0.4
MEND
)");
    for (unsigned bits = 0; bits < 16; ++bits) {
        const bool a = (bits & 1U) != 0;
        const bool b = (bits & 2U) != 0;
        const bool c = (bits & 4U) != 0;
        const bool d = (bits & 8U) != 0;
        plc.set("E0.0", a);
        plc.set("E0.1", b);
        plc.set("E0.2", c);
        plc.set("E0.3", d);
        plc.scan();
        CHECK(plc.bit("A0.0") == ((a && b) || (c && !d)));
        CHECK(plc.bit("A0.1") == ((a || b) && (!c || !d)));
        CHECK(plc.bit("A0.2") == (a && b));
        CHECK(plc.bit("A0.3") == (a && c));
        CHECK(plc.bit("A0.4") == !a);
    }
}

TEST_CASE("edges last one scan") {
    Controller plc("NETWORK1\nLD E0.0\nEU\n= A0.0\nLD E0.0\nED\n= A0.1\nMEND\n");
    const auto scan_with = [&](bool value) {
        plc.set("E0.0", value);
        plc.scan();
        return std::pair(plc.bit("A0.0"), plc.bit("A0.1"));
    };
    CHECK(scan_with(false) == std::pair(false, false));
    CHECK(scan_with(true) == std::pair(true, false));
    CHECK(scan_with(true) == std::pair(false, false));
    CHECK(scan_with(false) == std::pair(false, true));
    CHECK(scan_with(false) == std::pair(false, false));
}

TEST_CASE("words have their high byte first") {
    Controller plc(R"(NETWORK1
LD SM0.0
MOVW KH1234 VW10
MOVD KHFFFF0001 VD20
MOVB EB0 VB30
INVB VB30
UNDW KHFF00 VW10
MEND
)");
    plc.set("E0.1", true);
    plc.scan();
    CHECK(plc.value("VB10") == 0x12);
    CHECK(plc.value("VB11") == 0);
    CHECK(plc.bit("V10.1"));
    CHECK(plc.value("VD20") == -65535);
    CHECK(plc.value("VW20") == -1);
    CHECK(plc.value("VB23") == 1);
    CHECK(plc.value("VB30") == 0xfd);
}

TEST_CASE("FILL, BMW and BMB") {
    Controller plc(R"(NETWORK1
LD SM0.1
FILL KH0102 VW10 K3
BMB VB10 VB20 K5
BMW VW20 VW21 K2
MEND
)");
    plc.scan();
    CHECK(plc.value("VD10") == 0x01020102);
    CHECK(plc.value("VW14") == 0x0102);
    CHECK(plc.value("VW16") == 0);
    // Copied onto itself, one byte further on.
    CHECK(plc.value("VB20") == 1);
    CHECK(plc.value("VD21") == 0x01020102);
}

TEST_CASE("arithmetic goes round at the end of the width") {
    Controller plc(R"(NETWORK1
LD SM0.0
MOVW K32767 VW10
INCW VW10
MOVW K5 VW12
-I K7 VW12
MOVD K-1 VD20
+D K3 VD20
DECB VB30
MEND
)");
    plc.scan();
    CHECK(plc.value("VW10") == -32768);
    CHECK(plc.value("VW12") == -2);
    CHECK(plc.value("VD20") == 2);
    CHECK(plc.value("VB30") == 255);
}

TEST_CASE("comparisons: bytes without a sign, words with one") {
    Controller plc(R"(NETWORK1
LD SM0.0
MOVW K-1 VW10
LDB>= VB10 K200
= A0.0
LDW< VW10 K0
= A0.1
LD SM0.0
UW= VW10 KHFFFF
= A0.2
LD E0.0
OW<> VW10 K1
= A0.3
LDD<= VD20 K0
UD> VD20 K-1
= A0.4
MEND
)");
    plc.scan();
    for (const std::string output : {"A0.0", "A0.1", "A0.2", "A0.3", "A0.4"}) {
        CAPTURE(output);
        CHECK(plc.bit(output));
    }
}

TEST_CASE("set, reset and work on words are done where the top of the stack is 1") {
    Controller plc(R"(NETWORK1
LD E0.0
S V10.6 K4
LDN E0.0
R V10.7 K2
MOVB K9 VB20
MEND
)");
    plc.set("E0.0", true);
    plc.scan();
    CHECK(plc.value("VW10") == 0xC003 - 0x10000);
    CHECK(plc.value("VB20") == 0);
    plc.set("E0.0", false);
    plc.scan();
    CHECK(plc.value("VW10") == 0x4002);
    CHECK(plc.value("VB20") == 9);
}

TEST_CASE("a subroutine begins with 1 on the stack, and leaves the stack as it was") {
    Controller plc(R"(NETWORK1
LD E0.0
CALL K1
= A0.0
MEND
NETWORK2
SBR K1
MOVB K7 VB10
LDN SM0.0
= A0.1
RET
)");
    plc.scan();
    CHECK(plc.value("VB10") == 0);
    CHECK_FALSE(plc.bit("A0.0"));
    plc.set("E0.0", true);
    plc.scan();
    CHECK(plc.value("VB10") == 7);
    CHECK(plc.bit("A0.0"));
}

TEST_CASE("without LD a network works with what the one before has left") {
    Controller plc("NETWORK1\nLD E0.0\n= A0.0\nNETWORK2\nMOVB K7 VB10\nMEND\n");
    plc.scan();
    CHECK(plc.value("VB10") == 0);
    plc.set("E0.0", true);
    plc.scan();
    CHECK(plc.value("VB10") == 7);
}

TEST_CASE("jumps, conditional returns and ends") {
    Controller plc(R"(NETWORK1
LD E0.0
JMP K3
LD SM0.0
S V10.0 K1
LBL K3
LD SM0.0
CALL K0
LD E0.2
END
LD SM0.0
S V10.2 K1
MEND
NETWORK2
SBR K0
LD E0.1
CRET
LD SM0.0
S V10.1 K1
RET
)");
    plc.set("E0.0", true);
    plc.set("E0.1", true);
    plc.set("E0.2", true);
    plc.scan();
    CHECK(plc.value("VB10") == 0);
    plc.set("E0.0", false);
    plc.scan();
    CHECK(plc.value("VB10") == 1);
    plc.set("E0.1", false);
    plc.scan();
    CHECK(plc.value("VB10") == 3);
    plc.set("E0.2", false);
    plc.scan();
    CHECK(plc.value("VB10") == 7);
}

TEST_CASE("SM0.0 is 1, SM0.1 is 1 in the first scan") {
    Controller plc("NETWORK1\nLD SM0.0\n= A0.0\nLD SM0.1\n= A0.1\nMEND\n");
    plc.scan();
    CHECK(plc.bit("A0.0"));
    CHECK(plc.bit("A0.1"));
    plc.scan();
    CHECK(plc.bit("A0.0"));
    CHECK_FALSE(plc.bit("A0.1"));
}

TEST_CASE("a scan that goes round in a circle is an error with its place") {
    Controller plc("NETWORK4\nLBL K1\nLD SM0.0\nJMP K1\nMEND\n");
    const auto end = plc.machine.scan(plc.state, plc.inputs, 0);
    REQUIRE(end.error);
    CHECK(end.error->network == 4);
    CHECK(end.error->message.english.find("does not come to an end") != std::string::npos);
}

TEST_CASE("the network that wrote a bit last") {
    Controller plc(R"(NETWORK1
LD SM0.0
FILL K0 VW10 K2
NETWORK2
LD E0.0
S V11.1 K1
NETWORK3
LD E0.1
= V12.0
MEND
)");
    plc.machine.record();
    const auto writer = [&](const std::string& text) {
        const auto found = plc.machine.writer(operand(text));
        if (!found) return std::string("nobody");
        return std::to_string(found->network) + (found->in_last_scan ? "" : " before");
    };
    plc.set("E0.0", true);
    plc.scan();
    CHECK(writer("V11.1") == "1");
    CHECK(writer("V12.0") == "2");
    CHECK(writer("V13.0") == "0");
    CHECK(writer("V20.0") == "nobody");
    plc.set("E0.0", false);
    plc.scan();
    CHECK(writer("V11.1") == "0");
    const auto reads = plc.machine.reads();
    REQUIRE(reads.size() == 3);
    CHECK(reads[1].network == 1);
    CHECK(reads[1].operand == operand("E0.0"));
    CHECK_FALSE(reads[1].value);
}

TEST_CASE("a condition on an open input: which one") {
    Controller plc("NETWORK1\nLD E0.1\nO E0.3\n= V10.0\nNETWORK2\nLD V10.0\nS A0.0 K1\nMEND\n");
    plc.inputs.known[0] = 0xf5;
    auto end = plc.machine.scan(plc.state, plc.inputs, 0);
    REQUIRE(end.needs);
    CHECK(*end.needs == 1);
    plc.inputs.known[0] = 0xfd;
    plc.inputs.value[0] = 0x08;
    end = plc.machine.scan(plc.state, plc.inputs, 0);
    CHECK(end.is_done());
    CHECK(plc.bit("A0.0"));
}

}  // namespace grafwire::testing
