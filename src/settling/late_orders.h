#pragma once

#include <optional>
#include <vector>

#include "settling/circuit.h"
#include "settling/settling_model.h"
#include "text/keep_going.h"

namespace grafwire {

/// Some of the rests that gates of any finite delay can come to from a state, each once and with
/// the firings that lead there: those of orders in which one gate is later than all others. Where
/// all orders are too many to be gone through, these are the likeliest to show a race.
Rests rests_of_late_gates(const Circuit& circuit, const CircuitState& start,
                          const KeepGoing& keep_going);

/// The firings of one of these orders in which a net changes too often; nothing where there is
/// none.
std::optional<std::vector<Firing>> late_order_with_pulse(const Circuit& circuit,
                                                         const CircuitState& start,
                                                         const WatchedNet& watched,
                                                         const KeepGoing& keep_going);

/// What leads from a state to a rest when gates fire in the order in which they have become
/// excited; nothing where that does not come to rest soon.
std::optional<std::vector<Firing>> firings_to_rest(const Circuit& circuit,
                                                   const CircuitState& start);

}  // namespace grafwire
