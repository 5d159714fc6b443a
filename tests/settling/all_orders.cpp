#include "all_orders.h"

#include <algorithm>
#include <map>

namespace grafwire::testing {

namespace {

bool asked(const Netlist& netlist, const Cell& cell, const Bits& values) {
    std::size_t ones = 0;
    const auto pins = netlist.pins_of(cell);
    for (const NetId pin : pins) ones += values[index_of(pin)];
    switch (cell.type) {
        case CellType::and_gate:
            return ones == pins.size();
        case CellType::nand_gate:
            return ones != pins.size();
        case CellType::nor_gate:
        case CellType::inverter:
            return ones == 0;
        case CellType::xor_gate:
            return ones % 2 == 1;
        case CellType::latch:
            return values[index_of(pins[0])] != 0 ||
                   (values[index_of(pins[1])] == 0 && values[index_of(cell.output)] != 0);
        default:
            return ones != 0;
    }
}

std::vector<NetId> excited_in(const Netlist& netlist, const Bits& values) {
    std::vector<NetId> excited;
    for (const Cell& cell : netlist.cells) {
        if (asked(netlist, cell, values) != (values[index_of(cell.output)] != 0)) {
            excited.push_back(cell.output);
        }
    }
    return excited;
}

/// All states that can be reached, each with its successors.
using Graph = std::map<Bits, std::set<Bits>>;

Graph graph_from(const Netlist& netlist, const Bits& start) {
    Graph graph;
    std::vector<Bits> waiting{start};
    while (!waiting.empty()) {
        const Bits state = waiting.back();
        waiting.pop_back();
        if (graph.contains(state)) continue;
        std::set<Bits>& next = graph[state];
        const std::vector<NetId> excited = excited_in(netlist, state);
        for (std::uint32_t chosen = 1; chosen < 1U << excited.size(); ++chosen) {
            Bits after = state;
            for (std::size_t i = 0; i < excited.size(); ++i) {
                if ((chosen >> i & 1U) != 0) after[index_of(excited[i])] ^= 1U;
            }
            next.insert(after);
            waiting.push_back(after);
        }
    }
    return graph;
}

std::set<Bits> reached_from(const Graph& graph, const Bits& state) {
    std::set<Bits> reached;
    std::vector<Bits> waiting{state};
    while (!waiting.empty()) {
        const Bits at = waiting.back();
        waiting.pop_back();
        for (const Bits& next : graph.at(at)) {
            if (reached.insert(next).second) waiting.push_back(next);
        }
    }
    return reached;
}

/// Whether a run can stay among the states that a state reaches and that reach it, with every gate
/// that is excited in all of them firing.
bool has_fair_circle(const Netlist& netlist, const Graph& graph, const Bits& state) {
    std::set<Bits> circle;
    for (const Bits& other : reached_from(graph, state)) {
        if (reached_from(graph, other).contains(state)) circle.insert(other);
    }
    if (circle.empty()) return false;
    std::vector<NetId> starving = excited_in(netlist, state);
    for (const Bits& at : circle) {
        const std::vector<NetId> excited = excited_in(netlist, at);
        std::erase_if(starving, [&](NetId net) {
            const bool is_quiet = std::find(excited.begin(), excited.end(), net) == excited.end();
            const auto& next = graph.at(at);
            const bool fires = std::any_of(next.begin(), next.end(), [&](const Bits& after) {
                return circle.contains(after) && after[index_of(net)] != at[index_of(net)];
            });
            return is_quiet || fires;
        });
    }
    return starving.empty();
}

}  // namespace

Outcomes outcomes_by_definition(const Netlist& netlist, const Bits& start) {
    const Graph graph = graph_from(netlist, start);
    Outcomes outcomes;
    for (const auto& [state, next] : graph) {
        if (next.empty()) outcomes.rests.insert(state);
    }
    outcomes.can_go_on_for_ever = std::any_of(graph.begin(), graph.end(), [&](const auto& item) {
        return has_fair_circle(netlist, graph, item.first);
    });
    return outcomes;
}

unsigned changes_by_definition(const Netlist& netlist, const Bits& start, NetId net,
                               unsigned most) {
    const Graph graph = graph_from(netlist, start);
    std::map<Bits, std::set<unsigned>> seen;
    std::vector<std::pair<Bits, unsigned>> waiting{{start, 0}};
    unsigned greatest = 0;
    while (!waiting.empty()) {
        const auto [state, changes] = waiting.back();
        waiting.pop_back();
        if (!seen[state].insert(changes).second) continue;
        greatest = std::max(greatest, changes);
        if (greatest == most) break;
        for (const Bits& next : graph.at(state)) {
            const bool is_changed = next[index_of(net)] != state[index_of(net)];
            waiting.emplace_back(next, changes + (is_changed ? 1 : 0));
        }
    }
    return greatest;
}

}  // namespace grafwire::testing
