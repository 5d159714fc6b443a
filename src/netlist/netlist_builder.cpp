// The builder keeps cells in the order in which they come, and per cell its module. Only finish()
// brings the cells of a module together (a counting sort, stable, left out where they are in order
// already) and drops modules without cells, so that makers may go back to any module.
//
// Names are the greatest part of a large netlist: ten million nets of 24 characters. So a netlist
// made from a GRAFCET keeps no table of them (InnerNames::by_role); the makers see to it that a
// pair of owner and role comes once, and only declared names that hold a `$` have to be kept free.

#include "netlist/netlist_builder.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace grafwire {

NetlistBuilder::NetlistBuilder(std::string name, InnerNames inner_names)
    : inner_names_(inner_names) {
    netlist_.name = std::move(name);
    netlist_.origins.push_back({});
}

NetlistBuilder NetlistBuilder::without_cells_of(const Netlist& netlist) {
    NetlistBuilder builder(netlist.name, InnerNames::by_unused_role);
    builder.netlist_ = netlist;
    builder.netlist_.cells = {};
    builder.netlist_.pins.clear();
    builder.netlist_.timings.clear();
    builder.netlist_.modules.clear();
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const NetId net{static_cast<std::uint32_t>(i)};
        builder.nets_by_name_.emplace(netlist.names[net], net);
    }
    return builder;
}

// Room that stays empty is never touched and costs no memory; lists of millions that have room need
// not be moved as they grow.
void NetlistBuilder::reserve(std::size_t cells) {
    constexpr std::size_t pins_a_cell = 4;
    constexpr std::size_t name_length = 24;
    netlist_.cells.items().reserve(cells);
    cell_modules_.reserve(cells);
    netlist_.pins.reserve(pins_a_cell * cells);
    netlist_.names.reserve(cells, name_length * cells);
}

void NetlistBuilder::reserve_name(std::string_view name) {
    nets_by_name_.try_emplace(std::string(name), no_net);
}

ModuleId NetlistBuilder::add_module(std::string name, std::string comment) {
    netlist_.modules.push_back({std::move(name), std::move(comment), 0, 0});
    return static_cast<ModuleId>(netlist_.modules.size() - 1);
}

std::uint32_t NetlistBuilder::add_origin(Origin::Kind kind, std::string name, Location where) {
    netlist_.origins.push_back({kind, std::move(name), where});
    return static_cast<std::uint32_t>(netlist_.origins.size() - 1);
}

NetId NetlistBuilder::add_net(std::string_view name) {
    const NetId net = netlist_.names.add(name);
    if (keeps_names()) nets_by_name_.insert_or_assign(std::string(name), net);
    return net;
}

std::pair<NetId, bool> NetlistBuilder::net_named(std::string_view name) {
    assert(keeps_names());
    NetId& net = nets_by_name_.try_emplace(std::string(name), no_net).first->second;
    const bool is_new = net == no_net;
    if (is_new) net = netlist_.names.add(name);
    return {net, is_new};
}

NetId NetlistBuilder::find_net(std::string_view name) const {
    assert(keeps_names());
    const auto found = nets_by_name_.find(std::string(name));
    return found == nets_by_name_.end() ? no_net : found->second;
}

NetId NetlistBuilder::add_inner_net(NetId owner, std::string_view role) {
    if (inner_names_ != InnerNames::by_number) {
        return add_inner_net(owner == no_net ? std::string_view() : name_of(owner), role);
    }
    const NetId net = netlist_.names.add({});
    unnamed_.push_back({net, owner});
    return net;
}

NetId NetlistBuilder::add_inner_net(std::string_view owner, std::string_view role) {
    assert(inner_names_ != InnerNames::by_number);
    scratch_.assign(owner);
    scratch_ += '$';
    scratch_ += role;
    while (nets_by_name_.contains(scratch_)) scratch_ += '$';
    return add_net(scratch_);
}

CellId NetlistBuilder::add_cell(CellPlace place, CellType type, NetId output,
                                std::span<const NetId> pins, const CellDetails& details) {
    assert(pins.size() >= row_of(type).min_pins && pins.size() <= row_of(type).max_pins);
    Cell cell;
    cell.type = type;
    cell.initial = details.initial;
    cell.first_pin = static_cast<std::uint32_t>(netlist_.pins.size());
    cell.pin_count = static_cast<std::uint32_t>(pins.size());
    cell.output = output;
    cell.origin = place.origin;
    if (row_of(type).has_timing) {
        cell.timing = static_cast<std::uint32_t>(netlist_.timings.size());
        netlist_.timings.push_back(details.timing);
    }
    netlist_.pins.insert(netlist_.pins.end(), pins.begin(), pins.end());
    cell_modules_.push_back(static_cast<std::uint32_t>(place.module));
    return netlist_.cells.add(cell);
}

