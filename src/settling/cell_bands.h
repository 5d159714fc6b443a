#pragma once

#include <vector>

#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

/// The bounds of every cell's delay, per edge of its output.
struct CellBands {
    std::vector<DelayBand> rise;  ///< one per cell; of a pulse cell: to the start of the pulse
    std::vector<DelayBand> fall;  ///< of a pulse cell: its width
};

CellBands cell_bands(const Netlist& netlist, const DelayModel& model);

}  // namespace grafwire
