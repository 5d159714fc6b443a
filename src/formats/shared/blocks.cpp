#include "formats/shared/blocks.h"

#include <algorithm>

namespace grafwire {

std::vector<NetlistBlock> cut_into_blocks(const Netlist& netlist, std::size_t modules_per_block) {
    constexpr std::uint32_t no_block = 0xffffffffU;
    std::vector<NetlistBlock> blocks;
    std::vector<std::uint32_t> driver(netlist.net_count(), no_block);
    const std::span<const Module> all = netlist.modules;
    for (std::size_t first = 0; first < all.size(); first += modules_per_block) {
        const std::size_t count = std::min(modules_per_block, all.size() - first);
        const auto number = static_cast<std::uint32_t>(blocks.size());
        NetlistBlock block{all.subspan(first, count), {}, {}, false};
        for_each_cell(netlist, block.modules, [&](const Cell& cell) {
            driver[index_of(cell.output)] = number;
            block.has_scan_timer |= counts_scans(cell.type);
        });
        blocks.push_back(std::move(block));
    }
    // Block after block, so the last block that was found to read a net is all there is to
    // remember.
    std::vector<std::uint32_t> reader(netlist.net_count(), no_block);
    std::vector<std::uint8_t> leaves(netlist.net_count());
    for (std::uint32_t number = 0; number < blocks.size(); ++number) {
        for_each_cell(netlist, blocks[number].modules, [&](const Cell& cell) {
            for (const NetId pin : netlist.pins_of(cell)) {
                const std::size_t net = index_of(pin);
                if (driver[net] == number || reader[net] == number) continue;
                reader[net] = number;
                leaves[net] = 1;
                blocks[number].inputs.push_back(pin);
            }
        });
    }
    for (const Port& port : netlist.outputs) leaves[index_of(port.net)] = 1;
    for (NetlistBlock& block : blocks) {
        for_each_cell(netlist, block.modules, [&](const Cell& cell) {
            if (leaves[index_of(cell.output)] != 0) block.outputs.push_back(cell.output);
        });
    }
    return blocks;
}

}  // namespace grafwire
