#pragma once

#include "settling/circuit.h"
#include "settling/settling_model.h"
#include "text/keep_going.h"

namespace grafwire {

/// Some of the rests that gates of any finite delay can come to from a state, each once and with
/// the firings that lead there: those of orders in which one gate is later than all others. Where
/// all orders are too many to be gone through, these are the likeliest to show a race.
Rests rests_of_late_gates(const Circuit& circuit, const CircuitState& start,
                          const KeepGoing& keep_going);

}  // namespace grafwire
