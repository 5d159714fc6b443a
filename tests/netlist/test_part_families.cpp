#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>

#include "netlist/part_families.h"
#include "text/time.h"

namespace grafwire::testing {

namespace {

/// `rise 1..23 fall 1..23`, in nanoseconds; `none` where the family lacks the cell.
std::string bands(std::string_view family, CellType type, std::size_t inputs) {
    const PartFamily* found = part_family_named(family);
    REQUIRE(found != nullptr);
    const std::optional<EdgeBands> bands = bands_of(*found, type, inputs);
    if (!bands) return "none";
    const auto shown = [](DelayBand band) {
        return format_nanoseconds(band.min) + ".." + format_nanoseconds(band.max);
    };
    return "rise " + shown(bands->rise) + " fall " + shown(bands->fall);
}

bool is_whole(DelayBand band) {
    return 0 < band.min && band.min <= band.max;
}

bool is_within(DelayBand inner, DelayBand outer) {
    return outer.min <= inner.min && inner.max <= outer.max;
}

/// Which no part is, nor can be made of parts whose figures are known.
bool is_lacking(CellType type) {
    return type == CellType::scan_timer || type == CellType::scan_timer_next;
}

}  // namespace

TEST_CASE("every cell has a band in every family, or is known to have none") {
    for (const PartFamily& family : part_families()) {
        for (const CellTypeRow& row : cell_table) {
            CAPTURE(family.name);
            CAPTURE(row.name);
            const std::size_t most = row.max_pins == any_number ? 200 : row.max_pins;
            for (std::size_t inputs = row.min_pins; inputs <= most; ++inputs) {
                CAPTURE(inputs);
                const std::optional<EdgeBands> bands = bands_of(family, row.type, inputs);
                REQUIRE(bands.has_value() != is_lacking(row.type));
                if (!bands) continue;
                REQUIRE(is_whole(bands->rise));
                REQUIRE(is_whole(bands->fall));
            }
        }
    }
}

TEST_CASE("the figures of parts agree with each other") {
    for (const PartFamily& family : part_families()) {
        const PartFigures* before = nullptr;
        for (const PartFigures& part : family.parts) {
            CAPTURE(part.part);
            CHECK_FALSE(part.source.empty());
            for (const auto edge : {&EdgeBands::rise, &EdgeBands::fall}) {
                const DelayBand bounds = part.bounds.*edge;
                const DelayBand typical = part.typical.*edge;
                CHECK(is_whole(typical));
                // No longer than a quarter of the least typical figure, in whole nanoseconds.
                CHECK(bounds.min <= typical.min / 4);
                CHECK(is_within({typical.min * 2 / 5, typical.max * 8 / 5}, bounds));
            }
            const bool is_wider = before != nullptr && before->type == part.type;
            if (is_wider) CHECK(before->inputs < part.inputs);
            before = &part;
        }
    }
}

TEST_CASE("families are found by their names") {
    CHECK(part_family_named("74HC") == &part_families()[0]);
    CHECK(part_family_named("4000-typical") == &part_families().back());
    CHECK(part_family_named("74AC") == nullptr);
    for (const PartFamily& family : part_families()) {
        CHECK(part_family_named(family.name) == &family);
        CHECK(family.is_typical == family.name.ends_with("-typical"));
    }
}

TEST_CASE("a gate is the narrowest part with enough inputs") {
    CHECK(bands("74HC", CellType::nand_gate, 2) == "rise 1..23 fall 1..23");
    CHECK(bands("74HC", CellType::nand_gate, 1) == "rise 1..23 fall 1..23");
    CHECK(bands("74HC", CellType::nand_gate, 5) == "rise 2..38 fall 2..38");
    CHECK(bands("74HC", CellType::nand_gate, 9) == "rise 2..38 fall 2..38");
    CHECK(bands("74LS", CellType::nand_gate, 8) == "rise 2..23 fall 3..30");
    CHECK(bands("4000", CellType::nor_gate, 6) == "rise 50..350 fall 50..350");
    CHECK(bands("74HC-typical", CellType::nand_gate, 2) == "rise 2.8..14.4 fall 2.8..14.4");
    CHECK(bands("4000-typical", CellType::inverter, 1) == "rise 20..80 fall 20..80");
}

TEST_CASE("wider gates are trees") {
    // An AND of 4 after a wire at the least, an AND of 2 at the most.
    CHECK(bands("74HC", CellType::and_gate, 5) == "rise 2..53 fall 2..53");
    // After ANDs of 2 and 3.
    CHECK(bands("74HC", CellType::and_gate, 10) == "rise 3..56 fall 3..56");
    // Two levels of OR of 2.
    CHECK(bands("74LS", CellType::or_gate, 4) == "rise 6..66 fall 6..66");
    CHECK(bands("74LS", CellType::or_gate, 5) == "rise 6..99 fall 6..99");
    // The rise of a NAND follows the fall of the ANDs before it.
    CHECK(bands("74LS", CellType::nand_gate, 16) == "rise 4..53 fall 5..53");
    CHECK(bands("74LS", CellType::nor_gate, 4) == "rise 2..56 fall 2..56");
    CHECK(bands("4000", CellType::xor_gate, 3) == "rise 27..370 fall 27..370");
}

TEST_CASE("cells that are no single part") {
    CHECK(bands("74HC", CellType::buffer, 1) == "rise 4..48 fall 4..48");
    CHECK(bands("74HC", CellType::latch, 2) == "rise 3..47 fall 4..70");
    CHECK(bands("74HC", CellType::hold_latch, 2) == "rise 2..46 fall 3..93");
    CHECK(bands("74HC", CellType::rise_pulse, 1) == "rise 1..25 fall 1..25");
    CHECK(bands("74HC", CellType::fall_pulse, 1) == "rise 1..23 fall 1..23");
    CHECK(bands("74HC", CellType::timer, 1) == "rise 4..48 fall 4..48");
    CHECK(bands("74HC", CellType::flip_flop, 2) == "rise 3..44 fall 3..44");
    CHECK(bands("74HC", CellType::scan_timer, 2) == "none");
}

}  // namespace grafwire::testing
