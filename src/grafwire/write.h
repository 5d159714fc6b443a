#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "grafwire/netlist.h"
#include "grafwire/read.h"

namespace grafwire::api {

/// The names of the formats of netlists (`verilog`, `blif`, …), and those of programs (`st`, `c`,
/// …).
std::vector<std::string> netlist_formats();
std::vector<std::string> program_formats();

/// Writes a netlist in one of its formats. `period`: what clocked timers count with; positive.
Result<std::string> write_netlist(const Netlist& netlist, std::string_view format,
                                  std::chrono::nanoseconds period = std::chrono::milliseconds(10));

/// Writes a chart as a program. Errors: there is no such format, or it cannot hold the chart.
Result<std::string> write_program(const Chart& chart, std::string_view format, bool modes = true);

}  // namespace grafwire::api
