#include "netlist/delay_model.h"

#include <algorithm>

namespace grafwire {

Time DelayModel::of_settling(std::size_t cells) const {
    return std::max<Time>(1'000, static_cast<Time>(cells)) * gate;
}

CellDelays cell_delays(const Netlist& netlist, const DelayModel& model) {
    CellDelays delays;
    delays.rise.reserve(netlist.cells.size());
    for (const Cell& cell : netlist.cells) delays.rise.push_back(model.of(cell.type));
    delays.fall = delays.rise;
    return delays;
}

}  // namespace grafwire
