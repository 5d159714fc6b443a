#pragma once

#include <string>

#include "check/partial_inputs.h"
#include "check/running_delays.h"
#include "evolution/evolution.h"
#include "simulate/simulator.h"

namespace grafwire {

/// A stable state of the reference together with the settled state of the netlist that came with
/// it.
struct PairState {
    EvolutionState reference;
    SimulatorState netlist;
    PartialInputs inputs;
    RunningDelays delays;
};

/// Everything that decides how a pair goes on, but for what remains of its delays.
std::string key_of(const PairState& pair);

}  // namespace grafwire
