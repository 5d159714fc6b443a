// Whether there is an order without an end.
//
// Nearly always the states of an instant have no circle, which is seen by taking states away to
// which nothing leads, again and again (A. B. Kahn, "Topological sorting of large networks", 1962).
// In what is left, states that reach each other are a part. A part is an order without an end only
// if it is fair: a transition that could be cleared everywhere in it and never is would be cleared
// by any wiring whose delays are finite.

#include <algorithm>
#include <vector>

#include "orders/order_graph.h"

namespace grafwire {

namespace {

using Nodes = std::vector<OrderNode>;
using Numbers = std::vector<std::size_t>;

template <typename Visit>
void for_each_other(const Nodes& nodes, std::size_t from, const Visit& visit) {
    for (const Way& way : nodes[from].ways) {
        if (way.to != from) visit(way.to);
    }
}

/// The states that lie on circles, or behind one.
Numbers behind_circles(const Nodes& nodes) {
    Numbers leading(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for_each_other(nodes, i, [&](std::size_t to) { ++leading[to]; });
    }
    Numbers free;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (leading[i] == 0) free.push_back(i);
    }
    for (std::size_t i = 0; i < free.size(); ++i) {
        for_each_other(nodes, free[i], [&](std::size_t to) {
            if (--leading[to] == 0) free.push_back(to);
        });
    }
    Numbers rest;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (leading[i] != 0) rest.push_back(i);
    }
    return rest;
}

std::vector<bool> reached_from(const Nodes& nodes, std::size_t index) {
    std::vector<bool> reached(nodes.size());
    Numbers open{index};
    while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        for_each_other(nodes, at, [&](std::size_t to) {
            if (reached[to]) return;
            reached[to] = true;
            open.push_back(to);
        });
    }
    return reached;
}

bool is_within(const Numbers& part, std::size_t index) {
    return std::find(part.begin(), part.end(), index) != part.end();
}

bool is_fair_to(const Nodes& nodes, const Numbers& part, TransitionId id) {
    return std::any_of(part.begin(), part.end(), [&](std::size_t index) {
        const OrderNode& node = nodes[index];
        if (!contains(node.clearable, id)) return true;
        return std::any_of(node.ways.begin(), node.ways.end(), [&](const Way& way) {
            return contains(way.chosen, id) && is_within(part, way.to);
        });
    });
}

}  // namespace

std::vector<std::size_t> endless_part(const std::vector<OrderNode>& nodes) {
    const Numbers rest = behind_circles(nodes);
    std::vector<std::vector<bool>> reached;
    for (const std::size_t index : rest) reached.push_back(reached_from(nodes, index));
    for (std::size_t i = 0; i < rest.size(); ++i) {
        Numbers part;
        for (std::size_t j = 0; j < rest.size(); ++j) {
            if (reached[i][rest[j]] && reached[j][rest[i]]) part.push_back(rest[j]);
        }
        if (part.size() < 2 || part[0] != rest[i]) continue;
        // A transition that is not clearable in the first state is cleared fairly.
        const Transitions& all = nodes[part[0]].clearable;
        const bool is_fair = std::all_of(
            all.begin(), all.end(), [&](TransitionId id) { return is_fair_to(nodes, part, id); });
        if (is_fair) return part;
    }
    return {};
}

}  // namespace grafwire
