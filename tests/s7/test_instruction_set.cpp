// The table of instructions: every row can be named, in both spellings.

#include <doctest/doctest.h>

#include <set>

#include "s7/instruction_set.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

TEST_CASE("every mnemonic names one row, and the row has that mnemonic") {
    std::set<std::pair<Operation, Width>> seen;
    for (const InstructionRow& row : instruction_set()) {
        CHECK(seen.emplace(row.operation, row.width).second);
        CHECK(row_of(row.operation, row.width) == &row);
        for (const Mnemonics mnemonics : {Mnemonics::simatic, Mnemonics::international}) {
            Instruction instruction;
            instruction.operation = row.operation;
            instruction.width = row.width;
            instruction.compare = row.is_comparison() ? Compare::greater_equal : Compare::equal;
            const auto named = instruction_named(mnemonic_of(instruction, mnemonics));
            REQUIRE(named);
            CHECK(named->row == &row);
            CHECK(named->compare == instruction.compare);
        }
    }
    CHECK(seen.size() == instruction_set().size());
    CHECK_FALSE(instruction_named("LDX"));
}

TEST_CASE("both spellings of a few") {
    const auto same = [](const std::string& simatic, const std::string& international) {
        const Listing a = read_listing("NETWORK1\n" + simatic + "\nMEND\n");
        const Listing b = read_listing("NETWORK1\n" + international + "\nMEND\n");
        const Instruction& first = a.networks[0].instructions[0];
        const Instruction& second = b.networks[0].instructions[0];
        CHECK(first.operation == second.operation);
        CHECK(first.width == second.width);
        CHECK(first.compare == second.compare);
        CHECK(first.operands == second.operands);
    };
    same("U E0.4", "A I0.4");
    same("UN A0.0", "AN Q0.0");
    same("UB>= VB100 K1", "AB>= VB100, 1");
    same("UNDW KHF00 VW2", "ANDW 16#F00, VW2");
    same("FILL KHFFFF VW0 K1", "FILL 16#FFFF VW0 1");
    same("LD Z3", "LD C3");
    same("MOVB EB0 VB2", "MOVB IB0 VB2");
    same("MOVD K-5 VD2", "MOVD -5 VD2");
}

TEST_CASE("sizes depend on the operands") {
    const auto size = [](const std::string& text) {
        return size_of(read_listing("NETWORK1\n" + text + "\nMEND\n").networks[0].instructions[0]);
    };
    CHECK(size("LD E0.4") == 2);
    CHECK(size("LD V0.4") == 3);
    CHECK(size("LD SM0.0") == 2);
    CHECK(size("LD T37") == 2);
    CHECK(size("= A0.0") == 2);
    CHECK(size("= V80.0") == 3);
    CHECK(size("S A0.0 K1") == 7);
    CHECK(size("S V40.1 K1") == 7);
    CHECK(size("UB>= VB100 K1") == 5);
    CHECK(size("UB= VB100 VB104") == 6);
    CHECK(size("MOVW K0 VW104") == 6);
    CHECK(size("MOVD K0 VD104") == 8);
    CHECK(size("FILL K0 VW40 K40") == 10);
}

}  // namespace grafwire::testing
