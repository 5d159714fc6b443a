#include "netlist/used_figures.h"

#include <map>
#include <utility>

namespace grafwire {

std::vector<UsedFigures> used_figures(const PartFamily& family, const Netlist& netlist) {
    std::map<std::pair<CellType, std::size_t>, std::size_t> counts;
    for (const Cell& cell : netlist.cells) {
        const bool is_constant = cell.type == CellType::low || cell.type == CellType::high;
        if (!is_constant) ++counts[{cell.type, cell.pin_count}];
    }
    std::vector<UsedFigures> used;
    for (const auto& [kind, count] : counts) {
        const auto [type, inputs] = kind;
        const auto bands = bands_of(family, type, inputs);
        if (bands) used.push_back({type, inputs, count, *bands, part_for(family, type, inputs)});
    }
    return used;
}

}  // namespace grafwire
