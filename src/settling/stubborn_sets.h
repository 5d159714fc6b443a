#pragma once

#include <cstdint>
#include <vector>

#include "settling/circuit.h"
#include "settling/settling_model.h"

namespace grafwire {

/// Chooses what to try next in a state, of all that could happen, so that nothing which a netlist
/// can come to is missed (see the source).
class StubbornSets {
  public:
    /// `in_time`: the firings of a set are to be told apart by their times as well, see the source.
    explicit StubbornSets(const Circuit& circuit, bool in_time = false);

    /// The firings to try in a state; empty where it is at rest. False where there are too many.
    bool choose(const CircuitState& state, std::vector<Firing>& firings);
    /// Whether a cell is in the set that was chosen.
    bool contains(std::uint32_t cell) const { return is_in_[cell] != 0; }
    /// All firings there are, for comparison.
    bool all(const CircuitState& state, std::vector<Firing>& firings) const;

  private:
    std::size_t close(const CircuitState& state, std::uint32_t seed, std::size_t least);
    void add(std::uint32_t cell);
    void add_driver(NetId net);
    void add_inputs(const CircuitState& state, std::uint32_t cell);
    void add_readers(const CircuitState& state, std::uint32_t cell);
    void append_ends(const CircuitState& state, std::vector<Firing>& firings) const;
    bool append_joint(const CircuitState& state, const std::vector<std::uint32_t>& gates,
                      std::vector<Firing>& firings) const;

    const Circuit& circuit_;
    const bool in_time_;
    std::vector<std::uint8_t> is_excited_;  ///< per cell, in the state at hand
    std::vector<std::uint8_t> is_in_;       ///< per cell, whether in the set that is being closed
    std::vector<std::uint32_t> set_;        ///< that set, in the order of arrival
};

}  // namespace grafwire
