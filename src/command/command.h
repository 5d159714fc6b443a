#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "command/command_line.h"
#include "text/language.h"

namespace grafwire {

/// One row of the table of commands: adds its options to the parser and returns what to do once
/// they have been read.
struct Command {
    std::string_view name;
    std::string_view summary;
    std::string_view example;
    Task (*declare)(const CommandLine& line, const Language& language);
};

Task declare_info(const CommandLine& line, const Language& language);
Task declare_equations(const CommandLine& line, const Language& language);
Task declare_run(const CommandLine& line, const Language& language);
Task declare_netlist(const CommandLine& line, const Language& language);
Task declare_simulate(const CommandLine& line, const Language& language);
Task declare_check(const CommandLine& line, const Language& language);
Task declare_plc(const CommandLine& line, const Language& language);
Task declare_s7(const CommandLine& line, const Language& language);

}  // namespace grafwire
