#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "netlist/passes/wire_delays.h"
#include "support/small_netlist.h"

namespace grafwire::testing {

namespace {

/// Inputs a and b; x is read twice by y, once by z; y by z alone; z reads itself.
SmallNetlist some_netlist() {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    small.cell(CellType::nand_gate, "x", {"a", "b"});
    small.cell(CellType::and_gate, "y", {"x", "b", "x"});
    small.cell(CellType::or_gate, "z", {"x", "y", "z"});
    small.timed(CellType::rise_pulse, "p", {"q"}, {0, 3 * nanosecond, 0});
    small.cell(CellType::inverter, "q", {"z"});
    small.output("p");
    small.netlist.modules.push_back({"all", "", 0, 5});
    return small;
}

std::vector<std::string> names_of(const Netlist& netlist, const std::vector<Wire>& wires) {
    std::vector<std::string> names;
    for (const Wire& wire : wires) names.push_back(wire_name(netlist, wire));
    return names;
}

}  // namespace

TEST_CASE("wires: those that tell are of forks, inputs, and what sees a change at once") {
    const SmallNetlist small = some_netlist();
    const std::vector<std::string> expected = {"a->x", "b->x", "x->y", "b->y",
                                               "x->z", "z->z", "q->p", "z->q"};
    CHECK(names_of(small.netlist, telling_wires(small.netlist)) == expected);
}

TEST_CASE("wires: they are found by their names, each once") {
    const SmallNetlist small = some_netlist();
    const std::vector<std::string_view> names = {"y->z", "a->y", "x->y", "y->z", "x", "->", "x->"};
    const std::vector<std::string> expected = {"y->z", "x->y"};
    CHECK(names_of(small.netlist, wires_named(small.netlist, names)) == expected);
}

TEST_CASE("wires: each becomes a buffer before all pins of its reader") {
    const SmallNetlist small = some_netlist();
    const std::vector<std::string_view> names = {"x->y", "z->z"};
    const Netlist wired = with_wire_delays(small.netlist, wires_named(small.netlist, names));
    CHECK(fault_of(wired).empty());
    REQUIRE(wired.cells.size() == small.netlist.cells.size() + 2);
    const Cell& y = wired.cells.items()[1];
    const Cell& wire = wired.cells.items()[5];
    CHECK(wired.names[wire.output] == "x->y");
    CHECK(wire.type == CellType::buffer);
    CHECK(is_wire(wired, wire));
    CHECK(!is_wire(wired, y));
    CHECK(wired.pins_of(y)[0] == wire.output);
    CHECK(wired.names[wired.pins_of(y)[1]] == "b");
    CHECK(wired.pins_of(y)[2] == wire.output);
    CHECK(wired.modules.back().name == "wires");
    // Nothing else is another.
    CHECK(with_wire_delays(small.netlist, {}).cells.size() == small.netlist.cells.size());
}

}  // namespace grafwire::testing
