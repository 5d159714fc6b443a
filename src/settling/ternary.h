#pragma once

#include <optional>

#include "settling/circuit.h"
#include "settling/settling_model.h"

namespace grafwire {

/// Where a circuit comes to rest in an instant whatever the delays of its gates are: what depends
/// on them is unknown there. So is what a timer or a pulse cell makes of an input that depends on
/// them.
CircuitState ternary_rest(const Circuit& circuit, const CircuitState& start);

/// Whether nothing in a state is unknown, as far as it is relevant.
bool is_known(const Circuit& circuit, const CircuitState& state);

/// The one rest of a start, where no delay makes a difference; nothing where some may.
std::optional<Rests> rest_of_all_delays(const Circuit& circuit, const CircuitState& start);

}  // namespace grafwire
