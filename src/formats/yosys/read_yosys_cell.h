#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/shared/netlist_assembly.h"

namespace grafwire {

/// One cell of a Yosys netlist, as it stands in the file.
struct YosysCell {
    std::string name;
    std::string type;
    Location where;
    struct Connection {
        std::string port;
        std::vector<NetId> bits;  ///< no_net for a constant
        /// Per bit: '0' or '1' for a constant, else '-'.
        std::string constants;
    };
    std::vector<Connection> connections;
    std::vector<std::pair<std::string, std::string>> parameters;  ///< and attributes

    const Connection* find(std::string_view port) const;
    /// The bits of a parameter, or its text; empty where there is none.
    std::string_view parameter(std::string_view parameter_name) const;
};

/// Adds the gates for a cell, or reports why it cannot be used. `initial` is what the net of its
/// output holds at power-up.
void add_yosys_cell(NetlistAssembly& assembly, YosysCell cell, Logic initial,
                    Diagnostics& diagnostics);

/// Reports what is wrong with a cell.
void refuse_yosys_cell(const YosysCell& cell, const Localized& reason, Diagnostics& diagnostics);

/// Whether a type keeps a value of its own, so that an `init` attribute of its output is its own.
bool is_yosys_memory(std::string_view type);

}  // namespace grafwire
