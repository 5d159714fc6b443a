// The hierarchy of graphs. Graph A stands over graph B if a step of A (those of its expansions
// included) gives a forcing order to B or encloses B; a graph must not come to stand over itself.
// Freezing orders (`G1{*}`) are no forcing: they leave the situation of the graph alone, so they
// make no circle.
//
// The strongly connected components of this relation hold all its circles (R. Tarjan, "Depth-first
// search and linear graph algorithms", 1972; here without recursion). In each component of several
// graphs a shortest circle through its first graph is found breadth-first and reported; a graph
// that stands over itself directly is reported on its own.
//
// A graph is enclosed by one step at most; if that step is initial the graph starts with it, and so
// needs an initial step, and if it is not the graph must have none.

#include <algorithm>

#include "grafcet/checking.h"
#include "grafcet/messages.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// A step of one graph forces or encloses another.
struct Edge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t step = 0;
    bool is_enclosure = false;
    Location where;
};

/// The edges sorted by origin, and where those of each block begin.
struct Hierarchy {
    std::vector<Edge> edges;
    std::vector<std::size_t> first;
};

/// All forcing orders and enclosures whose graphs are known; freezing makes no hierarchy.
Hierarchy hierarchy_of(const Draft& draft) {
    Hierarchy result;
    for (std::uint32_t i = 0; i < draft.nodes.size(); ++i) {
        const DraftNode& node = draft.nodes[i];
        const std::uint32_t from = draft.blocks[node.block].root;
        if (from == none) continue;
        if (!node.is_macro && node.extra != none) {
            const DraftEnclosure& enclosure = draft.enclosures[node.extra];
            if (enclosure.resolved != none) {
                result.edges.push_back({from, enclosure.resolved, i, true, enclosure.graph.where});
            }
        }
        for (const std::uint32_t j : draft.actions_of_node.of(i)) {
            const DraftAction& action = draft.actions[j];
            if (action.kind == ActionKind::order && action.resolved != none &&
                action.order != OrderKind::freeze) {
                result.edges.push_back({from, action.resolved, i, false, action.where});
            }
        }
    }
    std::stable_sort(result.edges.begin(), result.edges.end(),
                     [](const Edge& a, const Edge& b) { return a.from < b.from; });
    result.first.assign(draft.blocks.size() + 1, 0);
    for (const Edge& edge : result.edges) ++result.first[edge.from + 1];
    for (std::size_t i = 1; i < result.first.size(); ++i) result.first[i] += result.first[i - 1];
    return result;
}

/// The component of each block.
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
                if (number[to] == none) {
                    path.push_back(to);
                } else if (component[to] == none) {
                    low[block] = std::min(low[block], number[to]);
                }
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

/// The edges of a shortest circle through `start` within its component of several blocks.
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

/// A graph that forces or encloses itself.
void report_self(const Checking& checking, const Edge& edge) {
    const auto& message = edge.is_enclosure ? say::encloses_its_graph : say::forces_its_graph;
    checking.error(code::forcing_circle, edge.where,
                   message(checking.shown_node(edge.step),
                           checking.shown(checking.draft.blocks[edge.from].name)));
}

/// At the first edge, with a note at each of the others.
void report_circle(const Checking& checking, const std::vector<const Edge*>& circle) {
    const auto name = [&](std::uint32_t block) {
        return checking.shown(checking.draft.blocks[block].name);
    };
    std::vector<Localized> parts;
    for (const Edge* edge : circle) {
        const auto& part = edge->is_enclosure ? say::encloses : say::forces;
        parts.push_back(part(name(edge->from), name(edge->to)));
    }
    Diagnostic& error = checking.error(code::forcing_circle, circle.front()->where,
                                       say::circle_of_graphs(joined(parts, ", ")));
    for (std::size_t i = 1; i < circle.size(); ++i) {
        const Edge& edge = *circle[i];
        const auto& part = edge.is_enclosure ? say::encloses_here : say::forces_here;
        error.notes.push_back(
            {edge.where, part(checking.shown_node(edge.step), name(edge.from), name(edge.to))});
    }
}

/// For each block of a graph the step that encloses it first, or none.
std::vector<std::uint32_t> enclosing_steps(const Checking& checking) {
    const Draft& draft = checking.draft;
    std::vector<std::uint32_t> result(draft.blocks.size(), none);
    for (std::uint32_t i = 0; i < draft.nodes.size(); ++i) {
        const DraftNode& node = draft.nodes[i];
        if (node.is_macro || node.extra == none) continue;
        const DraftEnclosure& enclosure = draft.enclosures[node.extra];
        if (enclosure.resolved == none) continue;
        std::uint32_t& first = result[enclosure.resolved];
        if (first == none) {
            first = i;
            continue;
        }
        checking
            .error(code::enclosed_twice, enclosure.graph.where,
                   say::enclosed_twice(checking.shown_block(enclosure.resolved),
                                       checking.shown_node(first)))
            .notes.push_back({draft.nodes[first].name.where, say::first_enclosed_here()});
    }
    return result;
}

/// At an initial step in a graph that is enclosed by a step that is not.
void report_initial_mismatch(const Checking& checking, std::uint32_t node, std::uint32_t graph,
                             std::uint32_t enclosing) {
    const Draft& draft = checking.draft;
    checking
        .error(code::enclosure_initial_mismatch, draft.nodes[node].name.where,
               say::initial_in_enclosed(checking.shown_node(node), checking.shown_node(enclosing),
                                        checking.shown(draft.blocks[graph].name)))
        .notes.push_back({draft.nodes[enclosing].name.where, say::enclosing_step_here()});
}

}  // namespace

void check_enclosures(const Checking& checking) {
    const Draft& draft = checking.draft;
    const std::vector<std::uint32_t> enclosing = enclosing_steps(checking);
    std::vector<bool> has_initial(draft.blocks.size(), false);
    for (std::uint32_t i = 0; i < draft.nodes.size(); ++i) {
        const std::uint32_t graph = draft.blocks[draft.nodes[i].block].root;
        if (!draft.nodes[i].initial || graph == none) continue;
        has_initial[graph] = true;
        const std::uint32_t step = enclosing[graph];
        if (step != none && !draft.nodes[step].initial) {
            report_initial_mismatch(checking, i, graph, step);
        }
    }
    for (std::uint32_t graph = 0; graph < draft.blocks.size(); ++graph) {
        const std::uint32_t step = enclosing[graph];
        if (step == none || !draft.nodes[step].initial || has_initial[graph]) continue;
        checking
            .error(code::enclosure_initial_mismatch, draft.nodes[step].name.where,
                   say::initial_encloses(checking.shown_node(step), checking.shown_block(graph)))
            .notes.push_back({draft.blocks[graph].name.where, say::enclosed_graph_here()});
    }
}

void check_circles(const Checking& checking) {
    const auto block_count = static_cast<std::uint32_t>(checking.draft.blocks.size());
    const Hierarchy hierarchy = hierarchy_of(checking.draft);
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
