#include "check/wrong_wiring.h"

namespace grafwire::testing {

NetId net_named(Netlist& netlist, const std::string& name) {
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const auto net = static_cast<NetId>(i);
        if (netlist.names[net] == name) return net;
    }
    return netlist.names.add(name);
}

void add_cell(Netlist& netlist, CellType type, const std::string& output,
              const std::vector<std::string>& pins, Logic initial) {
    Cell cell;
    cell.type = type;
    cell.initial = initial;
    cell.output = net_named(netlist, output);
    cell.origin = 0;
    std::vector<NetId> nets;
    for (const std::string& pin : pins) nets.push_back(net_named(netlist, pin));
    cell.first_pin = static_cast<std::uint32_t>(netlist.pins.size());
    cell.pin_count = static_cast<std::uint32_t>(nets.size());
    netlist.pins.insert(netlist.pins.end(), nets.begin(), nets.end());
    netlist.cells.add(cell);
    ++netlist.modules.back().cell_count;
}

void add_ring(Netlist& netlist, const std::string& while_one) {
    add_cell(netlist, CellType::nand_gate, "ring1", {while_one, "ring3"});
    add_cell(netlist, CellType::inverter, "ring2", {"ring1"});
    add_cell(netlist, CellType::inverter, "ring3", {"ring2"});
}

void put_gate_before(Netlist& netlist, const std::string& net, CellType type,
                     const std::vector<std::string>& more) {
    const NetId driven = net_named(netlist, net);
    for (Cell& cell : netlist.cells) {
        if (cell.output == driven) cell.output = net_named(netlist, net + "$right");
    }
    std::vector<std::string> pins{net + "$right"};
    pins.insert(pins.end(), more.begin(), more.end());
    add_cell(netlist, type, net, pins);
}

}  // namespace grafwire::testing
