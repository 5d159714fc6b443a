#pragma once

#include <cstddef>

#include "netlist/netlist.h"

namespace grafwire {

/// Whether a netlist has cells whose delays are counted in scans.
bool has_scan_timers(const Netlist& netlist);

/// A netlist whose clocked timers have become counters, and what they took.
struct CountedTimers {
    Netlist netlist;
    std::size_t flip_flops = 0;  ///< the timers' own, counters and outputs
    Time longest = 0;            ///< the longest delay in scans
};

/// Puts gates and flip-flops in the place of the clocked timers and their look-aheads, for formats
/// that have no such cells. `scan_period` is the time from one rise of the clock to the next; a
/// delay that is no multiple of it ends at the first rise after it, as scan by scan it does. Nets,
/// ports and modules keep their names and order; the new nets are called after the timer's
/// (`timer$0$count3`).
CountedTimers with_counted_timers(const Netlist& netlist, Time scan_period);

}  // namespace grafwire
