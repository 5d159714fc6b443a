#pragma once

#include <vector>

#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// The delay of every cell of a netlist, per edge of its output. Timers and pulse cells add their
/// own timing.
struct CellDelays {
    std::vector<Time> rise;  ///< one per cell, positive
    std::vector<Time> fall;
};

/// How long gates take. An asynchronous netlist is made for a model (pulses last as long as a step
/// needs to be set, and buffers bring signals together), and is simulated and checked under one;
/// a netlist made for one model may fail under another.
struct DelayModel {
    /// From a change of an input of any cell to that of its output, either way; positive.
    Time gate = nanosecond;

    /// Through so many cells one after the other.
    Time of_chain(unsigned cells) const { return cells * gate; }
};

CellDelays cell_delays(const Netlist& netlist, const DelayModel& model);

/// Under the model that is the default everywhere: every cell takes one unit, a nanosecond.
CellDelays unit_delays(const Netlist& netlist);

}  // namespace grafwire
