#pragma once

#include "draw/picture.h"
#include "draw/picture_rules.h"
#include "netlist/netlist.h"

namespace grafwire::testing {

// What a printed schematic must be like, measured in the picture. Each rule says what breaks it, a
// line each.

/// Every cell of the netlist is there once, with its type and all its pins, each with its net.
Faults missing_cells(const Netlist& netlist, const Picture& picture);
/// Every pin is at the end of a line of its net or at its name, and what lines join is joined to
/// the gate that drives the net, or has the name of the net; where a net is in several pieces, each
/// of them has it.
Faults unjoined_nets(const Netlist& netlist, const Picture& picture);
/// No line passes through a symbol, or lies on a line of another net; a dot is where at least three
/// ends of lines of one net meet, and nowhere else do they.
Faults tangled_lines(const Picture& picture);
/// Names of nets differ; each that is in the index is on the sheets that the index says.
Faults wrong_names(const Netlist& netlist, const Picture& picture);

/// All of the rules, and that no text is crowded.
Faults all_schematic_faults(const Netlist& netlist, const Picture& picture);

}  // namespace grafwire::testing
