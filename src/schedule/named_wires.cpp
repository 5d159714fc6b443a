// Which wires a `.delays` text names: its lines are looked at for their names alone, before the
// text is read for a netlist in which these wires are cells.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "schedule/delays_text.h"
#include "trace/line_cursor.h"

namespace grafwire {

namespace {

/// What stands first on a line, without its quotes.
std::string_view first_name(std::string_view line) {
    LineCursor cursor(line, 1);
    cursor.skip_blanks();
    if (cursor.at_end()) return {};
    if (!cursor.skip_if('"')) return cursor.take_until_blank();
    return cursor.rest().substr(0, cursor.rest().find('"'));
}

}  // namespace

std::vector<Wire> wires_named_in(const SourceFile& source, const Netlist& netlist) {
    std::vector<std::string_view> names;
    std::string_view text = source.text;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        const std::string_view name = first_name(text.substr(0, length));
        if (name.find("->") != name.npos) names.push_back(name);
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    if (names.empty()) return {};
    std::vector<Wire> wires = wires_named(netlist, names);
    // A net that is called so is none of its wires.
    std::erase_if(wires, [&](const Wire& wire) {
        const std::string name = wire_name(netlist, wire);
        return std::any_of(netlist.cells.begin(), netlist.cells.end(),
                           [&](const Cell& cell) { return netlist.names[cell.output] == name; });
    });
    return wires;
}

}  // namespace grafwire
