#include "formats/sample_netlists.h"

#include <doctest/doctest.h>

namespace grafwire::testing {

NetlistMaker::NetlistMaker(std::string name) {
    netlist_.name = std::move(name);
    netlist_.origins.push_back({});
    netlist_.has_modes = false;
}

NetId NetlistMaker::net(std::string_view name) {
    const auto [found, is_new] = nets_.try_emplace(std::string(name), no_net);
    if (is_new) found->second = netlist_.names.add(name);
    return found->second;
}

NetlistMaker& NetlistMaker::input(std::string_view name) {
    netlist_.inputs.push_back({std::string(name), net(name)});
    if (name == "Init") netlist_.has_modes = true;
    if (name == "clk") netlist_.clock = net(name);
    return *this;
}

NetlistMaker& NetlistMaker::output(std::string_view name) {
    if (name.starts_with('X')) ++netlist_.step_count;
    netlist_.outputs.push_back({std::string(name), net(name)});
    return *this;
}

NetlistMaker& NetlistMaker::module(std::string name, std::string comment) {
    const auto first = static_cast<std::uint32_t>(netlist_.cells.size());
    if (name.starts_with('X')) {
        netlist_.origins.push_back({Origin::Kind::step, name.substr(1), {}});
    }
    netlist_.modules.push_back({std::move(name), std::move(comment), first, 0});
    return *this;
}

NetlistMaker& NetlistMaker::cell(CellType type, std::string_view output,
                                 const std::vector<std::string>& pins, Logic initial,
                                 Timing timing) {
    if (netlist_.modules.empty()) module("all");
    Cell cell;
    cell.type = type;
    cell.initial = initial;
    cell.first_pin = static_cast<std::uint32_t>(netlist_.pins.size());
    cell.pin_count = static_cast<std::uint32_t>(pins.size());
    for (const std::string& pin : pins) netlist_.pins.push_back(net(pin));
    cell.output = net(output);
    const bool is_of_a_step = netlist_.modules.back().name.starts_with('X');
    cell.origin = is_of_a_step ? static_cast<std::uint32_t>(netlist_.origins.size() - 1) : 0;
    if (row_of(type).has_timing) {
        cell.timing = static_cast<std::uint32_t>(netlist_.timings.size());
        netlist_.timings.push_back(timing);
    }
    netlist_.cells.add(cell);
    ++netlist_.modules.back().cell_count;
    return *this;
}

NetlistMaker& NetlistMaker::starts_at(std::string_view name, bool value) {
    netlist_.initial_values.push_back({net(name), value});
    return *this;
}

Netlist NetlistMaker::make() {
    REQUIRE(fault_of(netlist_) == "");
    return std::move(netlist_);
}

namespace {

using enum CellType;

void add_latch_step(NetlistMaker& maker, const std::string& step, const std::string& before,
                    const std::string& receptivity, const std::string& after, bool initial) {
    const std::string x = "X" + step;
    maker.module(x, x + " = (X" + before + "." + receptivity + " + /X" + after + "." + x + ")");
    if (initial) {
        maker.cell(nand_gate, x + "$set", {"X" + before, receptivity})
            .cell(nand_gate, x + "$reset", {"X" + after, "Init$not"})
            .cell(nand_gate, x, {x + "$set", x + "$q", "Init$not"});
    } else {
        maker.cell(nand_gate, x + "$set", {"X" + before, receptivity, "Init$not"})
            .cell(nor_gate, x + "$any", {"X" + after, "Init"})
            .cell(buffer, x + "$reset", {x + "$any"})
            .cell(nand_gate, x, {x + "$set", x + "$q"});
    }
    maker.cell(nand_gate, x + "$q", {x, x + "$reset"});
}

}  // namespace

Netlist nand_sequencer() {
    NetlistMaker maker("sequencer");
    maker.input("a").input("b").input("c").input("Init");
    maker.output("X0").output("X1").output("X2").output("lamp");
    maker.module("inputs").cell(inverter, "Init$not", {"Init"});
    add_latch_step(maker, "0", "2", "c", "1", true);
    add_latch_step(maker, "1", "0", "a", "2", false);
    add_latch_step(maker, "2", "1", "b", "0", false);
    maker.module("lamp", "lamp = X1 + X2").cell(or_gate, "lamp", {"X1", "X2"});
    return maker.make();
}

Netlist all_asynchronous_cells() {
    NetlistMaker maker("all_cells");
    maker.input("a").input("b").input("c");
    for (const char* name : {"zero", "one", "same", "not_a", "and3", "or3", "nand3", "nor3", "xor3",
                             "kept", "held", "rose", "fell", "late"}) {
        maker.output(name);
    }
    maker.module("gates")
        .cell(low, "zero", {})
        .cell(high, "one", {})
        .cell(buffer, "same", {"a"})
        .cell(inverter, "not_a", {"a"})
        .cell(and_gate, "and3", {"a", "b", "c"})
        .cell(or_gate, "or3", {"a", "b", "c"})
        .cell(nand_gate, "nand3", {"a", "b", "c"})
        .cell(nor_gate, "nor3", {"a", "b", "c"})
        .cell(xor_gate, "xor3", {"a", "b", "c"})
        .cell(and_gate, "and2", {"a", "b"})
        .cell(xor_gate, "xor2", {"a", "b"});
    maker.module("memories")
        .cell(latch, "kept", {"rose", "fell"}, Logic::zero)
        .cell(hold_latch, "held", {"b", "c"}, Logic::one)
        .cell(rise_pulse, "rose", {"a"}, Logic::unknown, {0, 3 * nanosecond})
        .cell(fall_pulse, "fell", {"b"}, Logic::unknown, {0, 5 * nanosecond})
        .cell(timer, "late", {"c"}, Logic::zero, {20 * millisecond, 1500 * microsecond, 7});
    return maker.make();
}

Netlist clocked_sample() {
    NetlistMaker maker("clocked");
    maker.input("a").input("Init").input("clk");
    maker.output("X1").output("late").output("later");
    maker.module("X1", "X1 toggles while a")
        .cell(xor_gate, "X1$next", {"X1", "a"})
        .cell(flip_flop, "X1", {"X1$next", "clk"}, Logic::one);
    maker.module("late", "late = 30ms/a/10ms")
        .cell(scan_timer, "late", {"a", "clk"}, Logic::zero,
              {30 * millisecond, 10 * millisecond, 0});
    maker.module("later", "later = 20ms/late")
        .cell(scan_timer_next, "late$next", {"a", "late", "clk"}, Logic::unknown,
              {30 * millisecond, 10 * millisecond, 0})
        .cell(scan_timer, "later", {"late$next", "clk"}, Logic::zero, {20 * millisecond, 0, 1});
    return maker.make();
}

Netlist latch_without_modes() {
    NetlistMaker maker("bare");
    maker.input("set").input("reset");
    maker.output("X1");
    maker.cell(inverter, "set$not", {"set"})
        .cell(inverter, "reset$not", {"reset"})
        .cell(nand_gate, "X1", {"set$not", "X1$q"})
        .cell(nand_gate, "X1$q", {"X1", "reset$not"});
    maker.starts_at("X1", true);
    return maker.make();
}

const std::vector<std::string>& odd_input_names() {
    static const std::vector<std::string> names{"H+",
                                                "a b",
                                                "a%20b",
                                                "a_b",
                                                "étape",
                                                "module",
                                                "x",
                                                "X",
                                                "logic",
                                                "1",
                                                "a#b",
                                                "a=b",
                                                "a\\b",
                                                "a\\",
                                                "a`b",
                                                "$a",
                                                "a$g",
                                                "a//b",
                                                "a(*b",
                                                "null",
                                                "gnd",
                                                "0",
                                                "a,b",
                                                "a/*b",
                                                "SCAN_PS",
                                                "GATE_NS",
                                                "a\xc2\xa0"
                                                "b",
                                                ".names"};
    return names;
}

Netlist odd_names() {
    NetlistMaker maker("odd names");
    for (const std::string& name : odd_input_names()) maker.input(name);
    for (const std::string& name : odd_input_names()) maker.output("!" + name);
    maker.module("odd \\", "a comment with a backslash at its end \\");
    for (const std::string& name : odd_input_names()) maker.cell(inverter, "!" + name, {name});
    return maker.make();
}

Netlist nand_ring(std::size_t steps) {
    NetlistMaker maker("ring");
    maker.input("a").input("b").input("Init");
    for (std::size_t i = 0; i < steps; ++i) maker.output("X" + std::to_string(i));
    maker.module("inputs").cell(inverter, "Init$not", {"Init"});
    for (std::size_t i = 0; i < steps; ++i) {
        add_latch_step(maker, std::to_string(i), std::to_string((i + steps - 1) % steps),
                       i % 2 == 1 ? "a" : "b", std::to_string((i + 1) % steps), i == 0);
    }
    return maker.make();
}

}  // namespace grafwire::testing
