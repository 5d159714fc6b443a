#include "formats/spice/spice_names.h"

#include <unordered_set>

#include "formats/shared/append.h"

namespace grafwire {

namespace {

char small(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_safe(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

SpiceNames::SpiceNames(const Netlist& netlist) {
    // What ngspice gives a meaning of its own.
    std::unordered_set<std::string> taken{"gnd", "null", "time", "temper", "hertz"};
    const auto add = [&](NetId net, std::string_view original) {
        std::string name;
        bool changed = false;
        for (const char c : original) {
            const bool safe = is_safe(small(c));
            name += safe ? small(c) : '_';
            changed |= !safe;
        }
        if (name.empty() || name[0] < 'a' || name[0] > 'z') {
            name.insert(0, 1, 'n');
            changed = true;
        }
        const std::size_t length = name.size();
        for (std::size_t number = 2; !taken.insert(name).second; ++number) {
            name.resize(length);
            append(name, '_', number);
            changed = true;
        }
        names_[index_of(net)] = std::move(name);
        changed_[index_of(net)] = changed ? 1 : 0;
    };
    names_.resize(netlist.net_count());
    changed_.resize(netlist.net_count());
    // Ports first: they are what users look for.
    for (const Port& port : netlist.inputs) add(port.net, port.name);
    for (const Port& port : netlist.outputs) {
        if (names_[index_of(port.net)].empty()) add(port.net, netlist.names[port.net]);
    }
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        if (names_[i].empty()) add(static_cast<NetId>(i), netlist.names[static_cast<NetId>(i)]);
    }
}

}  // namespace grafwire
