#include "formats/shared/netlist_assembly.h"

#include <fmt/format.h>

#include <utility>

#include "text/utf8.h"

namespace grafwire {

NetlistAssembly::NetlistAssembly(std::string name, Diagnostics& diagnostics)
    : diagnostics_(diagnostics) {
    netlist_.name = std::move(name);
    netlist_.origins.push_back({});
}

NetId NetlistAssembly::net(std::string_view name, Location where) {
    const auto [found, is_new] =
        by_name_.try_emplace(std::string(name), static_cast<NetId>(nets_.size()));
    if (is_new) {
        check_name(name, where);
        nets_.push_back({found->first, no_net, where, no_net, false, false, {}});
    }
    return found->second;
}

void NetlistAssembly::check_name(std::string_view name, Location where) {
    if (find_control(name) == std::string_view::npos) return;
    diagnostics_.error(Code::unexpected_character, where, control_in_name_message(name));
}

void NetlistAssembly::check_port(std::string_view name, NetId net, Location where) {
    if (name != name_of(net)) check_name(name, where);
}

NetId NetlistAssembly::inner_net(NetId owner) {
    nets_.push_back({{}, owner, {}, no_net, false, false, {}});
    return static_cast<NetId>(nets_.size() - 1);
}

std::string_view NetlistAssembly::name_of(NetId net) const {
    return nets_[index_of(net)].name;
}

void NetlistAssembly::drive(NetId id, Location where) {
    Net& net = nets_[index_of(id)];
    if (net.is_driven) {
        Diagnostic& error =
            diagnostics_.error(Code::bad_netlist, where,
                               fmt::format("net {} has a second driver", in_quotes(net.name)));
        if (net.driver.is_known()) error.notes.push_back({net.driver, "the first one is here"});
    }
    net.is_driven = true;
    net.driver = where;
}

void NetlistAssembly::add_input(std::string_view name, NetId net, Location where) {
    drive(net, where);
    check_port(name, net, where);
    nets_[index_of(net)].is_input = true;
    netlist_.inputs.push_back({std::string(name), net});
}

void NetlistAssembly::add_output(std::string_view name, NetId net, Location where) {
    if (!output_names_.insert(std::string(name)).second) {
        diagnostics_.error(Code::bad_netlist, where,
                           fmt::format("output {} is listed twice", in_quotes(name)));
        return;
    }
    check_port(name, net, where);
    netlist_.outputs.push_back({std::string(name), net});
}

bool NetlistAssembly::is_input(std::string_view name) const {
    const auto found = by_name_.find(std::string(name));
    return found != by_name_.end() && nets_[index_of(found->second)].is_input;
}

void NetlistAssembly::add_cell(CellType type, NetId output, std::span<const NetId> pins,
                               Location where, const Details& details) {
    drive(output, where);
    if ((type == CellType::rise_pulse || type == CellType::fall_pulse) &&
        details.timing.fall == 0) {
        diagnostics_.error(Code::bad_netlist, where,
                           fmt::format("the pulse of {} '{}' has no width",
                                       row_of(type).description, name_of(output)));
    }
    Cell cell;
    cell.type = type;
    cell.initial = details.initial;
    cell.first_pin = static_cast<std::uint32_t>(netlist_.pins.size());
    cell.pin_count = static_cast<std::uint32_t>(pins.size());
    cell.output = output;
    if (row_of(type).has_timing) {
        cell.timing = static_cast<std::uint32_t>(netlist_.timings.size());
        netlist_.timings.push_back(details.timing);
    }
    netlist_.pins.insert(netlist_.pins.end(), pins.begin(), pins.end());
    netlist_.cells.add(cell);
    cell_places_.push_back(where);
}

NetId NetlistAssembly::gate(CellType type, std::span<const NetId> pins, NetId owner,
                            Location where) {
    const NetId output = inner_net(owner);
    add_cell(type, output, pins, where);
    return output;
}

NetId NetlistAssembly::inverted(NetId net, Location where) {
    if (nets_[index_of(net)].inverted == no_net) {
        const NetId output = gate(CellType::inverter, {&net, 1}, net, where);
        nets_[index_of(net)].inverted = output;
        nets_[index_of(output)].inverted = net;
    }
    return nets_[index_of(net)].inverted;
}

NetId NetlistAssembly::constant(bool value, Location where) {
    NetId& net = constants_[value ? 1 : 0];
    if (net == no_net) {
        net = inner_net(no_net);
        add_cell(value ? CellType::high : CellType::low, net, {}, where);
    }
    return net;
}

void NetlistAssembly::set_initial(NetId net, bool value) {
    netlist_.initial_values.push_back({net, value});
}

void NetlistAssembly::name_inner_nets() {
    std::vector<std::uint32_t> next_number(nets_.size() + 1);
    for (std::size_t i = 0; i < nets_.size(); ++i) {
        Net& net = nets_[i];
        if (!net.name.empty()) continue;
        // Owners stand before the nets named after them.
        const std::string owner = net.owner == no_net ? "net" : nets_[index_of(net.owner)].name;
        std::uint32_t& number =
            next_number[net.owner == no_net ? nets_.size() : index_of(net.owner)];
        do {
            net.name = fmt::format("{}${}", owner, ++number);
        } while (!by_name_.try_emplace(net.name, static_cast<NetId>(i)).second);
    }
}

void NetlistAssembly::check_drivers() {
    for (const Net& net : nets_) {
        if (net.is_driven) continue;
        diagnostics_.error(
            Code::bad_netlist, net.where,
            fmt::format("net '{}' has no driver: it is neither an input nor the output "
                        "of a cell",
                        net.name));
    }
}

void NetlistAssembly::find_clock() {
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        const Cell& cell = netlist_.cells.items()[i];
        if (!row_of(cell.type).is_clocked) continue;
        const NetId clock = netlist_.pins_of(cell).back();
        const std::string_view description = row_of(cell.type).description;
        if (!nets_[index_of(clock)].is_input) {
            diagnostics_.error(Code::bad_netlist, cell_places_[i],
                               fmt::format("the clock '{}' of {} '{}' is not an input",
                                           name_of(clock), description, name_of(cell.output)));
            return;
        }
        if (netlist_.clock != no_net && netlist_.clock != clock) {
            diagnostics_.error(
                Code::bad_netlist, cell_places_[i],
                fmt::format("{} '{}' has the clock '{}', others have '{}': one clock is supported",
                            description, name_of(cell.output), name_of(clock),
                            name_of(netlist_.clock)));
            return;
        }
        netlist_.clock = clock;
    }
}

