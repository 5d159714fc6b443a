// What can be asked of a netlist as a whole: who drives a net, whether it is whole, how a cell is
// called in messages, how it looks as text.
//
// fault_of() states what every maker and reader of netlists must see to. Simulation, check and
// formats rely on it and ask nothing again; debug builds assert it of every netlist made from
// equations.

#include "netlist/netlist.h"

#include <fmt/format.h>

#include <unordered_set>

namespace grafwire {

NetId NetNames::add(std::string_view name) {
    text_ += name;
    ends_.push_back(text_.size());
    return static_cast<NetId>(ends_.size() - 1);
}

void NetNames::reserve(std::size_t names, std::size_t bytes) {
    ends_.reserve(names);
    text_.reserve(bytes);
}

std::string_view NetNames::operator[](NetId net) const {
    const std::size_t index = index_of(net);
    const auto begin = static_cast<std::size_t>(index == 0 ? 0 : ends_[index - 1]);
    const auto end = static_cast<std::size_t>(ends_[index]);
    return std::string_view(text_).substr(begin, end - begin);
}

Table<NetId, CellId> drivers_of(const Netlist& netlist) {
    Table<NetId, CellId> drivers(netlist.net_count(), no_cell);
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const CellId cell = netlist.cells.id_at(i);
        drivers[netlist.cells[cell].output] = cell;
    }
    return drivers;
}

namespace {

/// Pins in number and range, origin and timing of one cell.
std::string fault_of_cell(const Netlist& netlist, const Cell& cell) {
    const CellTypeRow& row = row_of(cell.type);
    const std::string name(index_of(cell.output) < netlist.net_count() ? netlist.names[cell.output]
                                                                       : "?");
    if (index_of(cell.output) >= netlist.net_count()) return "a cell drives no net";
    if (cell.pin_count < row.min_pins || cell.pin_count > row.max_pins) {
        return fmt::format("cell {} of type {} has {} pins", name, row.name, cell.pin_count);
    }
    if (std::size_t{cell.first_pin} + cell.pin_count > netlist.pins.size()) {
        return fmt::format("the pins of cell {} are out of range", name);
    }
    for (const NetId pin : netlist.pins_of(cell)) {
        if (index_of(pin) >= netlist.net_count()) {
            return fmt::format("a pin of cell {} is connected to no net", name);
        }
    }
    if (cell.origin >= netlist.origins.size()) return fmt::format("cell {} has no origin", name);
    if (row.has_timing && cell.timing >= netlist.timings.size()) {
        return fmt::format("cell {} has no timing", name);
    }
    return {};
}

/// Every net has one driver: a cell or an input port.
std::string fault_of_drivers(const Netlist& netlist) {
    std::vector<std::uint8_t> drivers(netlist.net_count());
    const auto drive = [&](NetId net) { return ++drivers[index_of(net)] == 1; };
    for (const Port& port : netlist.inputs) {
        if (index_of(port.net) >= netlist.net_count()) return "an input port has no net";
        if (!drive(port.net)) return fmt::format("net {} has two drivers", netlist.names[port.net]);
    }
    for (const Cell& cell : netlist.cells) {
        if (!drive(cell.output)) {
            return fmt::format("net {} has two drivers", netlist.names[cell.output]);
        }
    }
    for (std::size_t i = 0; i < drivers.size(); ++i) {
        if (drivers[i] == 0) {
            return fmt::format("net {} has no driver", netlist.names[static_cast<NetId>(i)]);
        }
    }
    return {};
}

std::string fault_of_names(const Netlist& netlist) {
    std::unordered_set<std::string_view> seen;
    seen.reserve(netlist.net_count());
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const std::string_view name = netlist.names[static_cast<NetId>(i)];
        if (!seen.insert(name).second) return fmt::format("two nets are called {}", name);
    }
    return {};
}

}  // namespace

std::string fault_of(const Netlist& netlist) {
    for (const Cell& cell : netlist.cells) {
        if (std::string fault = fault_of_cell(netlist, cell); !fault.empty()) return fault;
    }
    if (std::string fault = fault_of_drivers(netlist); !fault.empty()) return fault;
    std::size_t next_cell = 0;
    for (const Module& module : netlist.modules) {
        if (module.first_cell != next_cell) return "the modules leave a gap before " + module.name;
        next_cell += module.cell_count;
    }
    if (next_cell != netlist.cells.size()) return "the modules leave cells out";
    for (const Port& port : netlist.outputs) {
        if (index_of(port.net) >= netlist.net_count()) return "an output port has no net";
    }
    return fault_of_names(netlist);
}

namespace {

/// The message that names a cell with what it was made for.
const Message<std::string, std::string>& cell_made_for(Origin::Kind kind) {
    switch (kind) {
        case Origin::Kind::input:
            return messages::netlist::cell_of_input;
        case Origin::Kind::step:
            return messages::netlist::cell_of_step;
        case Origin::Kind::transition:
            return messages::netlist::cell_of_transition;
        case Origin::Kind::output:
            return messages::netlist::cell_of_output;
        case Origin::Kind::var:
            return messages::netlist::cell_of_var;
        case Origin::Kind::counter:
            return messages::netlist::cell_of_counter;
        case Origin::Kind::graph:
            return messages::netlist::cell_of_graph;
        case Origin::Kind::edge:
            return messages::netlist::cell_of_edge;
        default:
            return messages::netlist::cell_of_time_condition;
    }
}

}  // namespace

std::string cell_description(const Netlist& netlist, CellId id, Language language) {
    const Cell& cell = netlist.cells[id];
    const std::string named = messages::netlist::cell.in(
        language, row_of(cell.type).description.in(language), netlist.names[cell.output]);
    const Origin& origin = netlist.origin_of(cell);
    if (origin.kind == Origin::Kind::other) return named;
    return cell_made_for(origin.kind).in(language, named, origin.name);
}

// One cell a line, in the order of the modules:
//
//     module X1 # X1 = …
//       X1$set0 = nand(X0, a)
//       X1 = nand(X1$set0, X1$q)
std::string write_netlist_text(const Netlist& netlist) {
    std::string text = fmt::format("netlist {}\n", netlist.name);
    for (const Port& port : netlist.inputs) text += fmt::format("input {}\n", port.name);
    for (const Port& port : netlist.outputs) {
        text += fmt::format("output {} = {}\n", port.name, netlist.names[port.net]);
    }
    for (const Module& module : netlist.modules) {
        text += fmt::format("module {}{}{}\n", module.name, module.comment.empty() ? "" : " # ",
                            module.comment);
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            const Cell& cell = netlist.cells[netlist.cells.id_at(module.first_cell + i)];
            text += fmt::format("  {} = {}(", netlist.names[cell.output], row_of(cell.type).name);
            bool first = true;
            for (const NetId pin : netlist.pins_of(cell)) {
                text += fmt::format("{}{}", first ? "" : ", ", netlist.names[pin]);
                first = false;
            }
            text += ')';
            if (row_of(cell.type).has_timing) {
                const Timing& timing = netlist.timings[cell.timing];
                text += fmt::format(" rise {} fall {}", format_duration(timing.rise),
                                    format_duration(timing.fall));
            }
            if (row_of(cell.type).has_memory && cell.initial != Logic::unknown) {
                text += fmt::format(" initially {}", cell.initial == Logic::one ? 1 : 0);
            }
            text += '\n';
        }
    }
    for (const Netlist::InitialValue& start : netlist.initial_values) {
        text += fmt::format("initially {} = {}\n", netlist.names[start.net], start.value ? 1 : 0);
    }
    return text;
}

}  // namespace grafwire
