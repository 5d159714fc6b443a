#pragma once

#include <cstdint>
#include <vector>

#include "settling/circuit.h"
#include "settling/reach.h"
#include "settling/settling_model.h"

namespace grafwire {

/// Chooses what to try next in a state, of all that could happen in any order, so that no rest is
/// missed, nor whether there is an endless run (see the source).
class StubbornSets {
  public:
    explicit StubbornSets(const Circuit& circuit);

    /// The firings to try in a state; empty where it is at rest. False where there are too many.
    bool choose(const CircuitState& state, std::vector<Firing>& firings);

    bool contains(std::uint32_t cell) const { return is_in_[cell] != 0; }

  private:
    std::size_t close(const CircuitState& state, std::uint32_t seed, std::size_t least);
    bool add(std::uint32_t cell);
    bool add_open_drivers(std::uint32_t cell);
    bool keep_asked(const CircuitState& state, std::uint32_t cell);
    bool add_readers(std::uint32_t cell);
    bool may_be_disturbed(std::uint32_t reader, NetId changing) const;

    const Circuit& circuit_;
    Reach reach_;                           ///< what the others can do while the set holds still
    std::vector<std::uint32_t> excited_;    ///< cells, in the state at hand
    std::vector<std::uint8_t> is_excited_;  ///< per cell, likewise
    std::vector<std::uint8_t> is_in_;       ///< per cell, whether in the set that is being closed
    std::vector<std::uint32_t> set_;        ///< that set, in the order of arrival
};

}  // namespace grafwire
