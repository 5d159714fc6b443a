#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/shared/netlist_assembly.h"

namespace grafwire {

/// One cell of a Yosys netlist. Constant bits of inputs have been given nets by then.
struct YosysCell {
    std::string name;
    std::string type;
    Location where;
    struct Connection {
        std::string port;
        std::vector<NetId> bits;
        /// Per bit: '0' or '1' for a constant, else '-'.
        std::string constants;
    };
    std::vector<Connection> connections;
    std::vector<std::pair<std::string, std::string>> parameters;

    const Connection* find(std::string_view port) const;
    /// The bits of a parameter, or its text; empty where there is none.
    std::string_view parameter(std::string_view parameter_name) const;
};

/// Adds the gates for a cell. Where it cannot be used the reason is the result, else nothing.
/// `initial` is what the net of its output holds at power-up.
std::string add_yosys_cell(NetlistAssembly& assembly, const YosysCell& cell, Logic initial);

/// Whether a type keeps a value of its own, so that an `init` attribute of its output is its own.
bool is_yosys_memory(std::string_view type);

}  // namespace grafwire
