// Several gates may change at the very same moment (the general multiple-winner model: J. A.
// Brzozowski, C.-J. H. Seger, "Asynchronous Circuits", 1995, chapter 6). That leads elsewhere than
// one after the other only if each of them would keep one of the others from firing: where a gate
// of a joint firing is still excited after all others have fired, it can as well be the last. So
// joint firings are tried of those sets of gates alone in which every gate is quietened by the
// others. In such a set each gate reads another one of it, which leaves the two halves of a latch,
// and little else.

#include "settling/joint_firings.h"

#include <algorithm>
#include <iterator>

namespace grafwire {

namespace {

constexpr std::size_t most_gates_of_joint_firing = 12;

/// Per gate, bit by bit, which of the others it reads.
std::vector<std::uint32_t> reads(const Circuit& circuit, const std::vector<std::uint32_t>& gates) {
    std::vector<std::uint32_t> result(gates.size());
    for (std::size_t i = 0; i < gates.size(); ++i) {
        const auto pins = circuit.pins(gates[i]);
        for (std::size_t j = 0; j < gates.size(); ++j) {
            const bool is_read =
                std::find(pins.begin(), pins.end(), circuit.output(gates[j])) != pins.end();
            if (i != j && is_read) result[i] |= 1U << j;
        }
    }
    return result;
}

/// Leaves only gates that read one another: no others can quieten one another.
void keep_readers_of_one_another(const Circuit& circuit, std::vector<std::uint32_t>& gates) {
    const auto reads_one = [&](std::uint32_t cell) {
        const auto pins = circuit.pins(cell);
        return std::any_of(pins.begin(), pins.end(), [&](NetId pin) {
            const std::uint32_t driver = circuit.driver(pin);
            return driver != cell && std::find(gates.begin(), gates.end(), driver) != gates.end();
        });
    };
    for (bool shrinks = true; shrinks;) {
        const auto kept = std::stable_partition(gates.begin(), gates.end(), reads_one);
        shrinks = kept != gates.end();
        gates.erase(kept, gates.end());
    }
}

/// Whether a gate of a joint firing is quiet once all others of it have fired.
bool is_quietened(const Circuit& circuit, const CircuitState& state, const Firing& firing,
                  std::uint32_t cell) {
    Firing others;
    std::copy_if(firing.begin(), firing.end(), std::back_inserter(others),
                 [&](const CellAction& other) { return other.cell != cell; });
    CircuitState after = state;
    circuit.perform(others, after);
    return circuit.asked(after, cell) == after.values[index_of(circuit.output(cell))];
}

}  // namespace

bool append_joint_firings(const Circuit& circuit, const CircuitState& state,
                          std::vector<std::uint32_t> gates, std::vector<Firing>& firings) {
    keep_readers_of_one_another(circuit, gates);
    if (gates.size() > most_gates_of_joint_firing) return false;
    const std::vector<std::uint32_t> read = reads(circuit, gates);
    for (std::uint32_t chosen = 1; chosen < 1U << gates.size(); ++chosen) {
        Firing firing;
        bool each_reads_one = true;
        for (std::size_t i = 0; i < gates.size() && each_reads_one; ++i) {
            if ((chosen >> i & 1U) == 0) continue;
            each_reads_one = (read[i] & chosen) != 0;
            firing.push_back({gates[i], CellAction::Kind::take});
        }
        const auto quietened = [&](const CellAction& action) {
            return is_quietened(circuit, state, firing, action.cell);
        };
        if (each_reads_one && std::all_of(firing.begin(), firing.end(), quietened)) {
            firings.push_back(std::move(firing));
        }
    }
    return true;
}

void append_ending_delays(const Circuit& circuit, const CircuitState& state,
                          std::vector<Firing>& firings) {
    if (!firings.empty()) return;
    Firing ends = circuit.ending_delays(state);
    if (!ends.empty()) firings.push_back(std::move(ends));
}

bool append_firings(const Circuit& circuit, const CircuitState& state,
                    const std::vector<CellAction>& actions, std::vector<Firing>& firings) {
    std::vector<std::uint32_t> gates;
    for (const CellAction& action : actions) {
        firings.push_back({action});
        if (action.kind == CellAction::Kind::take) gates.push_back(action.cell);
    }
    return append_joint_firings(circuit, state, std::move(gates), firings);
}

bool all_firings(const Circuit& circuit, const CircuitState& state, std::vector<Firing>& firings) {
    firings.clear();
    if (!append_firings(circuit, state, circuit.actions(state), firings)) return false;
    append_ending_delays(circuit, state, firings);
    return true;
}

}  // namespace grafwire
