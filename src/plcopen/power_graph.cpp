// A drawn network becomes a tree by series-parallel reduction (Duffin, "Topology of series-parallel
// networks", 1965): two edges between the same points become one in parallel, two edges that meet
// in a point of their own become one in series, until a single edge is left. A network that does
// not come down to one edge has a bridge; one of its points is then taken apart, which writes the
// edge into (or out of) it twice and leaves what the network computes as it is.

#include "plcopen/power_graph.h"

#include <algorithm>

namespace grafwire::plcopen {

void PowerGraph::add(Point from, Point to, ladder::Power power, Rank rank) {
    edges_.push_back({from, to, std::move(power), rank, 1});
}

bool PowerGraph::join_parallel() {
    std::stable_sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.from, a.to, a.rank) < std::tie(b.from, b.to, b.rank);
    });
    std::vector<Edge> joined;
    bool any = false;
    for (std::size_t at = 0; at < edges_.size();) {
        Edge edge = std::move(edges_[at]);
        std::vector<ladder::Power> branches;
        branches.push_back(std::move(edge.power));
        for (++at; at < edges_.size() && edges_[at].from == edge.from && edges_[at].to == edge.to;
             ++at) {
            branches.push_back(std::move(edges_[at].power));
            edge.size += edges_[at].size;
            any = true;
        }
        edge.power = parallel(std::move(branches));
        joined.push_back(std::move(edge));
    }
    edges_ = std::move(joined);
    return any;
}

bool PowerGraph::join_series(Point begin, Point end) {
    constexpr std::size_t several = static_cast<std::size_t>(-1);
    constexpr std::size_t no_edge = static_cast<std::size_t>(-2);
    std::vector<std::size_t> into(points_, no_edge);
    std::vector<std::size_t> out_of(points_, no_edge);
    const auto count = [&](std::size_t& slot, std::size_t edge) {
        slot = slot == no_edge ? edge : several;
    };
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        count(out_of[edges_[e].from], e);
        count(into[edges_[e].to], e);
    }
    std::vector<bool> gone(edges_.size(), false);
    bool any = false;
    for (Point point = 0; point < points_; ++point) {
        const std::size_t first = into[point];
        const std::size_t second = out_of[point];
        if (point == begin || point == end || first >= edges_.size() || second >= edges_.size()) {
            continue;
        }
        std::vector<ladder::Power> both;
        both.push_back(std::move(edges_[first].power));
        both.push_back(std::move(edges_[second].power));
        edges_[first].power = series(std::move(both));
        edges_[first].to = edges_[second].to;
        edges_[first].rank = std::min(edges_[first].rank, edges_[second].rank);
        edges_[first].size += edges_[second].size;
        gone[second] = true;
        if (into[edges_[first].to] == second) into[edges_[first].to] = first;
        any = true;
    }
    std::vector<Edge> left;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (!gone[e]) left.push_back(std::move(edges_[e]));
    }
    edges_ = std::move(left);
    return any;
}

/// Takes the point apart that costs the fewest contacts.
bool PowerGraph::split_one(Point begin, Point end) {
    struct Degree {
        std::size_t in = 0;
        std::size_t out = 0;
        std::size_t size_in = 0;
        std::size_t size_out = 0;
    };
    std::vector<Degree> degrees(points_);
    for (const Edge& edge : edges_) {
        ++degrees[edge.from].out;
        degrees[edge.from].size_out += edge.size;
        ++degrees[edge.to].in;
        degrees[edge.to].size_in += edge.size;
    }
    std::optional<Point> best;
    std::size_t best_cost = 0;
    for (Point point = 0; point < points_; ++point) {
        const Degree& degree = degrees[point];
        if (point == begin || point == end || degree.in == 0 || degree.out == 0) continue;
        const std::size_t cost = degree.size_in * degree.out + degree.size_out * degree.in;
        if (!best || cost < best_cost) {
            best = point;
            best_cost = cost;
        }
    }
    if (!best) return false;
    std::vector<Edge> left;
    std::vector<Edge> in;
    std::vector<Edge> out;
    for (Edge& edge : edges_) {
        (edge.to == *best ? in : edge.from == *best ? out : left).push_back(std::move(edge));
    }
    for (const Edge& a : in) {
        for (const Edge& b : out) {
            std::vector<ladder::Power> both{a.power, b.power};
            left.push_back(
                {a.from, b.to, series(std::move(both)), std::min(a.rank, b.rank), a.size + b.size});
        }
    }
    edges_ = std::move(left);
    return true;
}

std::optional<ladder::Power> PowerGraph::tree(Point from, Point to, std::size_t limit) {
    while (edges_.size() > 1) {
        const bool joined = join_parallel();
        if (join_series(from, to) || joined) continue;
        if (!split_one(from, to)) return std::nullopt;
        std::size_t size = 0;
        for (const Edge& edge : edges_) size += edge.size;
        if (size > limit) return std::nullopt;
    }
    if (edges_.empty() || edges_.front().from != from || edges_.front().to != to) {
        return std::nullopt;
    }
    ladder::Power whole = std::move(edges_.front().power);
    return whole;
}

}  // namespace grafwire::plcopen
