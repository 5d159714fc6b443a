#pragma once

#include <optional>

#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "settling/circuit.h"
#include "text/keep_going.h"
#include "trace/stimuli.h"

namespace grafwire {

/// Looks for delays of gates under which a netlist differs from the reference over stimuli, and
/// simulates them; nothing where none were found. They are as few and as small as can be, the
/// others being nominal, and constant if possible.
std::optional<Witness> racing_witness(const Grafcet& grafcet, const Netlist& netlist,
                                      const CellDelays& nominal, const Circuit& circuit,
                                      const DelayModel& model, const Stimuli& stimuli,
                                      const KeepGoing& keep_going);

}  // namespace grafwire
