// Breadth-first over all states, which are kept in a hash table, with the edges between them. A
// netlist may oscillate where the states hold a strongly connected part in which every gate that is
// excited somewhere is at rest, or fires, somewhere else in it: then the part can be gone through
// for ever without any gate waiting for ever. Most explorations have no cycle at all, which a
// topological sort sees.

#include "delays/gate_orders.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <unordered_map>

namespace grafwire::testing {

std::size_t NetValues::hash() const {
    std::uint64_t hash = 0x9e3779b97f4a7c15U;
    for (const std::uint64_t word : words) {
        hash = (hash ^ word) * 0xff51afd7ed558ccdU;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
}

namespace {

struct HashOfValues {
    std::size_t operator()(const NetValues& values) const { return values.hash(); }
};

/// The states of one exploration and the firings between them.
struct Graph {
    struct Edge {
        std::uint32_t to = 0;
        std::vector<std::uint32_t> fired;
    };
    std::vector<NetValues> states;
    std::vector<std::vector<Edge>> edges;
};

/// The states that lie on cycles or between them.
std::vector<std::uint32_t> cyclic_part(const Graph& graph) {
    std::vector<std::uint32_t> incoming(graph.states.size(), 0);
    for (const auto& edges : graph.edges) {
        for (const Graph::Edge& edge : edges) ++incoming[edge.to];
    }
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < incoming.size(); ++i) {
        if (incoming[i] == 0) open.push_back(i);
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
        for (const Graph::Edge& edge : graph.edges[open[i]]) {
            if (--incoming[edge.to] == 0) open.push_back(edge.to);
        }
    }
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < incoming.size(); ++i) {
        if (incoming[i] != 0) left.push_back(i);
    }
    return left;
}

/// The strongly connected parts of a graph, after Tarjan, without recursion.
class StrongParts {
  public:
    explicit StrongParts(const Graph& graph)
        : graph_(graph),
          order_(graph.states.size(), 0),
          low_(graph.states.size(), 0),
          part_(graph.states.size(), 0) {}

    /// Per state the number of its part, for all states that those given lead to.
    const std::vector<std::uint32_t>& find(const std::vector<std::uint32_t>& from) {
        for (const std::uint32_t state : from) {
            if (order_[state] == 0) visit(state);
        }
        return part_;
    }

  private:
    struct Frame {
        std::uint32_t state = 0;
        std::size_t next = 0;
    };

    void enter(std::uint32_t state) {
        order_[state] = low_[state] = ++last_;
        stack_.push_back(state);
        frames_.push_back({state, 0});
    }

    void visit(std::uint32_t root) {
        enter(root);
        while (!frames_.empty()) {
            const std::uint32_t state = frames_.back().state;
            const auto& edges = graph_.edges[state];
            if (frames_.back().next < edges.size()) {
                const std::uint32_t to = edges[frames_.back().next++].to;
                if (order_[to] == 0) {
                    enter(to);
                } else if (part_[to] == 0) {
                    low_[state] = std::min(low_[state], order_[to]);
                }
                continue;
            }
            frames_.pop_back();
            if (!frames_.empty()) {
                std::uint32_t& low = low_[frames_.back().state];
                low = std::min(low, low_[state]);
            }
            if (low_[state] == order_[state]) close(state);
        }
    }

    void close(std::uint32_t state) {
        ++parts_;
        for (std::uint32_t top = no_state; top != state;) {
            top = stack_.back();
            stack_.pop_back();
            part_[top] = parts_;
        }
    }

    static constexpr std::uint32_t no_state = 0xffffffffU;
    const Graph& graph_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> low_;
    std::vector<std::uint32_t> part_;
    std::vector<std::uint32_t> stack_;
    std::vector<Frame> frames_;
    std::uint32_t last_ = 0;
    std::uint32_t parts_ = 0;
};

}  // namespace

