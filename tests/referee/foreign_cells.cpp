#include "referee/foreign_cells.h"

#include <doctest/doctest.h>

#include <string>

namespace grafwire::testing {

NetId ForeignCells::add(CellType type, const std::vector<NetId>& pins, Time width) {
    Cell cell;
    cell.type = type;
    cell.origin = 0;
    if (row_of(type).has_memory) cell.initial = Logic::zero;
    cell.output = netlist_.names.add("foreign$" + std::to_string(netlist_.net_count()));
    if (row_of(type).has_timing) {
        cell.timing = static_cast<std::uint32_t>(netlist_.timings.size());
        netlist_.timings.push_back({0, width});
    }
    set_pins(cell, pins);
    netlist_.cells.add(cell);
    ++netlist_.modules.back().cell_count;
    return cell.output;
}

NetId ForeignCells::delayed(NetId net, std::size_t buffers) {
    for (; buffers != 0; --buffers) net = add(CellType::buffer, {net});
    return net;
}

void ForeignCells::lead_to(NetId pin, NetId driven) {
    Cell& cell = netlist_.cells[drivers_of(netlist_)[driven]];
    const auto old = netlist_.pins_of(cell);
    std::vector<NetId> pins(old.begin(), old.end());
    pins.push_back(pin);
    set_pins(cell, pins);
}

NetId ForeignCells::net(std::string_view name) const {
    for (std::size_t i = 0; i < netlist_.net_count(); ++i) {
        const NetId id{static_cast<std::uint32_t>(i)};
        if (netlist_.names[id] == name) return id;
    }
    FAIL("no net " << name);
    return no_net;
}

void ForeignCells::set_pins(Cell& cell, const std::vector<NetId>& pins) {
    cell.first_pin = static_cast<std::uint32_t>(netlist_.pins.size());
    cell.pin_count = static_cast<std::uint32_t>(pins.size());
    netlist_.pins.insert(netlist_.pins.end(), pins.begin(), pins.end());
}

}  // namespace grafwire::testing
