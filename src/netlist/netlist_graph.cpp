#include "netlist/boost_graph.h"

namespace grafwire {

NetlistGraph::NetlistGraph(const Netlist& netlist, Edges edges)
    : first_reader_(netlist.cells.size() + 1), readers_() {
    Table<NetId, CellId> drivers = drivers_of(netlist);
    if (edges == Edges::at_once) {
        for (const Cell& cell : netlist.cells) {
            if (row_of(cell.type).has_memory) drivers[cell.output] = no_cell;
        }
    }
    const auto edges_to = [&](const Cell& cell, const auto& visit) {
        const CellTypeRow& row = row_of(cell.type);
        if (edges == Edges::between_clocks && row.is_clocked && row.has_memory) return;
        for (const NetId pin : netlist.pins_of(cell)) {
            if (drivers[pin] != no_cell) visit(index_of(drivers[pin]));
        }
    };
    for (const Cell& cell : netlist.cells) {
        edges_to(cell, [&](std::size_t driver) { ++first_reader_[driver + 1]; });
    }
    for (std::size_t i = 1; i < first_reader_.size(); ++i) first_reader_[i] += first_reader_[i - 1];
    readers_.resize(first_reader_.back());
    std::vector<std::uint32_t> next(first_reader_.begin(), first_reader_.end() - 1);
    for (std::uint32_t i = 0; i < netlist.cells.size(); ++i) {
        edges_to(netlist.cells.items()[i],
                 [&](std::size_t driver) { readers_[next[driver]++] = i; });
    }
}

}  // namespace grafwire
