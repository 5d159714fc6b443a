#include "netlist/delay_model.h"

namespace grafwire {

CellDelays cell_delays(const Netlist& netlist, const DelayModel& model) {
    const std::vector<Time> delays(netlist.cells.size(), model.gate);
    return {delays, delays};
}

CellDelays unit_delays(const Netlist& netlist) {
    return cell_delays(netlist, {});
}

}  // namespace grafwire
