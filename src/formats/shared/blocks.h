#pragma once

#include <span>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// Some consecutive modules of a netlist, and the nets between them and the rest: for tools that
/// are slow on one long module.
struct NetlistBlock {
    std::span<const Module> modules;
    std::vector<NetId> inputs;   ///< read here, driven elsewhere, in the order of first use
    std::vector<NetId> outputs;  ///< driven here, read elsewhere or an output of the netlist
    bool has_scan_timer = false;
};

/// The netlist in blocks of at most so many modules.
std::vector<NetlistBlock> cut_into_blocks(const Netlist& netlist, std::size_t modules_per_block);

/// Visits the cells of some modules in order.
template <typename Visit>
void for_each_cell(const Netlist& netlist, std::span<const Module> modules, const Visit& visit) {
    for (const Module& module : modules) {
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            visit(netlist.cells.items()[module.first_cell + i]);
        }
    }
}

}  // namespace grafwire
