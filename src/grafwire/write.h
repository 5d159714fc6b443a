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

struct NetlistFileOptions {
    std::chrono::nanoseconds period = std::chrono::milliseconds(10);  ///< of clocked timers; > 0
    std::string stimuli;  ///< a `.stim` text that a deck or a bench applies; none if empty
};

struct NetlistFile {
    std::string text;
    std::string bench;  ///< of formats whose bench is a second file, where there are stimuli
};

/// Writes a netlist in one of its formats. Errors: there is no such format, the period is not
/// positive, the stimuli cannot be read.
Result<NetlistFile> write_netlist(const Netlist& netlist, std::string_view format,
                                  const NetlistFileOptions& options = {});

struct ProgramOptions {
    bool modes = true;                      ///< with Init, AUdur and AUdoux
    Language language = Language::english;  ///< of comments and headings
};

/// Writes a chart as a program. Errors: there is no such format, or it cannot hold the chart.
Result<std::string> write_program(const Chart& chart, std::string_view format,
                                  const ProgramOptions& options = {});

}  // namespace grafwire::api
