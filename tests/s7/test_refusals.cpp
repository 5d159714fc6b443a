// What is no program, and what the reader says of it.

#include <doctest/doctest.h>

#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

TEST_CASE("all that is wrong with the lines of a listing, in one go") {
    CHECK(messages_of(R"(LD E0.0
NETWORK1 // Essai
   0 LDX   E0.4
   2 UM    V20.1
   5 =     A0.9
   7 S     V40.1
  14 MOVW  VW10   VW20   VW30
  20 LD    dcy
  22 MEND  // fin
)") == R"(test.awl:1:1: error: an instruction outside a network: begin it with a line NETWORK 1
LD E0.0
^
test.awl:3:6: error: unknown instruction 'LDX'; did you mean 'LD'?
   0 LDX   E0.4
     ^
test.awl:4:6: error: unknown instruction 'UM'; did you mean 'U'?
   2 UM    V20.1
     ^
test.awl:5:12: error: 'A0.9' is no address: bits are written as V20.1 with bits 0 … 7, bytes, words and double words as VB20, VW20 and VD20
   5 =     A0.9
           ^
test.awl:6:6: error: S takes 2 operands, and there is 1
   7 S     V40.1
     ^
test.awl:7:26: error: MOVW takes 2 operands: 'VW30' is one too many
  14 MOVW  VW10   VW20   VW30
                         ^
test.awl:8:12: error: 'dcy' is no address, no constant and no name with an address; names are given addresses by a table of assignment (--io)
  20 LD    dcy
           ^
)");
}

namespace {

/// The message about a listing whose OB1 has these lines.
std::string complaint(const std::string& lines, Cpu cpu = Cpu::cpu_214) {
    std::string shown = messages_of("NETWORK1\n" + lines, cpu);
    const std::size_t colon = shown.find("error: ");
    REQUIRE_MESSAGE(colon != std::string::npos, shown);
    return shown.substr(colon + 7, shown.find('\n', colon) - colon - 7);
}

}  // namespace

TEST_CASE("operands of the wrong kind, and out of range") {
    CHECK(complaint("LD VB10\nMEND\n") ==
          "operand 1 of LD is VB10, and a bit such as E0.4, V20.1 or T37 is wanted");
    CHECK(
        complaint("= SM0.0\nMEND\n") ==
        "operand 1 of = is SM0.0, and a bit that can be written, such as A0.0 or V20.1 is wanted");
    CHECK(complaint("MOVD VD0 VW2\nMEND\n") ==
          "operand 2 of MOVD is VW2, and a double word such as VD100 that can be written is "
          "wanted");
    CHECK(complaint("S V4095.7 K2\nMEND\n") ==
          "V4095.7 and the 1 behind it: the CPU 214 has 4096 bytes of this area");
    CHECK(complaint("FILL K0 VW1000 K40\nMEND\n", Cpu::cpu_212) ==
          "VW1000 and the 39 behind it: the CPU 212 has 1024 bytes of this area");
    CHECK(complaint("LD V1024.0\nMEND\n", Cpu::cpu_212) ==
          "V1024.0: the CPU 212 has 1024 bytes of this area");
    CHECK(complaint("R T110 K1\nMEND\n", Cpu::cpu_212) ==
          "T110: the CPU 212 has 64 places of this area");
    CHECK(complaint("LD SM0.0\nTON T5 K1\nMEND\n") ==
          "T5 is a timer for TONR: TON takes T32 … T63 and T96 … T127");
    CHECK(complaint("LD SM0.0\nS V0.0 K0\nMEND\n") ==
          "K0: a count is between 1 and 255 (the CPU 214)");
    CHECK(complaint("LD SM0.0\nTON T37 K40000\nMEND\n") ==
          "K40000: a preset is between 0 and 32767 (the CPU 214)");
    CHECK(complaint("CALL K16\nMEND\n", Cpu::cpu_212) ==
          "K16: the number of a subroutine is between 0 and 15 (the CPU 212)");
}

TEST_CASE("control that leads nowhere") {
    CHECK(complaint("CALL K5\nMEND\n") == "there is no subroutine 5: SBR K5");
    CHECK(complaint("JMP K5\nMEND\n") == "there is no label 5: LBL K5");
    CHECK(complaint("JMP K5\nMEND\nNETWORK2\nSBR K0\nLBL K5\nRET\n") ==
          "label 5 is in subroutine 0: a jump stays where it is");
    CHECK(complaint("LBL K5\nLBL K5\nMEND\n") == "label 5 is there already");
    CHECK(complaint("MEND\nNETWORK2\nSBR K0\nRET\nNETWORK3\nSBR K0\nRET\n") ==
          "subroutine 0 is there already");
    CHECK(complaint("CALL K0\nMEND\nNETWORK2\nSBR K0\nCALL K1\nRET\nNETWORK3\nSBR K1\nCALL K0\n"
                    "RET\n") == "subroutine 0 would call itself");
    CHECK(complaint("MEND\nLD SM0.0\n") ==
          "nothing can reach this instruction: the main program has ended");
    CHECK(complaint("RET\nMEND\n") == "RET does not belong into the main program");
    std::string deep = "LD SM0.0\nCALL K0\nMEND\n";
    for (int s = 0; s < 9; ++s) {
        deep += "NETWORK" + std::to_string(s + 2) + "\nSBR K" + std::to_string(s) + "\n";
        if (s < 8) deep += "CALL K" + std::to_string(s + 1) + "\n";
        deep += "RET\n";
    }
    CHECK(complaint(deep) == "subroutines are called 9 deep: 8 is the limit");
}

TEST_CASE("the stack within a network") {
    CHECK(complaint("LD E0.0\nOLD\nMEND\n") ==
          "OLD works on 2 levels of the stack, and the network has loaded 1");
    CHECK(complaint("LD E0.0\nLPP\nMEND\n") ==
          "LPP works on 2 levels of the stack, and the network has loaded 1");
    CHECK(complaint("LD E0.0\nCTU Z0 K1\nMEND\n") ==
          "CTU works on 2 levels of the stack, and the network has loaded 1");
    std::string loads;
    for (int i = 0; i < 10; ++i) loads += "LD E0.0\n";
    std::string collects;
    for (int i = 0; i < 9; ++i) collects += "OLD\n";
    CHECK(complaint(loads + collects + "= A0.0\nMEND\n") ==
          "OLD comes too late: the stack has 9 levels, and what it needs has been pushed out by "
          "later loads");
    // Loads that are never collected may fall out.
    CHECK(messages_of("NETWORK1\n" + loads + "= A0.0\nMEND\n") == "");
}

TEST_CASE("a program that is too long for the CPU 212") {
    const std::string text = example_text("s7-200/manipulator-modes.awl");
    CHECK(messages_of(text, Cpu::cpu_214) == "");
    CHECK(messages_of(text, Cpu::cpu_212).find("bytes, and the CPU 212 holds 1024") !=
          std::string::npos);
}

TEST_CASE("a listing without instructions") {
    CHECK(messages_of("// nothing\nNETWORK1\n") ==
          "test.awl: error: the listing holds no instruction\n");
}

}  // namespace grafwire::testing
