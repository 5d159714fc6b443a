#pragma once

#include <optional>
#include <vector>

#include "evolution/run.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "settling/circuit.h"
#include "settling/settling_model.h"
#include "simulate/simulator.h"
#include "text/keep_going.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

/// What the gates do in one instant of a run: from which state on, and in which order.
struct RacedInstant {
    Time at = 0;     ///< the instant
    Time begin = 0;  ///< the same on the clock of the simulation, which gates move on
    CircuitState state;
    std::vector<Firing> firings;
    std::vector<Firing> turn;  ///< of one that never ends: what is repeated after the firings
};

/// The state in which gates begin an instant: `prepared` is that of a simulation whose inputs have
/// changed and whose delays have ended; `before` are the values before that.
CircuitState circuit_state(const Circuit& circuit, const std::vector<Logic>& before,
                           const SimulatorState& prepared, Time instant);
/// The state of a simulation that has come to rest in an instant which began in `before`.
SimulatorState simulator_state(const Circuit& circuit, const SimulatorState& before,
                               const CircuitState& rest, Time instant);

/// How long one firing is taken to follow another.
inline constexpr Time time_of_firing = nanosecond;

/// Orders of firings under which a netlist shows something else than the reference over stimuli,
/// instant by instant down to the difference; nothing where there are none, or none were found
/// within reason. All inputs are known there, and every memory has a value. With a net that is
/// watched: under which it shows the same, and the net changes too often in the last instant.
struct RaceQuestion {
    const Grafcet& grafcet;
    const Netlist& netlist;
    const CellDelays& nominal;
    const Circuit& circuit;  ///< of the netlist
    const DelayModel& model;
    const Stimuli& stimuli;
    const RunResult& expected;  ///< of the reference over these
    const KeepGoing& keep_going;
    const WatchedNet* watched = nullptr;
};
std::optional<std::vector<RacedInstant>> find_race(const RaceQuestion& question);

}  // namespace grafwire
