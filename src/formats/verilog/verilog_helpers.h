#pragma once

#include <string>
#include <string_view>

#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Writes the helper modules for the cells with memory or timing that the netlist has; nothing
/// where it has none.
void append_verilog_helpers(std::string& out, const Netlist& netlist, const DelayModel& delays,
                            std::string_view prefix);

/// Whether the netlist needs the macros GRAFWIRE_START and GRAFWIRE_INSTANT: where it has initial
/// values to hold at first (other than flip-flops') or delays to count.
bool needs_verilog_start(const Netlist& netlist);

/// Writes the defaults of those macros.
void append_verilog_start(std::string& out, const DelayModel& delays);

}  // namespace grafwire
