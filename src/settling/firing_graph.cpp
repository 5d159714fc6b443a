// The states of a circuit within an instant, and what can never end among them.
//
// Breadth first, so that the way to a state is one of the shortest. Endless runs are the strongly
// connected parts of the graph (strong_parts.h).
// Of these only the fair ones count: a gate takes a finite time, so a run in which it is excited
// from some state on and never fires is none. A strongly connected part holds a fair run exactly if
// each cell fires on one of its edges or is quiet in one of its states, since a run can visit them
// all again and again.
//
// How often a net changes is no matter of the states alone. Where one is watched, the number of its
// changes so far is a part of every state. Only the cell that drives the net touches that number,
// so what a firing of another cell does is what it was, and whatever leaves out orders of firings
// because they lead to the same (stubborn_sets.cpp) may do so with the number as well: the orders
// that it keeps are rearrangements of all others, with the same firings in them.

#include "settling/firing_graph.h"

#include <algorithm>
#include <deque>

#include "settling/strong_parts.h"

namespace grafwire {

std::uint32_t FiringGraph::add(const CircuitState& state, std::uint32_t parent,
                               std::uint32_t firing, std::uint8_t changes) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    std::string encoding = circuit_.encoded(state);
    encoding += static_cast<char>(changes);
    const auto [place, is_new] = numbers_.emplace(std::move(encoding), number);
    if (is_new) nodes_.push_back({&place->first, parent, firing, {}, changes});
    return place->second;
}

FiringGraph::End FiringGraph::build(const CircuitState& start, const Choice& choice,
                                    const Limits& limits, const WatchedNet* watched) {
    like_ = start;
    numbers_.clear();
    nodes_.clear();
    firings_.clear();
    rests_.clear();
    add(start, 0, 0, 0);
    std::vector<Firing> choices;
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
        if (limits.keep_going != nullptr && *limits.keep_going && !(*limits.keep_going)()) {
            return End::broken_off;
        }
        if (nodes_.size() > limits.states) return End::too_large;
        const CircuitState from = state(node);
        if (!choice(from, choices)) return End::too_large;
        if (choices.empty()) rests_.push_back(node);
        for (Firing& firing : choices) {
            CircuitState to = from;
            circuit_.perform(firing, to);
            const auto number = static_cast<std::uint32_t>(firings_.size());
            firings_.push_back(std::move(firing));
            const std::uint8_t changes =
                watched == nullptr ? 0 : watched->count(nodes_[node].changes, from, to);
            const std::uint32_t target = add(to, node, number, changes);
            nodes_[node].edges.push_back({target, number});
            if (watched != nullptr && changes > watched->most) return End::exceeded;
        }
    }
    return End::complete;
}

CircuitState FiringGraph::state(std::uint32_t node) const {
    CircuitState state = like_;
    circuit_.decode(*nodes_[node].encoding, state);
    return state;
}

std::vector<Firing> FiringGraph::way_to(std::uint32_t node) const {
    std::vector<Firing> way;
    for (; node != 0; node = nodes_[node].parent) way.push_back(firings_[nodes_[node].firing]);
    std::reverse(way.begin(), way.end());
    return way;
}

bool FiringGraph::is_fair(const Loop& loop, const std::vector<std::uint32_t>& loop_of) const {
    std::vector<std::uint8_t> fires(circuit_.netlist().cells.size());
    const std::uint32_t number = loop_of[loop.nodes[0]];
    for (const std::uint32_t node : loop.nodes) {
        for (const Edge& edge : nodes_[node].edges) {
            if (loop_of[edge.to] != number) continue;
            for (const CellAction& action : firings_[edge.firing]) fires[action.cell] = 1;
        }
    }
    // Those that never fire, as long as they are excited in every state so far.
    std::vector<std::uint32_t> starved;
    for (const CellAction& action : circuit_.actions(state(loop.nodes[0]))) {
        if (fires[action.cell] == 0) starved.push_back(action.cell);
    }
    for (const std::uint32_t node : loop.nodes) {
        if (starved.empty()) return true;
        const CircuitState here = state(node);
        std::erase_if(starved, [&](std::uint32_t cell) {
            std::vector<CellAction> actions;
            circuit_.append_actions(here, cell, actions);
            return actions.empty();
        });
    }
    return starved.empty();
}

