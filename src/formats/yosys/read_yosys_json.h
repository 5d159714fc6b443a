#pragma once

#include <optional>

#include "formats/shared/messages.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Reads a netlist that Yosys (write_json) or write_yosys_json() wrote: one flat module of gates,
/// one-bit word-level cells, rising-edge flip-flops without asynchronous reset, latches, and the
/// black boxes of write_yosys_json(). What else there is goes into `diagnostics` as
/// code::bad_netlist, naming the cell, and the result is empty then.
std::optional<Netlist> read_yosys_json(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace grafwire
