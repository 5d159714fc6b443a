#pragma once

#include <cstdint>
#include <vector>

#include "settling/circuit.h"
#include "settling/reach.h"
#include "settling/settling_model.h"

namespace grafwire {

/// Chooses what to try next in a state where firings have times, so that no rest is missed, nor
/// whether there is an endless run, and so that the times of cells outside of what was chosen need
/// not be compared with those in it (see the source).
class TimedStubbornSets {
  public:
    explicit TimedStubbornSets(const Circuit& circuit);

    /// The firings to try in a state; empty where it is at rest. False where there are too many.
    bool choose(const CircuitState& state, std::vector<Firing>& firings);
    /// Whether a cell is in the set that was chosen.
    bool contains(std::uint32_t cell) const { return is_in_[cell] != 0; }

  private:
    std::size_t close(const CircuitState& state, std::uint32_t seed, std::size_t least);
    void add(std::uint32_t cell);
    void add_driver(NetId net);
    void add_inputs(const CircuitState& state, std::uint32_t cell);
    void add_readers(const CircuitState& state, std::uint32_t cell);
    bool is_fixed(std::uint32_t cell) const;

    const Circuit& circuit_;
    Reach reach_;                           ///< all that can happen from the state at hand on
    const std::vector<std::uint8_t> none_;  ///< per cell: 0
    std::vector<std::uint8_t> is_excited_;  ///< per cell, in the state at hand
    std::vector<std::uint8_t> is_in_;       ///< per cell, whether in the set that is being closed
    std::vector<std::uint32_t> set_;        ///< that set, in the order of arrival
};

}  // namespace grafwire
