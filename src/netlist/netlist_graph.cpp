// The fan-out lists of the graph in two arrays (compressed sparse rows): a pass counts the readers
// of every cell, another fills them in. Both are in the order of cells, so that algorithms of
// Boost.Graph, which visit edges in the order of the lists, give the same result every time.

#include "netlist/netlist_graph.h"

#include <algorithm>
#include <boost/graph/strong_components.hpp>

#include "netlist/netlist.h"
#include "netlist/netlist_in_boost.h"

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

// R. Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1, 1972. Components
// are numbered in the order in which they are left, that is, in reverse topological order.

std::vector<std::uint32_t> strong_components(const NetlistGraph& graph) {
    std::vector<std::uint32_t> component(graph.cell_count());
    if (component.empty()) return component;
    const auto index = get(boost::vertex_index_t{}, graph);
    boost::strong_components(graph, boost::make_iterator_property_map(component.begin(), index),
                             boost::vertex_index_map(index));
    return component;
}

// A cell lies on a loop where its strongly connected component has more than one cell, or where it
// reads itself.

std::vector<std::uint8_t> cells_on_loops(const Netlist& netlist) {
    const NetlistGraph graph(netlist, NetlistGraph::Edges::at_once);
    const std::vector<std::uint32_t> component = strong_components(graph);
    std::vector<std::uint32_t> size(graph.cell_count());
    for (const std::uint32_t c : component) ++size[c];

    std::vector<std::uint8_t> on_loop(graph.cell_count());
    for (std::uint32_t i = 0; i < on_loop.size(); ++i) {
        const auto readers = graph.readers(i);
        const bool reads_itself = std::find(readers.begin(), readers.end(), i) != readers.end();
        on_loop[i] = size[component[i]] > 1 || reads_itself ? 1 : 0;
    }
    return on_loop;
}

}  // namespace grafwire
