#pragma once

#include <string>

#include "grafcet/grafcet.h"
#include "netlist/netlist.h"

namespace grafwire::testing {

/// A netlist in BLIF that can be compared with the GRAFCET, in the order of its ports.
Netlist blif(const Grafcet& grafcet, const std::string& text, bool starts_initially = true);

}  // namespace grafwire::testing