void NetlistBuilder::copy_cell(ModuleId module, const Netlist& source, const Cell& cell) {
    CellDetails details{cell.initial, {}};
    if (row_of(cell.type).has_timing) details.timing = source.timings[cell.timing];
    add_cell({module, cell.origin}, cell.type, cell.output, source.pins_of(cell), details);
}

void NetlistBuilder::drive(CellPlace place, NetId output, CellType type,
                           std::span<const NetId> pins) {
    if (pins.size() == 1) {
        const bool inverting =
            type == CellType::inverter || type == CellType::nand_gate || type == CellType::nor_gate;
        type = inverting ? CellType::inverter : CellType::buffer;
    }
    add_cell(place, type, output, pins);
}

NetId NetlistBuilder::gate(CellPlace place, CellType type, std::span<const NetId> pins,
                           std::string_view owner, std::string_view role) {
    const NetId output = add_inner_net(owner, role);
    drive(place, output, type, pins);
    return output;
}

NetlistBuilder::Companion& NetlistBuilder::companion(NetId net) {
    if (companions_.size() <= index_of(net)) companions_.resize(netlist_.net_count());
    return companions_[index_of(net)];
}

NetId NetlistBuilder::inverted(CellPlace place, NetId net) {
    for (const bool value : {false, true}) {
        if (is_constant(net, value)) return constant(place, !value);
    }
    if (companion(net).inverted == no_net) {
        const NetId output = add_inner_net(net, "not");
        add_cell(place, CellType::inverter, output, {&net, 1});
        companion(net).inverted = output;
        companion(output).inverted = net;
    }
    return companion(net).inverted;
}

NetId NetlistBuilder::delayed(CellPlace place, NetId net, std::uint32_t levels) {
    if (is_constant(net, false) || is_constant(net, true)) return net;
    for (; levels != 0; --levels) {
        if (companion(net).delayed == no_net) {
            const NetId output = add_inner_net(net, "buf");
            add_cell(place, CellType::buffer, output, {&net, 1});
            companion(net).delayed = output;
        }
        net = companion(net).delayed;
    }
    return net;
}

NetId NetlistBuilder::constant(CellPlace place, bool value) {
    NetId& net = constants_[value ? 1 : 0];
    if (net == no_net) {
        net = add_inner_net(no_net, value ? "high" : "low");
        add_cell(place, value ? CellType::high : CellType::low, net, {});
    }
    return net;
}

/// Owners stand before the nets that are named after them.
void NetlistBuilder::name_unnamed_nets() {
    if (unnamed_.empty()) return;
    const NetNames given = std::move(netlist_.names);
    netlist_.names = {};
    std::vector<std::uint32_t> numbers(given.size() + 1);
    auto next = unnamed_.begin();
    for (std::size_t i = 0; i < given.size(); ++i) {
        const NetId net{static_cast<std::uint32_t>(i)};
        if (next == unnamed_.end() || next->net != net) {
            netlist_.names.add(given[net]);
            continue;
        }
        const bool has_owner = next->owner != no_net;
        std::uint32_t& number = numbers[has_owner ? index_of(next->owner) : given.size()];
        const std::string owner(has_owner ? netlist_.names[next->owner] : "net");
        std::string name;
        do {
            name = owner + '$' + std::to_string(++number);
        } while (!nets_by_name_.try_emplace(name, net).second);
        netlist_.names.add(name);
        ++next;
    }
}

// A counting sort, stable: the modules know where their cells begin.
void NetlistBuilder::sort_cells() {
    std::vector<std::uint32_t> position(netlist_.modules.size());
    for (std::size_t i = 0; i < position.size(); ++i) position[i] = netlist_.modules[i].first_cell;
    std::vector<Cell> sorted(netlist_.cells.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        sorted[position[cell_modules_[i]]++] = netlist_.cells.items()[i];
    }
    netlist_.cells.items() = std::move(sorted);
}

Netlist NetlistBuilder::finish() {
    name_unnamed_nets();
    for (const std::uint32_t module : cell_modules_) ++netlist_.modules[module].cell_count;
    std::uint32_t next = 0;
    for (Module& module : netlist_.modules) {
        module.first_cell = next;
        next += module.cell_count;
    }
    if (!std::is_sorted(cell_modules_.begin(), cell_modules_.end())) sort_cells();
    std::erase_if(netlist_.modules, [](const Module& module) { return module.cell_count == 0; });
    return std::move(netlist_);
}

}  // namespace grafwire
