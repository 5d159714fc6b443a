#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/delay_model.h"
#include "netlist/delay_schedule.h"
#include "netlist/netlist.h"
#include "simulate/netlist_machine.h"
#include "simulate/simulator.h"
#include "trace/stimuli.h"
#include "trace/trace.h"
#include "trace/waveform.h"

namespace grafwire {

struct SimulateOptions {
    bool waveform = false;  ///< record every net
    /// Clocked netlists: one clock cycle per period and one row per scan; 0: at every
    /// instant, clock cycles until nothing changes any more.
    Time scan_period = 0;
    /// Delays that differ from those given, and may change in time.
    DelaySchedule schedule;
    /// Called at every change of a net from the first instant on.
    Simulator::Observer observer;
    /// Called as an instant or scan begins, before its inputs change.
    std::function<void(Time at, const Simulator&)> instant;
};

struct SimulateResult {
    Trace trace;        ///< in the columns of the reference; what the netlist lacks is unknown
    Waveform waveform;  ///< of every net, if asked for
    std::optional<Time> unsettled_at;  ///< the first instant at which the netlist does not settle
    std::vector<NetId> oscillating;
    std::uint64_t events = 0;
};

/// The gates under stimuli: power-up, initialisation, then one row per instant, taken once the
/// netlist has settled. Instants are 0, every line of the stimuli, every end of a running delay,
/// and the end.
SimulateResult simulate(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                        const Stimuli& stimuli, const SimulateOptions& options);

}  // namespace grafwire