std::string GateOrders::why_not(const Netlist& netlist) {
    if (netlist.net_count() > NetValues::most_nets) return "too many nets";
    for (const Cell& cell : netlist.cells) {
        const CellTypeRow& row = row_of(cell.type);
        if (cell.type == CellType::timer) {
            if (netlist.timings[cell.timing].fall != 0) return "a timer with an off-delay";
        } else if (row.has_memory || row.has_timing || row.is_clocked) {
            return "a cell of type " + std::string(row.name);
        }
    }
    return {};
}

GateOrders::GateOrders(const Netlist& netlist) : netlist_(netlist) {
    for (const Cell& cell : netlist.cells) {
        Gate gate;
        gate.type = cell.type;
        const bool waits = cell.type == CellType::timer && netlist.timings[cell.timing].rise != 0;
        if (cell.type == CellType::timer && !waits) gate.type = CellType::buffer;
        gate.output = cell.output;
        for (const NetId net : netlist.pins_of(cell)) {
            gate.pin_nets.push_back(net);
            const std::size_t word = index_of(net) / 64;
            const auto same = std::find_if(gate.pins.begin(), gate.pins.end(),
                                           [&](const auto& pin) { return pin.first == word; });
            const std::uint64_t bit = std::uint64_t{1} << (index_of(net) % 64);
            if (same == gate.pins.end()) {
                gate.pins.emplace_back(word, bit);
            } else {
                same->second |= bit;
            }
        }
        if (waits) {
            timers_.push_back(
                {gate.pin_nets[0], gate.output, netlist.timings[cell.timing].ordinal});
        }
        gates_.push_back(std::move(gate));
    }
}

bool GateOrders::wanted(const Gate& gate, const NetValues& values) const {
    bool all = true;
    bool any = false;
    for (const auto& [word, mask] : gate.pins) {
        all &= (values.words[word] & mask) == mask;
        any |= (values.words[word] & mask) != 0;
    }
    switch (gate.type) {
        case CellType::low:
            return false;
        case CellType::high:
            return true;
        case CellType::and_gate:
        case CellType::buffer:
            return all;
        case CellType::nand_gate:
        case CellType::inverter:
            return !all;
        case CellType::or_gate:
            return any;
        case CellType::nor_gate:
            return !any;
        case CellType::timer:
            return all && values.get(gate.output);
        default:
            break;
    }
    bool odd = false;
    for (const NetId net : gate.pin_nets) odd ^= values.get(net);
    return odd;
}

std::vector<std::uint32_t> GateOrders::excited(const NetValues& values) const {
    std::vector<std::uint32_t> gates;
    for (std::uint32_t i = 0; i < gates_.size(); ++i) {
        if (wanted(gates_[i], values) != values.get(gates_[i].output)) gates.push_back(i);
    }
    return gates;
}

namespace {

/// Whether a strongly connected part can be gone through for ever: no gate is excited in all of its
/// states without ever firing in it.
bool can_last(const Graph& graph, const std::vector<std::uint32_t>& part_of,
              const std::vector<std::uint32_t>& states, std::uint32_t part) {
    std::optional<std::vector<std::uint32_t>> waiting;
    std::vector<std::uint32_t> fired;
    bool has_edge = false;
    for (const std::uint32_t state : states) {
        std::vector<std::uint32_t> excited;
        for (const Graph::Edge& edge : graph.edges[state]) {
            excited.insert(excited.end(), edge.fired.begin(), edge.fired.end());
            if (part_of[edge.to] != part) continue;
            has_edge = true;
            fired.insert(fired.end(), edge.fired.begin(), edge.fired.end());
        }
        std::sort(excited.begin(), excited.end());
        if (!waiting) {
            waiting = excited;
            continue;
        }
        std::erase_if(*waiting, [&](std::uint32_t gate) {
            return !std::binary_search(excited.begin(), excited.end(), gate);
        });
    }
    if (!has_edge) return false;
    return std::all_of(waiting->begin(), waiting->end(), [&](std::uint32_t gate) {
        return std::find(fired.begin(), fired.end(), gate) != fired.end();
    });
}

bool may_oscillate(const Graph& graph) {
    const std::vector<std::uint32_t> cyclic = cyclic_part(graph);
    if (cyclic.empty()) return false;
    StrongParts parts(graph);
    const std::vector<std::uint32_t>& part_of = parts.find(cyclic);
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> states;
    for (const std::uint32_t state : cyclic) states[part_of[state]].push_back(state);
    for (const auto& [part, members] : states) {
        if (can_last(graph, part_of, members, part)) return true;
    }
    return false;
}

/// The sets of gates that may fire together.
std::vector<std::vector<std::uint32_t>> firings(const std::vector<std::uint32_t>& excited,
                                                Firing firing) {
    std::vector<std::vector<std::uint32_t>> sets;
    if (firing == Firing::one_gate) {
        for (const std::uint32_t gate : excited) sets.push_back({gate});
        return sets;
    }
    for (std::uint64_t subset = 1; subset < std::uint64_t{1} << excited.size(); ++subset) {
        sets.emplace_back();
        for (std::uint64_t rest = subset; rest != 0; rest &= rest - 1) {
            sets.back().push_back(excited[static_cast<std::size_t>(std::countr_zero(rest))]);
        }
    }
    return sets;
}

}  // namespace

