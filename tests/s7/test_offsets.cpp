// The offsets printed in the skeleton and the three applications, worked out anew from the sizes of
// instruction_set.h. The two places where the print deviates are one misprint.

#include <doctest/doctest.h>

#include "s7/instruction_set.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

namespace {

std::size_t offsets_in(const Listing& listing) {
    std::size_t count = 0;
    for (const Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) {
            if (instruction.printed_offset != Instruction::no_offset) ++count;
        }
    }
    return count;
}

}  // namespace

TEST_CASE("the printed offsets follow from the sizes") {
    struct Printed {
        std::string name;
        std::size_t offsets;
        std::uint32_t size;
    };
    for (const auto& [name, offsets, size] :
         {Printed{"method", 100, 394}, Printed{"positioning-axis", 193, 764},
          Printed{"manipulator", 177, 693}}) {
        const Listing listing = read_listing(example_text("s7-200/" + name + ".printed.awl"));
        CHECK(offsets_in(listing) == offsets);
        CHECK(offset_deviations(listing).empty());
        CHECK(size_of(listing) == size);
    }
}

TEST_CASE("where the print deviates from the sizes") {
    const Listing listing = read_listing(example_text("s7-200/manipulator-modes.printed.awl"));
    CHECK(offsets_in(listing) == 279);
    const auto deviations = offset_deviations(listing);
    REQUIRE(deviations.size() == 2);
    // `= V10.0` at 66 takes three bytes, `= V20.0` behind it too, and LD E1.0 stands at 69.
    CHECK(deviations[0].network == 13);
    CHECK(deviations[0].printed == 67);
    CHECK(deviations[0].computed == 69);
    CHECK(deviations[1].network == 14);
    CHECK(deviations[1].printed == 69);
    CHECK(deviations[1].computed == 70);
}

TEST_CASE("the corrected listings have the offsets of their sizes") {
    for (const std::string name : {"positioning-axis", "manipulator", "manipulator-modes"}) {
        Listing listing = read_listing(example_text("s7-200/" + name + ".awl"));
        CHECK(offset_deviations(listing).empty());
        const std::size_t count = offsets_in(listing);
        set_offsets(listing);
        CHECK(offsets_in(listing) == count);
    }
}

}  // namespace grafwire::testing
