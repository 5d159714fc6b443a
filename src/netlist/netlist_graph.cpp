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
    for (const Cell& cell : netlist.cells) {
        for (const NetId pin : netlist.pins_of(cell)) {
            if (drivers[pin] != no_cell) ++first_reader_[index_of(drivers[pin]) + 1];
        }
    }
    for (std::size_t i = 1; i < first_reader_.size(); ++i) first_reader_[i] += first_reader_[i - 1];
    readers_.resize(first_reader_.back());
    std::vector<std::uint32_t> next(first_reader_.begin(), first_reader_.end() - 1);
    for (std::uint32_t i = 0; i < netlist.cells.size(); ++i) {
        for (const NetId pin : netlist.pins_of(netlist.cells[netlist.cells.id_at(i)])) {
            if (drivers[pin] != no_cell) readers_[next[index_of(drivers[pin])]++] = i;
        }
    }
}

}  // namespace grafwire
