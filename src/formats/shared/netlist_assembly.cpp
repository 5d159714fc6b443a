// A file names nets before it drives them, and drives none or twice if it is wrong, which a
// NetlistBuilder leaves to its caller. Inner nets get their names when all those of the file are
// known, and the clock is found when all flip-flops are: both have to wait for the end of the file.

#include "formats/shared/netlist_assembly.h"

#include <cassert>
#include <utility>

#include "formats/shared/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace say = messages::formats;

NetlistAssembly::NetlistAssembly(Diagnostics& diagnostics)
    : diagnostics_(diagnostics),
      builder_({}, InnerNames::by_number),
      module_(builder_.add_module({})) {}

/// Where cells from that place belong. Cells come in the order of the file, so the last origin is
/// the only one that can be the same.
CellPlace NetlistAssembly::place(Location where) {
    const std::vector<Origin>& origins = builder_.netlist().origins;
    if (!where.is_known()) return {module_, 0};
    const Location last = origins.back().where;
    if (last.line == where.line && last.column == where.column) {
        return {module_, static_cast<std::uint32_t>(origins.size() - 1)};
    }
    return {module_, builder_.add_origin(Origin::Kind::other, {}, where)};
}

void NetlistAssembly::add_file_net(NetId net, Location where) {
    nets_.resize(index_of(net) + 1);
    nets_.back() = {true, where, {}, false, false};
}

NetId NetlistAssembly::net(std::string_view name, Location where) {
    const auto [net, is_new] = builder_.net_named(name);
    if (is_new) {
        check_name(name, where);
        add_file_net(net, where);
    }
    return net;
}

NetId NetlistAssembly::inner_net(NetId owner, Location where) {
    const NetId net = builder_.add_inner_net(owner, {});
    add_file_net(net, where);
    return net;
}

void NetlistAssembly::check_name(std::string_view name, Location where) {
    if (find_control(name) == std::string_view::npos) return;
    diagnostics_.error(code::unexpected_character, where, control_in_name_message(name));
}

void NetlistAssembly::check_port(std::string_view name, NetId net, Location where) {
    if (name != builder_.name_of(net)) check_name(name, where);
}

/// Notes that a net has a driver; a second one is an error.
void NetlistAssembly::drive(NetId id, Location where) {
    assert(index_of(id) < nets_.size() && nets_[index_of(id)].is_of_file);
    FileNet& net = nets_[index_of(id)];
    if (net.is_driven) {
        Diagnostic& error = diagnostics_.error(code::bad_netlist, where,
                                               say::second_driver(shortened(builder_.name_of(id))));
        if (net.driver.is_known()) error.notes.push_back({net.driver, say::first_driver()});
    }
    net.is_driven = true;
    net.driver = where;
}

void NetlistAssembly::add_input(std::string_view name, NetId net, Location where) {
    drive(net, where);
    check_port(name, net, where);
    nets_[index_of(net)].is_input = true;
    builder_.add_input(std::string(name), net);
}

void NetlistAssembly::add_output(std::string_view name, NetId net, Location where) {
    if (!output_names_.insert(std::string(name)).second) {
        diagnostics_.error(code::bad_netlist, where, say::output_twice(shortened(name)));
        return;
    }
    check_port(name, net, where);
    builder_.add_output(std::string(name), net);
}

bool NetlistAssembly::is_input(std::string_view name) const {
    const NetId net = builder_.find_net(name);
    return net != no_net && nets_[index_of(net)].is_input;
}

void NetlistAssembly::add_cell(CellType type, NetId output, std::span<const NetId> pins,
                               Location where, const CellDetails& details) {
    drive(output, where);
    if ((type == CellType::rise_pulse || type == CellType::fall_pulse) &&
        details.timing.fall == 0) {
        diagnostics_.error(
            code::bad_netlist, where,
            say::pulse_without_width(row_of(type).description(), builder_.name_of(output)));
    }
    builder_.add_cell(place(where), type, output, pins, details);
}

NetId NetlistAssembly::gate(CellType type, std::span<const NetId> pins, NetId owner,
                            Location where) {
    const NetId output = builder_.add_inner_net(owner, {});
    builder_.add_cell(place(where), type, output, pins);
    return output;
}

/// Nets that nothing drives, at their first mention.
void NetlistAssembly::check_drivers(const Netlist& netlist) {
    for (std::size_t i = 0; i < nets_.size(); ++i) {
        if (!nets_[i].is_of_file || nets_[i].is_driven) continue;
        diagnostics_.error(code::bad_netlist, nets_[i].where,
                           say::no_driver(netlist.names[static_cast<NetId>(i)]));
    }
}

/// The last pin of all flip-flops must be one and the same input.
void NetlistAssembly::find_clock(Netlist& netlist) {
    for (const Cell& cell : netlist.cells) {
        if (!row_of(cell.type).is_clocked) continue;
        const NetId clock = netlist.pins_of(cell).back();
        const Location where = netlist.origin_of(cell).where;
        const Localized description = row_of(cell.type).description();
        if (index_of(clock) >= nets_.size() || !nets_[index_of(clock)].is_input) {
            diagnostics_.error(code::bad_netlist, where,
                               say::clock_is_no_input(netlist.names[clock], description,
                                                      netlist.names[cell.output]));
            return;
        }
        if (netlist.clock != no_net && netlist.clock != clock) {
            diagnostics_.error(
                code::bad_netlist, where,
                say::second_clock(description, netlist.names[cell.output], netlist.names[clock],
                                  netlist.names[netlist.clock]));
            return;
        }
        netlist.clock = clock;
    }
}

std::optional<Netlist> NetlistAssembly::finish(std::string name) {
    Netlist netlist = builder_.finish();
    // Cells that were refused leave nets without drivers; that need not be said as well.
    if (!diagnostics_.has_errors()) check_drivers(netlist);
    find_clock(netlist);
    if (diagnostics_.has_errors()) return std::nullopt;
    for (Module& module : netlist.modules) module.name = name;
    netlist.name = std::move(name);
    netlist.has_modes = is_input("Init");
    // The ports of a netlist list the X variables first.
    while (netlist.step_count < netlist.outputs.size() &&
           netlist.outputs[netlist.step_count].name.starts_with('X')) {
        ++netlist.step_count;
    }
    return netlist;
}

}  // namespace grafwire
