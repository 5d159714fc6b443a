#include "support/small_netlist.h"

#include "text/time.h"

namespace grafwire {

std::ostream& operator<<(std::ostream& out, Logic value) {
    return out << (value == Logic::unknown ? 'x' : value == Logic::one ? '1' : '0');
}

}  // namespace grafwire

namespace grafwire::testing {

SmallNetlist::SmallNetlist() {
    netlist.name = "small";
    netlist.origins.emplace_back();
    netlist.timings.emplace_back();
}

NetId SmallNetlist::net(std::string_view name) {
    const auto [place, is_new] = nets_.emplace(std::string(name), no_net);
    if (is_new) place->second = netlist.names.add(name);
    return place->second;
}

void SmallNetlist::input(std::string_view name) {
    netlist.inputs.push_back({std::string(name), net(name)});
}
void SmallNetlist::output(std::string_view name) {
    netlist.outputs.push_back({std::string(name), net(name)});
}

CellId SmallNetlist::cell(CellType type, std::string_view name,
                          const std::vector<std::string>& pins, Logic initial) {
    Cell cell;
    cell.type = type;
    cell.initial = initial;
    cell.output = net(name);
    cell.origin = 0;
    cell.first_pin = static_cast<std::uint32_t>(netlist.pins.size());
    cell.pin_count = static_cast<std::uint32_t>(pins.size());
    for (const std::string& pin : pins) netlist.pins.push_back(net(pin));
    return netlist.cells.add(cell);
}

CellId SmallNetlist::timed(CellType type, std::string_view name,
                           const std::vector<std::string>& pins, Timing timing, Logic initial) {
    const CellId id = cell(type, name, pins, initial);
    netlist.cells[id].timing = static_cast<std::uint32_t>(netlist.timings.size());
    netlist.timings.push_back(timing);
    return id;
}

void SmallNetlist::clock(std::string_view name) {
    input(name);
    netlist.clock = net(name);
}
void SmallNetlist::starts_at(std::string_view name, bool value) {
    netlist.initial_values.push_back({net(name), value});
}

void Bench::record(std::string_view name) {
    changes.clear();
    origin = simulator.now();
    simulator.observe([this, wanted = small_.net(name)](Time at, NetId net, Logic value) {
        if (net != wanted) return;
        if (!changes.empty()) changes += ' ';
        changes += value == unknown ? 'x' : value == one ? '1' : '0';
        changes += '@';
        const Time from_origin = at - origin;
        changes += std::to_string(from_origin / nanosecond);
        if (from_origin % nanosecond != 0) {
            changes += '.' + std::to_string(from_origin % nanosecond);
        }
    });
}

}  // namespace grafwire::testing
