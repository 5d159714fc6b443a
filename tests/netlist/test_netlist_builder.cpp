// The door into netlists: names of nets, complements and constants made once, cells of a module
// brought together.

#include <doctest/doctest.h>

#include "netlist/netlist_builder.h"

namespace grafwire::testing {

namespace {

std::vector<std::string> names_of(const Netlist& netlist) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        names.emplace_back(netlist.names[NetId{static_cast<std::uint32_t>(i)}]);
    }
    return names;
}

NetId add_input(NetlistBuilder& builder, const std::string& name) {
    const NetId net = builder.add_net(name);
    builder.add_input(name, net);
    return net;
}

}  // namespace

TEST_CASE("netlist builder: inner nets are named by owner and role, reserved names stay free") {
    NetlistBuilder builder("test", InnerNames::by_role);
    builder.reserve_name("a$not");
    const CellPlace place{builder.add_module("all"), 0};
    const NetId a = add_input(builder, "a");
    const NetId not_a = builder.inverted(place, a);
    CHECK(builder.inverted(place, a) == not_a);
    CHECK(builder.inverted(place, not_a) == a);
    const NetId twice = builder.delayed(place, a, 2);
    CHECK(builder.delayed(place, a, 2) == twice);
    const NetId pins[] = {not_a, twice};
    builder.gate(place, CellType::and_gate, pins, "X1", "set");
    const Netlist netlist = builder.finish();
    CHECK(fault_of(netlist) == "");
    CHECK(names_of(netlist) ==
          std::vector<std::string>{"a", "a$not$", "a$buf", "a$buf$buf", "X1$set"});
    CHECK(netlist.cells.size() == 4);
}

TEST_CASE("netlist builder: the complement of a constant is the other constant, undelayed") {
    NetlistBuilder builder("test", InnerNames::by_role);
    const CellPlace place{builder.add_module("all"), 0};
    const NetId low = builder.constant(place, false);
    const NetId high = builder.inverted(place, low);
    CHECK(builder.is_constant(high, true));
    CHECK(!builder.is_constant(high, false));
    CHECK(!builder.is_constant(no_net, true));
    CHECK(builder.delayed(place, high, 3) == high);
    CHECK(builder.inverted(place, high) == low);
    const Netlist netlist = builder.finish();
    CHECK(fault_of(netlist) == "");
    CHECK(names_of(netlist) == std::vector<std::string>{"$low", "$high"});
}

TEST_CASE("netlist builder: the cells of a module are brought together, empty modules fall away") {
    NetlistBuilder builder("test", InnerNames::by_role);
    const ModuleId first = builder.add_module("first", "a comment");
    builder.add_module("empty");
    const ModuleId last = builder.add_module("last");
    const NetId a = add_input(builder, "a");
    const std::uint32_t origin = builder.add_origin(Origin::Kind::step, "7", {});
    const NetId one = builder.gate({last, origin}, CellType::and_gate, {&a, 1}, "a", "1");
    const NetId two = builder.gate({first, 0}, CellType::nand_gate, {&one, 1}, "a", "2");
    builder.gate({last, 0}, CellType::buffer, {&two, 1}, "a", "3");
    const Netlist netlist = builder.finish();
    CHECK(fault_of(netlist) == "");
    REQUIRE(netlist.modules.size() == 2);
    CHECK(netlist.modules[0].name == "first");
    CHECK(netlist.modules[0].comment == "a comment");
    CHECK(netlist.modules[1].cell_count == 2);
    CHECK(netlist.cells[CellId{0}].type == CellType::inverter);
    CHECK(netlist.cells[CellId{1}].type == CellType::buffer);
    CHECK(netlist.origin_of(netlist.cells[CellId{1}]).name == "7");
    CHECK(netlist.cells[CellId{2}].pin_count == 1);
}

TEST_CASE("netlist builder: nets known by name, numbers for inner nets once all names are known") {
    NetlistBuilder builder("test", InnerNames::by_number);
    const CellPlace place{builder.add_module("all"), 0};
    CHECK(builder.find_net("a") == no_net);
    const auto [a, is_new] = builder.net_named("a");
    CHECK(is_new);
    CHECK(builder.net_named("a") == std::pair(a, false));
    CHECK(builder.find_net("a") == a);
    builder.add_input("a", a);
    const NetId not_a = builder.inverted(place, a);
    const NetId high = builder.constant(place, true);
    const NetId pins[] = {not_a, high};
    const NetId inner = builder.add_inner_net(a, "set");
    builder.add_cell(place, CellType::and_gate, inner, pins);
    CHECK(builder.name_of(inner) == "");
    const NetId late = builder.net_named("a$1").first;
    builder.drive(place, late, CellType::buffer, {&inner, 1});
    builder.set_initial(late, true);
    builder.add_output("out", late);
    const Netlist netlist = builder.finish();
    CHECK(fault_of(netlist) == "");
    CHECK(names_of(netlist) == std::vector<std::string>{"a", "a$2", "net$1", "a$3", "a$1"});
    CHECK(netlist.initial_values.size() == 1);
    CHECK(netlist.outputs[0].name == "out");
}

TEST_CASE("netlist builder: a pass goes on from a netlist and gives no name twice") {
    NetlistBuilder first("test", InnerNames::by_role);
    const ModuleId module = first.add_module("all");
    const NetId a = add_input(first, "a");
    const NetId taken = first.inverted({module, 0}, a);
    const NetId slow = first.add_net("slow");
    const Timing timing{5, 7, 2};
    first.add_cell({module, 0}, CellType::timer, slow, {&taken, 1}, {Logic::zero, timing});
    const Netlist source = first.finish();

    NetlistBuilder pass = NetlistBuilder::without_cells_of(source);
    const CellPlace place{pass.add_module("again"), 0};
    for (const Cell& cell : source.cells) pass.copy_cell(place.module, source, cell);
    CHECK(pass.find_net("a$not") == taken);
    pass.inverted(place, a);
    const Netlist netlist = pass.finish();
    CHECK(fault_of(netlist) == "");
    CHECK(names_of(netlist) == std::vector<std::string>{"a", "a$not", "slow", "a$not$"});
    const Cell& timer = netlist.cells[CellId{1}];
    CHECK(timer.initial == Logic::zero);
    CHECK(netlist.timings[timer.timing] == timing);
    CHECK(netlist.inputs.size() == 1);
}

}  // namespace grafwire::testing
