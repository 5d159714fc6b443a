#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire {

struct SimulateOptions {
    bool waveform = false;  ///< record every net
    /// Clocked netlists: one clock cycle every so much time and one row per scan; 0: at every
    /// instant clock cycles until nothing changes any more.
    Time scan_period = 0;
    /// Called at every change of a net from the first instant on; not together with a waveform.
    Simulator::Observer observer;
};

struct SimulateResult {
    Trace trace;           ///< in the columns of the reference; what the netlist lacks is unknown
    std::string waveform;  ///< VCD of every net, if asked for
    std::optional<Time> unsettled_at;  ///< the first instant at which the netlist does not settle
    std::vector<NetId> oscillating;
    std::uint64_t events = 0;
};

/// The gates under stimuli: power-up, initialisation, then one row per instant, taken once the
/// netlist has settled. Instants are 0, every line of the stimuli, every end of a running delay,
/// and the end.
SimulateResult simulate(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                        const Stimuli& stimuli, const SimulateOptions& options);

/// Which net of the netlist carries which input of the GRAFCET, X variable, output, var and
/// counter; found by the names of the ports. no_net where the netlist has none.
struct PortMap {
    std::vector<NetId> inputs;  ///< declared inputs, Init, AUdur, AUdoux
    std::vector<NetId> steps;
    std::vector<NetId> outputs;
};
PortMap map_ports(const Grafcet& grafcet, const Netlist& netlist);

/// Brings a netlist from power-up to the state it starts in: with modes Init is 1 and the other
/// controls 0 until it has settled; without, the steps are held at the initial situation until it
/// has settled. The inputs have these values since always (three-valued; declared inputs, Init,
/// AUdur, AUdoux). Init is left at 1 where there are modes (but for clocked netlists): the first
/// instant sets it. What evolves at once from the initial situation is left to the settle() of the
/// first instant, so nothing is to be saved before. The clock of the simulation stands at 0 then.
Settling initialise(Simulator& simulator, const Grafcet& grafcet, const Netlist& netlist,
                    const PortMap& ports, const std::vector<Logic>& inputs);

}  // namespace grafwire
