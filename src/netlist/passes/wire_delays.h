#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// A wire leads from a net to a cell that reads it. (A cell that reads a net at several pins has
/// them tied together at itself.)
struct Wire {
    NetId net = no_net;
    CellId reader = no_cell;
    bool operator==(const Wire&) const = default;
};

/// The wires whose delays can make a difference, in the order of their readers, then of pins: where
/// these and the gates may take any time, so may the others.
std::vector<Wire> telling_wires(const Netlist& netlist);

/// `a->X1$set`: a wire by the nets at its start and behind its reader.
std::string wire_name(const Netlist& netlist, const Wire& wire);
/// The wires among some names, each once, in the order of the names; a name that is no wire's is
/// left out.
std::vector<Wire> wires_named(const Netlist& netlist, std::span<const std::string_view> names);

/// A netlist in which each of these wires is a cell: a buffer whose net has the name of the wire.
/// Cells and nets that there are keep their numbers; the buffers come last, in the order given and
/// in a module of their own.
Netlist with_wire_delays(const Netlist& netlist, const std::vector<Wire>& wires);

/// Whether a cell is such a buffer.
bool is_wire(const Netlist& netlist, const Cell& cell);

}  // namespace grafwire
