// A cell lies on a loop where its strongly connected component has more than one cell, or where it
// reads itself (R. Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1,
// 1972; Boost.Graph's strong_components).

#include "netlist/loops.h"

#include <algorithm>
#include <boost/graph/strong_components.hpp>

#include "netlist/boost_graph.h"

namespace grafwire {

std::vector<std::uint8_t> cells_on_loops(const Netlist& netlist) {
    const NetlistGraph graph(netlist, NetlistGraph::Edges::at_once);
    std::vector<std::uint32_t> component(graph.cell_count());
    const auto index = get(boost::vertex_index_t{}, graph);
    const auto count =
        boost::strong_components(graph, boost::make_iterator_property_map(component.begin(), index),
                                 boost::vertex_index_map(index));
    std::vector<std::uint32_t> size(count);
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
