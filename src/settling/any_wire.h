#pragma once

#include "settling/any_order.h"
#include "settling/settling_model.h"

namespace grafwire {

/// The model in which every gate and every wire may take any finite time. The circuit is that of a
/// netlist whose wires are cells (with_wire_delays of netlist/passes).
class AnyWire : public SettlingModel {
  public:
    AnyWire(const Circuit& circuit, KeepGoing keep_going)
        : circuit_(circuit), keep_going_(keep_going), any_order_(circuit, std::move(keep_going)) {}
    Rests settle(const CircuitState& start, bool with_firings, std::size_t most_states) override;
    Pulsing pulsing(const CircuitState& start, const WatchedNet& watched,
                    std::size_t most_states) override;

  private:
    const Circuit& circuit_;
    const KeepGoing keep_going_;
    AnyOrder any_order_;
};

}  // namespace grafwire
