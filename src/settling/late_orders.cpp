// Orders of firings in which one gate waits until nothing else is left to fire, and the others fire
// in the order in which they have become excited. Each of them is a circuit that can be built: one
// slow gate or wire, the others alike. That is how hazards of feedback come about: a change of an
// input reaches a gate by a slow wire, after what it has set off elsewhere (S. H. Unger, "Hazards
// and delays in asynchronous sequential switching circuits", IRE Trans. Circuit Theory 6, 1959).

#include "settling/late_orders.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace grafwire {

namespace {

/// So many firings per cell, then the circuit is taken to oscillate and the order is given up.
constexpr std::size_t most_firings_per_cell = 8;

class LateOrder {
  public:
    LateOrder(const Circuit& circuit, const CircuitState& start, std::uint32_t late)
        : circuit_(circuit), late_(late), state_(start) {}

    /// The rest that it comes to.
    std::optional<Rest> go() {
        std::vector<Firing> firings;
        const std::size_t most = most_firings_per_cell * circuit_.cells().size();
        while (firings.size() < most) {
            Firing firing = next();
            if (firing.empty()) {
                Rest rest;
                rest.state = std::move(state_);
                rest.firings = std::move(firings);
                return rest;
            }
            circuit_.perform(firing, state_);
            firings.push_back(std::move(firing));
        }
        return std::nullopt;
    }

  private:
    /// Those that are still excited keep their places.
    Firing next() {
        const std::vector<CellAction> actions = circuit_.actions(state_);
        const auto is_gone = [&](const CellAction& action) {
            return std::find(actions.begin(), actions.end(), action) == actions.end();
        };
        std::erase_if(waiting_, is_gone);
        for (const CellAction& action : actions) {
            const bool is_new =
                std::find(waiting_.begin(), waiting_.end(), action) == waiting_.end();
            if (is_new) waiting_.push_back(action);
        }
        if (waiting_.empty()) return circuit_.ending_delays(state_);
        const auto first =
            std::find_if(waiting_.begin(), waiting_.end(),
                         [&](const CellAction& action) { return action.cell != late_; });
        const auto fired = first == waiting_.end() ? waiting_.begin() : first;
        const CellAction action = *fired;
        waiting_.erase(fired);
        return {action};
    }

    const Circuit& circuit_;
    const std::uint32_t late_;
    CircuitState state_;
    std::vector<CellAction> waiting_;  ///< in the order in which they have become excited
};

}  // namespace

Rests rests_of_late_gates(const Circuit& circuit, const CircuitState& start,
                          const KeepGoing& keep_going) {
    Rests rests;
    std::unordered_set<std::string> seen;
    for (const std::uint32_t late : circuit.cells()) {
        if (keep_going && !keep_going()) {
            rests.broken_off = true;
            break;
        }
        ++rests.states;
        auto rest = LateOrder(circuit, start, late).go();
        if (rest && seen.insert(circuit.encoded(rest->state)).second) {
            rests.rests.push_back(std::move(*rest));
        }
    }
    rests.is_too_large = true;
    return rests;
}

std::optional<std::vector<Firing>> late_order_with_pulse(const Circuit& circuit,
                                                         const CircuitState& start,
                                                         const WatchedNet& watched,
                                                         const KeepGoing& keep_going) {
    for (const std::uint32_t late : circuit.cells()) {
        if (keep_going && !keep_going()) return std::nullopt;
        auto rest = LateOrder(circuit, start, late).go();
        if (!rest) continue;
        CircuitState state = start;
        std::uint8_t changes = 0;
        for (const Firing& firing : rest->firings) {
            const CircuitState before = state;
            circuit.perform(firing, state);
            changes = watched.count(changes, before, state);
            if (changes > watched.most) return std::move(rest->firings);
        }
    }
    return std::nullopt;
}

std::optional<std::vector<Firing>> firings_to_rest(const Circuit& circuit,
                                                   const CircuitState& start) {
    auto rest = LateOrder(circuit, start, Circuit::none).go();
    if (!rest) return std::nullopt;
    return std::move(rest->firings);
}

}  // namespace grafwire
