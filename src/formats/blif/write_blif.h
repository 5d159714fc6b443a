#pragma once

#include <string>

#include "netlist/netlist.h"

namespace grafwire {

/// The netlist in the Berkeley logic interchange format. Gates become `.names` of a single cube,
/// which read_blif() recognises, flip-flops and hold latches `.latch`, other cells with memory or
/// timing `.subckt` of black boxes named `grafwire_…`.
std::string write_blif(const Netlist& netlist);

}  // namespace grafwire
