#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// The nets of a netlist as a schematic shows them: what drives each, how often it is read, and
/// what it is called.
struct SchematicNets {
    explicit SchematicNets(const Netlist& netlist);

    const Netlist& netlist;
    Table<NetId, CellId> drivers;
    std::vector<std::uint32_t> uses;      ///< by net: pins and output ports that it goes to
    std::vector<std::uint8_t> is_output;  ///< by net: it is an output port
    std::vector<std::string> names;       ///< by net: as shown_names() has them
};

/// What nets are called in the words of the chart, each otherwise than all others: `/X3` for an
/// inverted X3, `X3′` for X3 a gate delay later, `(3)` for the clearing of transition 3, `↑a` for
/// an edge, `3s/X2` for a time condition. The netlist itself says so: a net that is not what its
/// name says has its own name, as has one whose words would be too long.
std::vector<std::string> shown_names(const Netlist& netlist, const Table<NetId, CellId>& drivers);

}  // namespace grafwire
