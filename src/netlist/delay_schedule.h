#pragma once

#include <vector>

#include "netlist/cell_types.h"
#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// From a moment on, a cell takes these times. A change of its output that is already under way
/// keeps its own.
struct DelayChange {
    /// On the clock of the simulation: an instant, plus the time for which gates have worked since.
    /// A cell that is evaluated at that moment takes the new times already. At 0 or before: from
    /// the start, which comes before the first instant.
    Time at = 0;
    CellId cell = no_cell;
    Time rise = nanosecond;  ///< to 1, positive; of a pulse cell: to the start of the pulse
    Time fall = nanosecond;  ///< to 0, positive; of a pulse cell: unused
    /// Of pulses that begin from then on; 0 where it stays what it is. Other cells: unused.
    Time width = 0;
    bool operator==(const DelayChange&) const = default;
};

/// Concrete delays that may change in time. A cell that is not named keeps the delays that it has
/// by itself.
struct DelaySchedule {
    std::vector<DelayChange>
        changes;  ///< in the order of `at`; of two for one cell the later holds
    bool operator==(const DelaySchedule&) const = default;
};

}  // namespace grafwire
