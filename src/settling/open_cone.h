#pragma once

#include <cstdint>
#include <vector>

#include "settling/circuit.h"
#include "settling/reach.h"

namespace grafwire {

/// The part of a circuit that decides what a net does within an instant.
class OpenCone {
  public:
    explicit OpenCone(const Circuit& circuit)
        : circuit_(circuit), reach_(circuit), none_(circuit.netlist().cells.size()) {}

    /// From a state on, delays that end at the instant included.
    void make(const CircuitState& state);

    /// Whether the net may change, or is unknown.
    bool is_open(NetId net) const { return reach_.is_open(net); }
    /// The nets that may change and by which this one may, in order and with it. All else that
    /// their drivers read keeps its value, so whatever the other cells do, and when, these do the
    /// same.
    std::vector<NetId> behind(NetId net) const;

  private:
    const Circuit& circuit_;
    Reach reach_;
    const std::vector<std::uint8_t> none_;  ///< per cell: 0, as none holds still
};

}  // namespace grafwire
