#pragma once

#include <optional>
#include <vector>

#include "check/race_search.h"
#include "netlist/delay_schedule.h"
#include "settling/cell_bands.h"
#include "settling/circuit.h"

namespace grafwire {

/// Delays of gates under which a simulation makes exactly these firings: within the bounds, if
/// there are any, else one firing every time_of_firing. Nothing where the bounds allow none.
std::optional<DelaySchedule> delays_for(const Circuit& circuit,
                                        const std::vector<RacedInstant>& instants,
                                        const CellBands* bands);

}  // namespace grafwire
