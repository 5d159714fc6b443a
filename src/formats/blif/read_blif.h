#pragma once

#include <optional>

#include "formats/shared/messages.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Reads a netlist in the Berkeley logic interchange format: one flat model of `.names`, `.latch`
/// (rising edge, or transparent while high; without a clock: on an input `clk`) and the black boxes
/// that write_blif() makes. What else there is goes into `diagnostics` as code::bad_netlist with
/// its place, and the result is empty then.
std::optional<Netlist> read_blif(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace grafwire
