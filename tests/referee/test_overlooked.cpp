// Wrong netlists that a check of netlists overlooks easily, each for a reason of its own. The
// referee must find them in random runs, and the check must call them different.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "netlist/styles/styles.h"
#include "random/read_text.h"
#include "referee/foreign_cells.h"
#include "referee/random_walk.h"

namespace grafwire::testing {

namespace {

Netlist netlist_of(const std::string& chart, Style style) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    const Equations equations = equations_from(*grafcet, {cdx, true});
    Diagnostics diagnostics;
    const auto netlist = netlist_from(*grafcet, equations, style, diagnostics);
    REQUIRE(netlist);
    return *netlist;
}

bool differs_in_a_run(const Grafcet& grafcet, const Netlist& netlist) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        RandomSource random(seed);
        const Time period = netlist.is_clocked() ? random_period(grafcet, random) : 0;
        const Walk walk = random_walk(grafcet, netlist, Happens::many_things, period, random, 60);
        if (!walk.contradiction.empty()) return true;
    }
    return false;
}

void must_be_found(const std::string& chart, const Netlist& netlist) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    REQUIRE(fault_of(netlist) == "");
    CHECK(differs_in_a_run(*grafcet, netlist));
    CheckOptions options;
    options.changes = Changes::many;
    CHECK(check_equivalence(*grafcet, netlist, options).verdict == Verdict::different);
}

const char* const door = R"(
grafcet door
input call, free, shut, open
output motor
graph G {
  initial 10
  step 11 : motor
  step 12
  10 -> 11 : ↑call . free
  11 -> 12 : open
  12 -> 10 : shut . /call
}
)";

}  // namespace

// Step 11 lives for one scan, so only an input that changes in the midst of the evolution can lead
// to step 13. Until stable that cannot be; scan by scan it can.
TEST_CASE("overlooked: an input that changes within an evolution, clocked") {
    const auto chart = [](const std::string& branch) {
        return "input a, b\noutput horn\ngraph G {\n  initial 10\n  step 11\n  step 12\n"
               "  step 13 : horn\n  10 -> 11 : ↑a\n  11 -> 12 : /b\n" +
               branch + "  12 -> 10 : /a\n  13 -> 10 : /a\n}\n";
    };
    must_be_found(chart("  11 -> 13 : ↑b\n"), netlist_of(chart(""), Style::clocked));
}

// In step 10 nothing reads `shut`. A pulse comes of its rise all the same, by way of a hazard, and
// meets one of `call`.
TEST_CASE("overlooked: pulses of an input that nothing reads") {
    Netlist netlist = netlist_of(door, Style::nand);
    ForeignCells cells(netlist);
    const NetId shut = cells.net("shut");
    const NetId late = cells.add(CellType::inverter, {cells.delayed(shut, 5)});
    const NetId hazard = cells.add(CellType::and_gate, {shut, late});
    const NetId pulse = cells.add(CellType::rise_pulse, {hazard}, nanosecond);
    const NetId other = cells.add(CellType::rise_pulse, {cells.net("call")}, nanosecond);
    const NetId meeting =
        cells.add(CellType::nand_gate, {cells.net("X10"), pulse, cells.delayed(other, 1),
                                        cells.net("Init$not"), cells.net("AUdur$not")});
    cells.lead_to(meeting, cells.net("X11"));
    must_be_found(door, netlist);
}

// Never given a value at power-up, so that three values do not see it move.
TEST_CASE("overlooked: a ring that nothing reads") {
    Netlist netlist = netlist_of(door, Style::nand);
    ForeignCells cells(netlist);
    const NetId ring = cells.add(CellType::inverter, {cells.net("call")});
    netlist.pins[netlist.cells.items().back().first_pin] = ring;
    must_be_found(door, netlist);
}

TEST_CASE("overlooked: a ring that runs while an input is 1") {
    Netlist netlist = netlist_of(door, Style::nand);
    ForeignCells cells(netlist);
    const NetId ring = cells.add(CellType::xor_gate, {cells.net("open"), cells.net("call")});
    netlist.pins[netlist.cells.items().back().first_pin] = ring;
    must_be_found(door, netlist);
}

}  // namespace grafwire::testing
