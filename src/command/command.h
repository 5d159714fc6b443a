#pragma once

#include <string_view>

#include "command/command_line.h"
#include "text/message.h"

namespace grafwire {

/// One row of the table of commands: adds its options to the parser and returns what to do once
/// they have been read.
struct Command {
    std::string_view name;
    Message<> summary;
    std::string_view example;
    Task (*declare)(const CommandLine& line);
};

Task declare_info(const CommandLine& line);
Task declare_equations(const CommandLine& line);
Task declare_run(const CommandLine& line);
Task declare_netlist(const CommandLine& line);
Task declare_simulate(const CommandLine& line);
Task declare_check(const CommandLine& line);
Task declare_plc(const CommandLine& line);
Task declare_s7(const CommandLine& line);

}  // namespace grafwire