std::vector<FiringGraph::Loop> FiringGraph::loops() const {
    std::vector<std::vector<std::uint32_t>> successors(nodes_.size());
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
        for (const Edge& edge : nodes_[node].edges) successors[node].push_back(edge.to);
    }
    const StrongParts found = strong_parts(successors);
    const std::vector<std::uint32_t>& loop_of = found.of_node;
    std::vector<Loop> parts(found.count);
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
        parts[loop_of[node]].nodes.push_back(node);
    }
    std::erase_if(parts, [&](const Loop& part) {
        const std::uint32_t first = part.nodes[0];
        const auto& edges = nodes_[first].edges;
        return part.nodes.size() == 1 &&
               std::none_of(edges.begin(), edges.end(),
                            [&](const Edge& edge) { return edge.to == first; });
    });
    for (Loop& part : parts) part.is_fair = is_fair(part, loop_of);
    std::sort(parts.begin(), parts.end(),
              [](const Loop& a, const Loop& b) { return a.nodes[0] < b.nodes[0]; });
    return parts;
}

namespace {

std::vector<std::uint8_t> marks(std::size_t size, const std::vector<std::uint32_t>& marked) {
    std::vector<std::uint8_t> result(size);
    for (const std::uint32_t i : marked) result[i] = 1;
    return result;
}

}  // namespace

std::vector<NetId> FiringGraph::changing_in(const Loop& loop) const {
    const std::vector<std::uint8_t> is_in = marks(nodes_.size(), loop.nodes);
    ChangedNets changed(circuit_);
    for (const std::uint32_t node : loop.nodes) {
        for (const Edge& edge : nodes_[node].edges) {
            if (is_in[edge.to] != 0) changed.add(firings_[edge.firing]);
        }
    }
    return changed.take();
}

/// Goes round in a loop, noting which cells still starve: those that have been excited all the way
/// and have not fired.
class FiringGraph::Turn {
  public:
    Turn(const FiringGraph& graph, const Loop& loop)
        : graph_(graph), is_in_(marks(graph.nodes_.size(), loop.nodes)), here_(loop.nodes[0]) {
        for (const CellAction& action : graph.circuit_.actions(graph.state(here_))) {
            starving_.push_back(action.cell);
        }
    }

    std::vector<Firing> make() {
        const std::uint32_t first = here_;
        while (!starving_.empty()) {
            go_until([&](const Edge& edge) { return feeds(edge); });
        }
        if (here_ != first || turn_.empty()) {
            go_until([&](const Edge& edge) { return edge.to == first; });
        }
        return std::move(turn_);
    }

  private:
    bool is_quiet(std::uint32_t cell, std::uint32_t node) const {
        std::vector<CellAction> actions;
        graph_.circuit_.append_actions(graph_.state(node), cell, actions);
        return actions.empty();
    }
    bool fires(std::uint32_t cell, const Edge& edge) const {
        const Firing& firing = graph_.firings_[edge.firing];
        return std::any_of(firing.begin(), firing.end(),
                           [cell](const CellAction& action) { return action.cell == cell; });
    }
    bool feeds(const Edge& edge) const {
        return std::any_of(starving_.begin(), starving_.end(), [&](std::uint32_t cell) {
            return fires(cell, edge) || is_quiet(cell, edge.to);
        });
    }

    /// The shortest way to the end of an edge that will do, within the loop.
    template <typename WillDo>
    void go_until(const WillDo& will_do) {
        struct Step {
            std::uint32_t from = 0;
            Edge edge;
        };
        std::vector<Step> steps;
        std::unordered_map<std::uint32_t, std::size_t> step_to;
        std::deque<std::uint32_t> waiting{here_};
        for (bool found = false; !found;) {
            const std::uint32_t node = waiting.front();
            waiting.pop_front();
            for (const Edge& edge : graph_.nodes_[node].edges) {
                if (is_in_[edge.to] == 0) continue;
                found = will_do(edge);
                const bool is_new = step_to.try_emplace(edge.to, steps.size()).second;
                if (!is_new && !found) continue;
                steps.push_back({node, edge});
                waiting.push_back(edge.to);
                if (found) break;
            }
        }
        std::vector<Edge> way{steps.back().edge};
        for (std::uint32_t node = steps.back().from; node != here_;) {
            const Step& step = steps[step_to.at(node)];
            way.push_back(step.edge);
            node = step.from;
        }
        for (auto edge = way.rbegin(); edge != way.rend(); ++edge) pass(*edge);
    }

    void pass(const Edge& edge) {
        std::erase_if(starving_, [&](std::uint32_t cell) {
            return fires(cell, edge) || is_quiet(cell, edge.to);
        });
        turn_.push_back(graph_.firings_[edge.firing]);
        here_ = edge.to;
    }

    const FiringGraph& graph_;
    const std::vector<std::uint8_t> is_in_;
    std::uint32_t here_;
    std::vector<std::uint32_t> starving_;
    std::vector<Firing> turn_;
};

std::vector<Firing> FiringGraph::turn_of(const Loop& loop) const {
    return Turn(*this, loop).make();
}

}  // namespace grafwire
