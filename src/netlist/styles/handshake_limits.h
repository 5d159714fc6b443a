#pragma once

#include "netlist/styles/handshake_facts.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Reports the constructs of a chart for which the handshake style has no gates. What single
/// receptivities and stored actions cannot have read_for_handshake() has reported.
void refuse_constructs(const HandshakeFacts& facts, Diagnostics& diagnostics);

}  // namespace grafwire
