#pragma once

#include <optional>

#include "equations/equations.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "netlist/styles/styles.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The netlist of a GRAFCET in a style. What the style cannot hold (counters in the asynchronous
/// ones) is reported in `diagnostics`, and the result is empty then. The clocked style does not use
/// CDX as such: it computes the situation after the scan from the transitions, whatever the form.
/// Modules are annotated with their equations. `delays`: how long the gates will take; the clocked
/// style does not depend on it.
std::optional<Netlist> netlist_from(const Grafcet& grafcet, const Equations& equations, Style style,
                                    Diagnostics& diagnostics, const DelayModel& delays = {});

}  // namespace grafwire
