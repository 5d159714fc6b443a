#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "ladder/ladder.h"

namespace grafwire::ladder {

/// Wires and contacts between points, from the left rail to one end, as they come out of a drawing;
/// power flows one way. Made into a tree of contacts in series and in parallel.
class PowerGraph {
  public:
    using Point = std::uint32_t;

    Point new_point() { return points_++; }
    /// What lies between two points; `rank` orders parallel branches from top to bottom.
    void add(Point from, Point to, Power power, std::int64_t rank);

    /// The tree of all ways from one point to another; every edge added must lie on one. Where the
    /// drawing is no series-parallel one (a bridge), contacts are written twice; empty where that
    /// makes the tree larger than `limit` contacts.
    std::optional<Power> tree(Point from, Point to, std::size_t limit);

  private:
    struct Edge {
        Point from = 0;
        Point to = 0;
        Power power;
        std::int64_t rank = 0;
        std::size_t size = 1;  ///< contacts
    };
    bool join_parallel();
    bool join_series(Point begin, Point end);
    bool split_one(Point begin, Point end);

    Point points_ = 0;
    std::vector<Edge> edges_;
};

}  // namespace grafwire::ladder
