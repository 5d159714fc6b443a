#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "ladder/ladder.h"

namespace grafwire::plcopen {

/// Wires and contacts between points, from the left rail to one end, as they come out of a drawing;
/// power flows one way. Made into a tree of contacts in series and in parallel.
class PowerGraph {
  public:
    using Point = std::uint32_t;
    /// Orders parallel branches from top to bottom: the y of what begins a branch, then its x.
    using Rank = std::pair<int, int>;

    Point new_point() { return points_++; }
    /// What lies between two points.
    void add(Point from, Point to, ladder::Power power, Rank rank);

    /// The tree of all ways from one point to another; every edge added must lie on one. Where the
    /// drawing is no series-parallel one (a bridge), contacts are written twice; empty where that
    /// makes the tree larger than `limit` contacts.
    std::optional<ladder::Power> tree(Point from, Point to, std::size_t limit);

  private:
    struct Edge {
        Point from = 0;
        Point to = 0;
        ladder::Power power;
        Rank rank;
        std::size_t size = 1;  ///< contacts
    };
    bool join_parallel();
    bool join_series(Point begin, Point end);
    bool split_one(Point begin, Point end);

    Point points_ = 0;
    std::vector<Edge> edges_;
};

}  // namespace grafwire::plcopen
