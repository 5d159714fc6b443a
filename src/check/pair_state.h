#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "check/partial_inputs.h"
#include "check/running_delays.h"
#include "evolution/evolution.h"
#include "simulate/simulator.h"

namespace grafwire {

/// A state of the reference together with the settled state of the netlist that came with it: at
/// the end of an instant, or of a scan.
struct PairState {
    EvolutionState reference;
    SimulatorState netlist;
    PartialInputs inputs;
    RunningDelays delays;
    /// Everything that decides how the pair goes on, but for what remains of its delays.
    std::string key;
};

/// The pairs that an exploration has reached.
class SeenPairs {
  public:
    /// Notes a pair; false where it has been reached before, with all that can remain of its delays
    /// now.
    bool add(const PairState& pair);
    /// Whether a pair that was added has since been reached with more that can remain.
    bool is_covered(const PairState& pair) const;

  private:
    std::unordered_map<std::string, std::vector<Zone>> zones_;  ///< none includes another
};

}  // namespace grafwire
