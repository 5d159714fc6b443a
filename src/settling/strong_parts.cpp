// R. Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1, 1972;
// Boost.Graph's strong_components, which takes seconds to compile and so has this file to itself.

#include "settling/strong_parts.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace grafwire {

StrongParts strong_parts(const std::vector<std::vector<std::uint32_t>>& successors) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
    Graph graph(successors.size());
    for (std::uint32_t node = 0; node < successors.size(); ++node) {
        for (const std::uint32_t next : successors[node]) boost::add_edge(node, next, graph);
    }
    StrongParts parts;
    parts.of_node.resize(successors.size());
    parts.count = boost::strong_components(
        graph,
        boost::make_iterator_property_map(parts.of_node.begin(), get(boost::vertex_index, graph)));
    return parts;
}

}  // namespace grafwire
