#pragma once

// The adaptor through which algorithms of Boost.Graph read a netlist: traits, and the free
// functions that they look up by the type of the graph, which models VertexListGraph and
// IncidenceGraph. Boost takes seconds to compile: what only needs a result calls a function of
// netlist_graph.h.

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/irange.hpp>
#include <cstdint>
#include <utility>

#include "netlist/netlist_graph.h"

namespace grafwire {

struct MakeNetlistEdge {
    std::uint32_t source = 0;
    NetlistGraph::Edge operator()(std::uint32_t target) const { return {source, target}; }
};

}  // namespace grafwire

namespace boost {
template <>
struct graph_traits<grafwire::NetlistGraph> {
    using vertex_descriptor = std::uint32_t;
    using edge_descriptor = grafwire::NetlistGraph::Edge;
    using directed_category = directed_tag;
    using edge_parallel_category = allow_parallel_edge_tag;
    struct traversal_category : public virtual incidence_graph_tag,
                                public virtual vertex_list_graph_tag {};
    using vertices_size_type = std::uint32_t;
    using edges_size_type = std::uint32_t;
    using degree_size_type = std::uint32_t;
    using vertex_iterator = range_iterator<integer_range<std::uint32_t>>::type;
    using out_edge_iterator =
        transform_iterator<grafwire::MakeNetlistEdge, const std::uint32_t*,
                           grafwire::NetlistGraph::Edge, grafwire::NetlistGraph::Edge>;
    static vertex_descriptor null_vertex() { return 0xffffffffU; }
};
}  // namespace boost

namespace grafwire {

inline std::pair<boost::graph_traits<NetlistGraph>::vertex_iterator,
                 boost::graph_traits<NetlistGraph>::vertex_iterator>
vertices(const NetlistGraph& graph) {
    const auto range =
        boost::irange<std::uint32_t>(0, static_cast<std::uint32_t>(graph.cell_count()));
    return {range.begin(), range.end()};
}
inline std::uint32_t num_vertices(const NetlistGraph& graph) {
    return static_cast<std::uint32_t>(graph.cell_count());
}
inline std::pair<boost::graph_traits<NetlistGraph>::out_edge_iterator,
                 boost::graph_traits<NetlistGraph>::out_edge_iterator>
out_edges(std::uint32_t cell, const NetlistGraph& graph) {
    using Iterator = boost::graph_traits<NetlistGraph>::out_edge_iterator;
    const auto readers = graph.readers(cell);
    return {Iterator(readers.data(), MakeNetlistEdge{cell}),
            Iterator(readers.data() + readers.size(), MakeNetlistEdge{cell})};
}
inline std::uint32_t out_degree(std::uint32_t cell, const NetlistGraph& graph) {
    return static_cast<std::uint32_t>(graph.readers(cell).size());
}
inline std::uint32_t source(NetlistGraph::Edge edge, const NetlistGraph&) {
    return edge.source;
}
inline std::uint32_t target(NetlistGraph::Edge edge, const NetlistGraph&) {
    return edge.target;
}
inline boost::identity_property_map get(boost::vertex_index_t, const NetlistGraph&) {
    return {};
}

}  // namespace grafwire
