#pragma once

#include "formats/shared/bench.h"
#include "formats/spice/spice_elements.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Writes the start (nodes `__start` and `__running`, one the complement of the other), the inputs
/// and their clock as the bench has them, and the node `sample__`, which rises when an instant has
/// settled and falls before the next. Gives the end of the bench, counted from the end of the start
/// that `start` is the length of.
Time append_spice_stimuli(std::string& out, SpiceElements& elements, const Netlist& netlist,
                          const NetSpelling& nets, const Bench& bench, Time start);

}  // namespace grafwire
