#pragma once

#include <functional>
#include <string_view>

#include "text/language.h"

namespace CLI {
class App;
}

namespace grafwire {

/// One row of the table of commands: adds its options to the parser and returns what to do once
/// they have been read.
struct Command {
    std::string_view name;
    std::string_view summary;
    std::string_view example;
    std::function<int()> (*declare)(CLI::App& app, const Language& language);
};

std::function<int()> declare_info(CLI::App& app, const Language& language);
std::function<int()> declare_equations(CLI::App& app, const Language& language);
std::function<int()> declare_run(CLI::App& app, const Language& language);
std::function<int()> declare_netlist(CLI::App& app, const Language& language);
std::function<int()> declare_simulate(CLI::App& app, const Language& language);
std::function<int()> declare_check(CLI::App& app, const Language& language);
std::function<int()> declare_plc(CLI::App& app, const Language& language);
std::function<int()> declare_s7(CLI::App& app, const Language& language);

}  // namespace grafwire
