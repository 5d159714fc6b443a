#pragma once

#include "netlist/styles/chart_netlist.h"
#include "netlist/styles/handover_chart.h"

namespace grafwire {

/// The gates of a handshake netlist: of its steps and transitions, then of its outputs.
Netlist handover_netlist(const Grafcet& grafcet, const Equations& equations,
                         const HandoverChart& handover);

}  // namespace grafwire