GateOrders::Outcomes GateOrders::outcomes(const NetValues& start, Firing firing,
                                          std::size_t most_states) const {
    Outcomes result;
    Graph graph;
    std::unordered_map<NetValues, std::uint32_t, HashOfValues> numbers;
    const auto number_of = [&](const NetValues& values) {
        const auto [at, is_new] =
            numbers.emplace(values, static_cast<std::uint32_t>(graph.states.size()));
        if (is_new) graph.states.push_back(values);
        return at->second;
    };
    number_of(start);
    for (std::size_t i = 0; i < graph.states.size(); ++i) {
        if (graph.states.size() > most_states) {
            result.is_complete = false;
            break;
        }
        const NetValues state = graph.states[i];
        const std::vector<std::uint32_t> open = excited(state);
        if (open.empty()) result.stable.push_back(state);
        graph.edges.emplace_back();
        for (std::vector<std::uint32_t>& fired : firings(open, firing)) {
            NetValues next = state;
            for (const std::uint32_t gate : fired) {
                next.set(gates_[gate].output, !state.get(gates_[gate].output));
            }
            const std::uint32_t to = number_of(next);
            graph.edges[i].push_back({to, std::move(fired)});
        }
    }
    result.states = graph.states.size();
    if (result.is_complete) result.may_oscillate = may_oscillate(graph);
    return result;
}

// A gate whose output follows from the nets known so far is known itself: AND of a 0, for example.
NetValues GateOrders::power_up(const NetValues& inputs, std::vector<NetId>& unknown) const {
    NetValues zeros = inputs;  // the unknown nets at 0, and at 1
    NetValues ones = inputs;
    std::vector<bool> known(netlist_.net_count(), false);
    for (const Port& port : netlist_.inputs) known[index_of(port.net)] = true;
    for (const Netlist::InitialValue& initial : netlist_.initial_values) {
        known[index_of(initial.net)] = true;
        zeros.set(initial.net, initial.value);
        ones.set(initial.net, initial.value);
    }
    for (const Timer& timer : timers_) known[index_of(timer.output)] = true;
    for (const Gate& gate : gates_) {
        if (!known[index_of(gate.output)]) ones.set(gate.output, true);
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (const Gate& gate : gates_) {
            const bool value = wanted(gate, zeros);
            if (known[index_of(gate.output)] || gate.type == CellType::xor_gate ||
                value != wanted(gate, ones)) {
                continue;
            }
            known[index_of(gate.output)] = changed = true;
            zeros.set(gate.output, value);
            ones.set(gate.output, value);
        }
    }
    for (const Gate& gate : gates_) {
        if (!known[index_of(gate.output)]) unknown.push_back(gate.output);
    }
    return zeros;
}

}  // namespace grafwire::testing
