#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "settling/circuit.h"

namespace grafwire {

/// All that can become of the nets of a circuit, in any order of firings, while some cells hold
/// still.
class Reach {
  public:
    explicit Reach(const Circuit& circuit);

    /// From a state on; `excited` are its excited cells, `held`, per cell, whether it holds still.
    void make(const CircuitState& state, std::span<const std::uint32_t> excited,
              const std::vector<std::uint8_t>& held);

    /// The values that nets have all the way; a net that may change is unknown.
    const CircuitState& state() const { return state_; }
    /// Whether a net may change, or is unknown.
    bool is_open(NetId net) const { return state_.values[index_of(net)] == Logic::unknown; }
    /// Whether the input of a timer or pulse cell may change.
    bool is_unclear(std::uint32_t cell) const { return is_unclear_[cell] != 0; }

  private:
    void open(NetId net);

    const Circuit& circuit_;
    CircuitState state_;
    std::vector<std::uint8_t> is_unclear_;  ///< per cell
    std::vector<std::uint32_t> unclear_;    ///< these cells
    std::vector<std::uint32_t> waiting_;
};

}  // namespace grafwire
