#pragma once

#include <cstdint>
#include <optional>

#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "settling/circuit.h"
#include "settling/settling_model.h"
#include "text/keep_going.h"
#include "trace/stimuli.h"

namespace grafwire {

/// How far one goes in looking for delays.
enum class WitnessSearch : std::uint8_t {
    by_trial,  ///< where delays have bounds, some circuits of extreme ones are tried
    thorough,  ///< then all orders of firings
};

/// Looks for delays of gates under which a netlist differs from the reference over stimuli, and
/// simulates them; nothing where none were found. They are as few and as small as can be, the
/// others being nominal, and constant if possible.
std::optional<Witness> racing_witness(const Grafcet& grafcet, const Netlist& netlist,
                                      const CellDelays& nominal, const Circuit& circuit,
                                      const DelayModel& model, const Stimuli& stimuli,
                                      WitnessSearch search, const KeepGoing& keep_going);

/// Delays of the model under which a net changes too often there, as few and as small as can be;
/// nothing where none were found.
std::optional<DelaySchedule> racing_pulse(const Grafcet& grafcet, const Netlist& netlist,
                                          const CellDelays& nominal, const Circuit& circuit,
                                          const DelayModel& model, const Stimuli& stimuli,
                                          const WatchedNet& watched, const KeepGoing& keep_going);

}  // namespace grafwire
