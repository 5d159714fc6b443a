// The hierarchy of graphs. Graph A stands over graph B if a step of A (those of its expansions
// included) gives a forcing order to B or encloses B; a graph must not come to stand over itself.
// Freezing orders (`G1{*}`) are no forcing: they leave the situation of the graph alone, so they
// make no circle.
//
// The strongly connected components of this relation hold all its circles (R. Tarjan, "Depth-first
// search and linear graph algorithms", 1972; here without recursion). In each component of several
// graphs a shortest circle through its first graph is found breadth-first and reported; a graph
// that stands over itself directly is reported on its own.

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/names.h"

namespace grafwire {

namespace {

struct Edge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t step = 0;
    bool is_enclosure = false;
    Location where;
};

// The edges sorted by origin, and where those of each block begin.
struct Hierarchy {
    std::vector<Edge> edges;
    std::vector<std::size_t> first;
};

Hierarchy hierarchy_of(const Syntax& syntax) {
    Hierarchy result;
    for (std::uint32_t i = 0; i < syntax.nodes.size(); ++i) {
        const NodeSyntax& node = syntax.nodes[i];
        const std::uint32_t from = syntax.blocks[node.block].root;
        if (from == none) continue;
        if (node.kind != NodeKind::macro && node.extra != none) {
            const EnclosureSyntax& enclosure = syntax.enclosures[node.extra];
            if (enclosure.resolved != none)
                result.edges.push_back({from, enclosure.resolved, i, true, enclosure.graph.where});
        }
        for (std::uint32_t j = 0; j < node.actions.count; ++j) {
            const ActionSyntax& action = syntax.actions[node.actions.first + j];
            if (action.kind == ActionKind::order && action.resolved != none &&
                action.order != OrderKind::freeze)
                result.edges.push_back({from, action.resolved, i, false, action.where});
        }
    }
    std::stable_sort(result.edges.begin(), result.edges.end(),
                     [](const Edge& a, const Edge& b) { return a.from < b.from; });
    result.first.assign(syntax.blocks.size() + 1, 0);
    for (const Edge& edge : result.edges) ++result.first[edge.from + 1];
    for (std::size_t i = 1; i < result.first.size(); ++i) result.first[i] += result.first[i - 1];
    return result;
}

// The component of each block.
std::vector<std::uint32_t> components_of(const Hierarchy& hierarchy, std::uint32_t block_count) {
    std::vector<std::uint32_t> component(block_count, none);
    std::vector<std::uint32_t> number(block_count, none);
    std::vector<std::uint32_t> low(block_count, 0);
    std::vector<std::size_t> next(hierarchy.first.begin(), hierarchy.first.end() - 1);
    std::vector<std::uint32_t> open;
    std::vector<std::uint32_t> path;
    std::uint32_t visited = 0;
    std::uint32_t components = 0;
    for (std::uint32_t start = 0; start < block_count; ++start) {
        if (number[start] != none) continue;
        path.push_back(start);
        while (!path.empty()) {
            const std::uint32_t block = path.back();
            if (number[block] == none) {
                number[block] = low[block] = visited++;
                open.push_back(block);
            }
            if (next[block] < hierarchy.first[block + 1]) {
                const std::uint32_t to = hierarchy.edges[next[block]++].to;
                if (number[to] == none)
                    path.push_back(to);
                else if (component[to] == none)
                    low[block] = std::min(low[block], number[to]);
                continue;
            }
            path.pop_back();
            if (!path.empty()) low[path.back()] = std::min(low[path.back()], low[block]);
            if (low[block] != number[block]) continue;
            while (component[block] == none) {
                component[open.back()] = components;
                open.pop_back();
            }
            ++components;
        }
    }
    return component;
}

// The edges of a shortest circle through `start` within its component of several blocks.
std::vector<const Edge*> circle_through(std::uint32_t start, const Hierarchy& hierarchy,
                                        const std::vector<std::uint32_t>& component,
                                        std::vector<const Edge*>& reached_by) {
    std::vector<std::uint32_t> queue = {start};
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const std::uint32_t block = queue[head];
        for (std::size_t i = hierarchy.first[block]; i < hierarchy.first[block + 1]; ++i) {
            const Edge& edge = hierarchy.edges[i];
            if (component[edge.to] != component[start] || edge.to == block) continue;
            if (reached_by[edge.to] != nullptr) continue;
            reached_by[edge.to] = &edge;
            if (edge.to != start) {
                queue.push_back(edge.to);
                continue;
            }
            std::vector<const Edge*> circle = {&edge};
            while (circle.back()->from != start) circle.push_back(reached_by[circle.back()->from]);
            std::reverse(circle.begin(), circle.end());
            return circle;
        }
    }
    return {};
}

void report_self(const Checking& checking, const Edge& edge) {
    checking.error(
        Code::forcing_circle, edge.where,
        fmt::format("{} {} its own {}; only another graph can be forced or enclosed",
                    checking.shown_node(edge.step), edge.is_enclosure ? "encloses" : "forces",
                    checking.shown_block(edge.from)));
}

void report_circle(const Checking& checking, const std::vector<const Edge*>& circle) {
    const auto verb = [](const Edge& edge) { return edge.is_enclosure ? "encloses" : "forces"; };
    const auto name = [&](std::uint32_t block) {
        return checking.shown(checking.syntax.blocks[block].name);
    };
    std::string message = "graphs force or enclose one another in a circle: ";
    for (const Edge* edge : circle)
        message += fmt::format("{}{} {} {}", edge == circle.front() ? "" : ", ", name(edge->from),
                               verb(*edge), name(edge->to));
    Diagnostic& error = checking.error(Code::forcing_circle, circle.front()->where,
                                       message + "; break the circle at one place");
    for (std::size_t i = 1; i < circle.size(); ++i)
        error.notes.push_back(
            {circle[i]->where,
             fmt::format("{} of {} {} {} here", checking.shown_node(circle[i]->step),
                         name(circle[i]->from), verb(*circle[i]), name(circle[i]->to))});
}

}  // namespace

void check_circles(const Checking& checking) {
    const auto block_count = static_cast<std::uint32_t>(checking.syntax.blocks.size());
    const Hierarchy hierarchy = hierarchy_of(checking.syntax);
    std::vector<bool> reported(block_count, false);
    for (const Edge& edge : hierarchy.edges) {
        if (edge.from != edge.to || reported[edge.from]) continue;
        reported[edge.from] = true;
        report_self(checking, edge);
    }
    const std::vector<std::uint32_t> component = components_of(hierarchy, block_count);
    std::vector<bool> done(block_count, false);
    std::vector<const Edge*> reached_by(block_count, nullptr);
    for (std::uint32_t block = 0; block < block_count; ++block) {
        if (done[component[block]]) continue;
        done[component[block]] = true;
        const auto circle = circle_through(block, hierarchy, component, reached_by);
        if (!circle.empty()) report_circle(checking, circle);
    }
}

}  // namespace grafwire