/// Every cell gets the place in the file that it came from.
void NetlistAssembly::set_origins() {
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        const Location where = cell_places_[i];
        if (!where.is_known()) continue;
        const Location last = netlist_.origins.back().where;
        if (last.line != where.line || last.column != where.column) {
            netlist_.origins.push_back({Origin::Kind::other, {}, where});
        }
        netlist_.cells[netlist_.cells.id_at(i)].origin =
            static_cast<std::uint32_t>(netlist_.origins.size() - 1);
    }
}

std::optional<Netlist> NetlistAssembly::finish() {
    name_inner_nets();
    // Cells that were refused leave nets without drivers; that need not be said as well.
    if (!diagnostics_.has_errors()) check_drivers();
    find_clock();
    if (diagnostics_.has_errors()) return std::nullopt;
    for (const Net& net : nets_) netlist_.names.add(net.name);
    set_origins();
    if (!netlist_.cells.empty()) {
        netlist_.modules.push_back(
            {netlist_.name, {}, 0, static_cast<std::uint32_t>(netlist_.cells.size())});
    }
    netlist_.has_modes = is_input("Init");
    // The ports of a netlist list the X variables first.
    while (netlist_.step_count < netlist_.outputs.size() &&
           netlist_.outputs[netlist_.step_count].name.starts_with('X')) {
        ++netlist_.step_count;
    }
    return std::move(netlist_);
}

std::string decoded_name(std::string_view name) {
    const auto digit = [](char c) {
        if (c >= '0' && c <= '9') return c - '0';
        return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    std::string decoded;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] == '%' && i + 2 < name.size()) {
            const int high = digit(name[i + 1]);
            const int low = digit(name[i + 2]);
            const int code = high * 16 + low;
            constexpr std::string_view special = "%#=\\\"`\x7f";
            const bool is_ours =
                high >= 0 && low >= 0 &&
                (code <= 0x20 || special.find(static_cast<char>(code)) != std::string_view::npos);
            if (is_ours) {
                decoded += static_cast<char>(code);
                i += 2;
                continue;
            }
        }
        decoded += name[i];
    }
    return decoded;
}

std::optional<CellType> helper_type_named(std::string_view name) {
    constexpr std::string_view prefix = "grafwire_";
    if (!name.starts_with(prefix)) return std::nullopt;
    name.remove_prefix(prefix.size());
    // Where the GRAFCET is itself called grafwire_…, the helpers have more of these.
    while (name.starts_with('_')) name.remove_prefix(1);
    const std::optional<CellType> type = cell_type_named(name);
    if (!type || (!row_of(*type).has_memory && !row_of(*type).has_timing)) return std::nullopt;
    return type;
}

std::span<const std::string_view> helper_pin_names(CellType type) {
    static constexpr std::string_view latch[] = {"s", "r"};
    static constexpr std::string_view hold[] = {"d", "e"};
    static constexpr std::string_view flip_flop[] = {"d", "c"};
    static constexpr std::string_view timer[] = {"a", "c"};
    static constexpr std::string_view look_ahead[] = {"a", "h", "c"};
    switch (type) {
        case CellType::latch:
            return latch;
        case CellType::hold_latch:
            return hold;
        case CellType::flip_flop:
            return flip_flop;
        case CellType::scan_timer:
            return timer;
        case CellType::scan_timer_next:
            return look_ahead;
        default:
            return {timer, 1};
    }
}

bool set_helper_parameter(NetlistAssembly::Details& details, std::string_view name,
                          std::string_view value) {
    if (name == "INIT") {
        if (value != "0" && value != "1" && value != "x") return false;
        details.initial = value == "0" ? Logic::zero : value == "1" ? Logic::one : Logic::unknown;
        return true;
    }
    if (name == "ORDINAL") {
        const bool is_number = !value.empty() && value.size() <= 9 &&
                               value.find_first_not_of("0123456789") == std::string_view::npos;
        if (!is_number) return false;
        std::uint32_t number = 0;
        for (const char c : value) number = number * 10 + static_cast<std::uint32_t>(c - '0');
        details.timing.ordinal = number;
        return true;
    }
    if (name != "RISE" && name != "FALL") return false;
    const std::optional<Time> duration = parse_duration(value);
    if (!duration) return false;
    (name == "RISE" ? details.timing.rise : details.timing.fall) = *duration;
    return true;
}

}  // namespace grafwire
