// Wires that take time, as cells.
//
// Gates of any delay whose wires take any time as well (forks are not isochronic) are gates of any
// delay in a netlist where each wire is a buffer. What that netlist can do in the general
// multiple-winner model is what the given one can do under any delays of its gates and wires, and
// ternary simulation tells exactly which of its nets come to a known end (J. A. Brzozowski, C.-J.
// H. Seger, "Asynchronous Circuits", 1995, chapter 7).
//
// Not every wire needs a buffer. A gate that is the only reader of another's output sees what the
// wire adds as a part of that gate's delay: delays are inertial, so a reader that is excited too
// early has lost nothing but may wait, and one that is quiet again has done nothing. That fails in
// four places, where the buffer stays:
//
// - the net has several readers, which may see it change at different times;
// - it does not change by a gate that takes its time: an input, of which several may change at
//   once, and a timer, whose delay ends together with others;
// - a gate reads its own output, which holds it before its inputs change back, or too late;
// - the reader takes note of a change at once: timers and pulse cells.
//
// A constant never changes, so its wires do not matter.

#include "netlist/passes/wire_delays.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "netlist/netlist_builder.h"

namespace grafwire {

namespace {

constexpr std::string_view arrow = "->";

bool is_constant(CellType type) {
    return type == CellType::low || type == CellType::high;
}

/// The nets that a cell reads, each once.
std::vector<NetId> nets_read_by(const Netlist& netlist, const Cell& cell) {
    std::vector<NetId> nets;
    for (const NetId net : netlist.pins_of(cell)) {
        if (std::find(nets.begin(), nets.end(), net) == nets.end()) nets.push_back(net);
    }
    return nets;
}

/// Finds wires by their names.
class WireNames {
  public:
    explicit WireNames(const Netlist& netlist) : netlist_(netlist), drivers_(drivers_of(netlist)) {
        for (std::size_t i = 0; i < netlist.net_count(); ++i) {
            const auto net = static_cast<NetId>(i);
            nets_.emplace(netlist.names[net], net);
        }
    }

    /// The names of nets may hold an arrow themselves.
    std::optional<Wire> find(std::string_view name) const {
        for (auto at = name.find(arrow); at != name.npos; at = name.find(arrow, at + 1)) {
            const auto net = nets_.find(name.substr(0, at));
            const auto output = nets_.find(name.substr(at + arrow.size()));
            if (net == nets_.end() || output == nets_.end()) continue;
            const CellId reader = drivers_[output->second];
            if (reader != no_cell && reads(netlist_.cells[reader], net->second)) {
                return Wire{net->second, reader};
            }
        }
        return std::nullopt;
    }

  private:
    bool reads(const Cell& cell, NetId net) const {
        const std::span<const NetId> pins = netlist_.pins_of(cell);
        return std::find(pins.begin(), pins.end(), net) != pins.end();
    }

    const Netlist& netlist_;
    const Table<NetId, CellId> drivers_;
    std::unordered_map<std::string_view, NetId> nets_;
};

/// Not one of a module that there is.
std::string module_name(const Netlist& netlist) {
    std::string name = "wires";
    const auto is_taken = [&](const Module& module) { return module.name == name; };
    while (std::any_of(netlist.modules.begin(), netlist.modules.end(), is_taken)) name += '$';
    return name;
}

}  // namespace

std::vector<Wire> telling_wires(const Netlist& netlist) {
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    std::vector<std::uint32_t> reader_count(netlist.net_count());
    for (const Cell& cell : netlist.cells) {
        for (const NetId net : nets_read_by(netlist, cell)) ++reader_count[index_of(net)];
    }
    std::vector<Wire> wires;
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const Cell& cell = netlist.cells.items()[i];
        for (const NetId net : nets_read_by(netlist, cell)) {
            const CellId driver = drivers[net];
            const CellType from = driver == no_cell ? CellType::buffer : netlist.cells[driver].type;
            if (is_constant(from)) continue;
            const bool is_sudden = driver == no_cell || is_timer(from);
            const bool is_watched = is_timer(cell.type) || is_pulse(cell.type);
            const bool is_held = cell.output == net;
            if (reader_count[index_of(net)] > 1 || is_sudden || is_watched || is_held) {
                wires.push_back({net, netlist.cells.id_at(i)});
            }
        }
    }
    return wires;
}

std::string wire_name(const Netlist& netlist, const Wire& wire) {
    std::string name(netlist.names[wire.net]);
    name += arrow;
    return name += netlist.names[netlist.cells[wire.reader].output];
}

std::vector<Wire> wires_named(const Netlist& netlist, std::span<const std::string_view> names) {
    const WireNames known(netlist);
    std::vector<Wire> wires;
    for (const std::string_view name : names) {
        const std::optional<Wire> wire = known.find(name);
        if (wire && std::find(wires.begin(), wires.end(), *wire) == wires.end()) {
            wires.push_back(*wire);
        }
    }
    return wires;
}

bool is_wire(const Netlist& netlist, const Cell& cell) {
    if (cell.type != CellType::buffer) return false;
    const std::string_view name = netlist.names[cell.output];
    const std::string_view from = netlist.names[netlist.pins_of(cell)[0]];
    return name.starts_with(from) && name.substr(from.size()).starts_with(arrow);
}

Netlist with_wire_delays(const Netlist& netlist, const std::vector<Wire>& wires) {
    NetlistBuilder builder = NetlistBuilder::without_cells_of(netlist);
    std::vector<NetId> pins = netlist.pins;
    std::vector<NetId> ends;
    for (const Wire& wire : wires) {
        std::string name = wire_name(netlist, wire);
        while (builder.find_net(name) != no_net) name += '$';
        ends.push_back(builder.add_net(name));
        const Cell& reader = netlist.cells[wire.reader];
        const auto first = pins.begin() + reader.first_pin;
        std::replace(first, first + reader.pin_count, wire.net, ends.back());
    }
    for (const Module& module : netlist.modules) {
        const ModuleId id = builder.add_module(module.name, module.comment);
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            const Cell& cell = netlist.cells.items()[module.first_cell + i];
            CellDetails details{cell.initial, {}};
            if (row_of(cell.type).has_timing) details.timing = netlist.timings[cell.timing];
            builder.add_cell({id, cell.origin}, cell.type, cell.output,
                             std::span(pins).subspan(cell.first_pin, cell.pin_count), details);
        }
    }
    if (wires.empty()) return builder.finish();
    const ModuleId id = builder.add_module(module_name(netlist));
    for (std::size_t i = 0; i < wires.size(); ++i) {
        const std::uint32_t origin = netlist.cells[wires[i].reader].origin;
        builder.add_cell({id, origin}, CellType::buffer, ends[i], {&wires[i].net, 1});
    }
    return builder.finish();
}

}  // namespace grafwire
