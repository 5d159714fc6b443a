#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "explain/causal_chain.h"
#include "grafcet/grafcet.h"
#include "logic/logic.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

/// All that the nets do within an instant of a simulation, or within a scan.
struct InstantDetail {
    Time at = 0;
    std::vector<Logic> before;       ///< per net
    std::vector<NetChange> changes;  ///< in their order; times since the instant
    struct Cause {
        /// What made the gate change, as indices into the changes: its input that changed last, or
        /// several that changed together; of a flip-flop the clock.
        std::vector<std::size_t> changes;
        std::string ended;  ///< the time condition whose delay ended, else empty
    };
    std::vector<Cause> causes;  ///< per change; all empty where an input changed
    bool is_settled = true;     ///< else only the beginning is there
};

/// A simulation, the instants or scans that it goes through, and one of them gate by gate; empty
/// where none is at that time.
struct DetailedSimulation {
    SimulateResult result;
    std::vector<Time> instants;
    std::optional<InstantDetail> detail;
};

/// simulate() with a look into the instant at `at`; its observers are those of the detail.
DetailedSimulation simulate_in_detail(const Grafcet& grafcet, const Netlist& netlist,
                                      const CellDelays& delays, const Stimuli& stimuli,
                                      SimulateOptions options, Time at);

}  // namespace grafwire
