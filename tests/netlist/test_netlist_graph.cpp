#include <boost/graph/strong_components.hpp>
#include <boost/graph/topological_sort.hpp>
#include <map>
#include <set>

#include "netlist/netlist_in_boost.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

/// The strongly connected components of more than one cell, as sets of the nets they drive.
std::set<std::set<std::string>> loops_of(const Netlist& netlist) {
    const NetlistGraph graph(netlist);
    std::vector<std::uint32_t> component(graph.cell_count());
    const auto index = get(boost::vertex_index_t{}, graph);
    boost::strong_components(graph, boost::make_iterator_property_map(component.begin(), index),
                             boost::vertex_index_map(index));
    std::map<std::uint32_t, std::set<std::string>> members;
    for (std::size_t i = 0; i < component.size(); ++i) {
        const Cell& cell = netlist.cells[netlist.cells.id_at(i)];
        members[component[i]].insert(std::string(netlist.names[cell.output]));
    }
    std::set<std::set<std::string>> loops;
    for (const auto& [number, names] : members) {
        if (names.size() > 1) loops.insert(names);
    }
    return loops;
}

}  // namespace

TEST_CASE("the loops of a netlist are the strong components of its graph") {
    // Step 0 sets step 1, which resets it: one loop. Step 2 keeps to itself.
    const Grafcet open = grafcet_of(R"(
input a, b
graph G { initial 0 step 1 step 2
  0 -> 1 : a
  1 -> : b
  2 -> : b }
)");
    const auto loops = loops_of(netlist_of(open, Style::nand, false));
    REQUIRE(loops.size() == 2);
    for (const auto& loop : loops) {
        CHECK(loop.count("X0") == loop.count("X1"));
        CHECK(loop.count("X0") + loop.count("X2") == 1);
        for (const std::string step : {"X0", "X1", "X2"}) {
            CHECK(loop.count(step) == loop.count(step + "$q"));
        }
    }

    // In a ring of steps everything hangs together, but for the outputs.
    const Grafcet ring = grafcet_of(R"(
input a
output lamp
graph G { initial 0 : lamp step 1 step 2
  0 -> 1 : a
  1 -> 2 : /a
  2 -> 0 : a }
)");
    const auto ring_loops = loops_of(netlist_of(ring, Style::gates, false));
    REQUIRE(ring_loops.size() == 1);
    CHECK(ring_loops.begin()->count("X0") == 1);
    CHECK(ring_loops.begin()->count("X1") == 1);
    CHECK(ring_loops.begin()->count("X2") == 1);
    CHECK(ring_loops.begin()->count("lamp") == 0);
}

TEST_CASE("an edge of the graph for every pin that a cell drives") {
    const Grafcet grafcet = grafcet_of("input a graph G { initial 0 0 -> 0 : a . a + a }");
    const Netlist netlist = netlist_of(grafcet, Style::clocked);
    const NetlistGraph graph(netlist);
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    std::size_t driven_pins = 0;
    for (const Cell& cell : netlist.cells) {
        for (const NetId pin : netlist.pins_of(cell)) driven_pins += drivers[pin] != no_cell;
    }
    std::size_t edges = 0;
    for (std::uint32_t cell = 0; cell < num_vertices(graph); ++cell) {
        edges += out_degree(cell, graph);
        const auto [begin, end] = out_edges(cell, graph);
        for (auto edge = begin; edge != end; ++edge) {
            const Cell& reader = netlist.cells[netlist.cells.id_at(target(*edge, graph))];
            bool reads = false;
            for (const NetId pin : netlist.pins_of(reader)) {
                reads |= drivers[pin] == netlist.cells.id_at(cell);
            }
            CHECK(source(*edge, graph) == cell);
            CHECK(reads);
        }
    }
    CHECK(edges == driven_pins);
    CHECK(edges != 0);
}

TEST_CASE("between two clocks nothing gets through a flip-flop") {
    const Grafcet grafcet = grafcet_of("input a graph G { initial 0 0 -> 0 : a . 3s/X0 }");
    const Netlist netlist = netlist_of(grafcet, Style::clocked);
    const NetlistGraph graph(netlist, NetlistGraph::Edges::between_clocks);
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    std::size_t driven_pins = 0;
    std::size_t flip_flops = 0;
    for (const Cell& cell : netlist.cells) {
        const bool waits = cell.type == CellType::flip_flop || cell.type == CellType::scan_timer;
        flip_flops += waits ? 1 : 0;
        if (waits) continue;
        for (const NetId pin : netlist.pins_of(cell)) driven_pins += drivers[pin] != no_cell;
    }
    CHECK(flip_flops != 0);
    std::size_t edges = 0;
    for (std::uint32_t cell = 0; cell < num_vertices(graph); ++cell) {
        edges += out_degree(cell, graph);
        for (const std::uint32_t reader : graph.readers(cell)) {
            CHECK(netlist.cells.items()[reader].type != CellType::flip_flop);
        }
    }
    CHECK(edges == driven_pins);
}

}  // namespace grafwire::testing
