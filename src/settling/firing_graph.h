#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "settling/circuit.h"
#include "settling/settling_model.h"
#include "text/keep_going.h"

namespace grafwire {

/// The states that a circuit can pass through within an instant, and the firings between them.
class FiringGraph {
  public:
    /// Gives the firings to follow from a state; false where there are too many.
    using Choice = std::function<bool(const CircuitState&, std::vector<Firing>&)>;
    struct Limits {
        std::size_t states = 0;
        const KeepGoing* keep_going = nullptr;
    };
    enum class End : std::uint8_t {
        complete,
        too_large,
        broken_off,
        exceeded,  ///< a net that is watched has changed too often
    };

    explicit FiringGraph(const Circuit& circuit) : circuit_(circuit) {}

    /// Breadth first, from a state until there are no new ones. With a net that is watched, states
    /// also differ in how often it has changed, and the first in which that is too often is the
    /// last.
    End build(const CircuitState& start, const Choice& choice, const Limits& limits,
              const WatchedNet* watched = nullptr);

    std::size_t state_count() const { return nodes_.size(); }
    /// The states in which nothing more happens.
    const std::vector<std::uint32_t>& rests() const { return rests_; }
    CircuitState state(std::uint32_t node) const;
    /// The shortest way to a state from the start.
    std::vector<Firing> way_to(std::uint32_t node) const;

    /// States among which the circuit can go round for ever.
    struct Loop {
        std::vector<std::uint32_t> nodes;  ///< a strongly connected part, with at least one edge
        /// Every cell either fires in it or is quiet in some state of it: the circuit need never
        /// leave.
        bool is_fair = false;
    };
    std::vector<Loop> loops() const;
    /// The nets that change within a loop, in order.
    std::vector<NetId> changing_in(const Loop& loop) const;
    /// A way round within a fair loop in which no cell starves, from its first state back to it.
    std::vector<Firing> turn_of(const Loop& loop) const;

  private:
    class Turn;
    struct Edge {
        std::uint32_t to = 0;
        std::uint32_t firing = 0;
    };
    struct Node {
        const std::string* encoding = nullptr;
        std::uint32_t parent = 0;
        std::uint32_t firing = 0;
        std::vector<Edge> edges;
        std::uint8_t changes = 0;  ///< of a net that is watched
    };
    std::uint32_t add(const CircuitState& state, std::uint32_t parent, std::uint32_t firing,
                      std::uint8_t changes);
    bool is_fair(const Loop& loop, const std::vector<std::uint32_t>& loop_of) const;

    const Circuit& circuit_;
    CircuitState like_;
    std::unordered_map<std::string, std::uint32_t> numbers_;
    std::vector<Node> nodes_;
    std::vector<Firing> firings_;
    std::vector<std::uint32_t> rests_;
};

}  // namespace grafwire
