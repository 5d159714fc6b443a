#pragma once

#include <cstdint>
#include <vector>

#include "settling/circuit.h"
#include "settling/settling_model.h"

namespace grafwire {

/// Appends the joint firings of some excited gates that lead elsewhere than all orders of single
/// ones (see the source). False where there are too many to be gone through.
bool append_joint_firings(const Circuit& circuit, const CircuitState& state,
                          std::vector<std::uint32_t> gates, std::vector<Firing>& firings);

/// Where nothing else can happen, the delays that are due end, all together.
void append_ending_delays(const Circuit& circuit, const CircuitState& state,
                          std::vector<Firing>& firings);

/// The firings of some actions, each by itself and jointly; false where there are too many.
bool append_firings(const Circuit& circuit, const CircuitState& state,
                    const std::vector<CellAction>& actions, std::vector<Firing>& firings);

/// All firings there are in a state, for comparison; false where there are too many.
bool all_firings(const Circuit& circuit, const CircuitState& state, std::vector<Firing>& firings);

}  // namespace grafwire
