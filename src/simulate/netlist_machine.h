#pragma once

#include <cstdint>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/delay_ends.h"
#include "simulate/simulator.h"

namespace grafwire {

/// Which net of a netlist carries which input of the GRAFCET, X variable and output; found by the
/// names of the ports. no_net where the netlist has none.
struct PortMap {
    std::vector<NetId> inputs;  ///< declared inputs, Init, AUdur, AUdoux
    std::vector<NetId> steps;
    std::vector<NetId> outputs;

    /// The first inputs of the GRAFCET take these values.
    void set_inputs(Simulator& simulator, const std::vector<Logic>& values) const;
};
PortMap map_ports(const Grafcet& grafcet, const Netlist& netlist);

/// A netlist in the place of its GRAFCET: a simulation whose inputs are those of the GRAFCET
/// (declared inputs, Init, AUdur, AUdoux; three-valued), from its start through instants. GRAFCET
/// and netlist must outlive it.
class NetlistMachine {
  public:
    NetlistMachine(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                   const DelaySchedule& schedule = {});

    /// Brings the netlist from power-up to the state it starts in: with modes Init is 1 and the
    /// other controls 0 until it has settled; without, the steps are held at the initial situation
    /// until it has. The inputs have these values since always. Init is left at 1 where there are
    /// modes, except in clocked netlists: the first instant sets it. What evolves at once from the
    /// initial situation is left to the first instant, so there is no state to save before it. The
    /// clock of the simulation stands at 0 then.
    Settling start(const std::vector<Logic>& inputs);

    /// Before an instant, from a restored state: at rest under these inputs, which have been so
    /// since always.
    void rest_under(const std::vector<Logic>& inputs);

    /// An instant not before the last one begins, with these inputs; without any they stay.
    void begin_instant(Time at, const std::vector<Logic>& inputs);
    /// The delays that are due at the instant take effect, as far as the new inputs let them.
    void end_delays();
    /// Lets the netlist come to rest at the instant, with the delays that are found to end at it.
    Settling settle();

    /// A whole instant, from its inputs to rest; of a clocked netlist as many cycles of the clock
    /// as it takes until one changes nothing.
    Settling instant(Time at, const std::vector<Logic>& inputs);
    /// A scan of a clocked netlist: one cycle of the clock under these inputs.
    Settling scan(Time at, const std::vector<Logic>& inputs);

    Simulator& simulator() { return simulator_; }
    const Simulator& simulator() const { return simulator_; }
    const PortMap& ports() const { return ports_; }

  private:
    Settling settle_by_cycles();
    std::vector<NetId> changing_in(std::uint64_t cycles);

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    Simulator simulator_;
    DelayEnds delay_ends_;
    PortMap ports_;
    Time instant_ = 0;
};

}  // namespace grafwire
