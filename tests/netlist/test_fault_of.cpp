#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

Netlist whole() {
    static const Grafcet grafcet = grafcet_of(R"(
input a
graph G { initial 0 step 1
  0 -> 1 : 2s/X0 . a }
)");
    return netlist_of(grafcet, Style::clocked);
}

CellId first_of(const Netlist& netlist, CellType type) {
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const CellId id = netlist.cells.id_at(i);
        if (netlist.cells[id].type == type) return id;
    }
    FAIL("no such cell");
    return no_cell;
}

}  // namespace

TEST_CASE("a netlist as it is made has no fault") {
    CHECK(fault_of(whole()).empty());
}

TEST_CASE("faults of cells are found") {
    Netlist netlist = whole();
    SUBCASE("too many pins") {
        const CellId id = first_of(netlist, CellType::inverter);
        netlist.cells[id].pin_count = 2;
        CHECK(fault_of(netlist).find("of type not has 2 pins") != std::string::npos);
    }
    SUBCASE("pins out of range") {
        const CellId id = first_of(netlist, CellType::and_gate);
        netlist.cells[id].first_pin = static_cast<std::uint32_t>(netlist.pins.size());
        CHECK(fault_of(netlist).find("are out of range") != std::string::npos);
    }
    SUBCASE("a pin on no net") {
        const CellId id = first_of(netlist, CellType::and_gate);
        netlist.pins[netlist.cells[id].first_pin] = no_net;
        CHECK(fault_of(netlist).find("is connected to no net") != std::string::npos);
    }
    SUBCASE("no origin") {
        netlist.cells[first_of(netlist, CellType::and_gate)].origin = Cell().origin;
        CHECK(fault_of(netlist).find("has no origin") != std::string::npos);
    }
    SUBCASE("no timing") {
        netlist.cells[first_of(netlist, CellType::scan_timer)].timing = 10'000;
        CHECK(fault_of(netlist).find("has no timing") != std::string::npos);
    }
    SUBCASE("no output") {
        netlist.cells[first_of(netlist, CellType::and_gate)].output = no_net;
        CHECK(fault_of(netlist) == "a cell drives no net");
    }
}

TEST_CASE("faults of nets, ports and modules are found") {
    Netlist netlist = whole();
    SUBCASE("two drivers") {
        netlist.inputs.push_back({"again", netlist.inputs[0].net});
        CHECK(fault_of(netlist) == "net a has two drivers");
    }
    SUBCASE("no driver") {
        netlist.names.add("adrift");
        CHECK(fault_of(netlist) == "net adrift has no driver");
    }
    SUBCASE("two nets of one name") {
        Cell cell;
        cell.type = CellType::low;
        cell.output = netlist.names.add("X0");
        cell.origin = 0;
        netlist.cells.add(cell);
        ++netlist.modules.back().cell_count;
        CHECK(fault_of(netlist) == "two nets are called X0");
    }
    SUBCASE("an input without a net") {
        netlist.inputs[0].net = no_net;
        CHECK(fault_of(netlist) == "an input port has no net");
    }
    SUBCASE("an output without a net") {
        netlist.outputs[0].net = no_net;
        CHECK(fault_of(netlist) == "an output port has no net");
    }
    SUBCASE("a gap between modules") {
        ++netlist.modules.back().first_cell;
        CHECK(fault_of(netlist) == "the modules leave a gap before " + netlist.modules.back().name);
    }
    SUBCASE("a cell in no module") {
        --netlist.modules.back().cell_count;
        CHECK(fault_of(netlist) == "the modules leave cells out");
    }
}

}  // namespace grafwire::testing
