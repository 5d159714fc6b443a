#pragma once

#include <string>

#include "formats/shared/bench.h"
#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// The netlist and a bench as one ngspice deck (ngspice 39 or later) of XSPICE digital models.
/// `ngspice -b` on it prints the sampled outputs with `eprint`: a row in which the node `sample`
/// has come back to 0 shows them as they were at one instant, instant after instant.
///
/// Clocked timers become counters of flip-flops, for rises of the clock `scan_period` apart; the
/// head of the deck says how many. In the deck itself the clock rises once at every instant of the
/// bench, so the instants should be scans.
std::string write_spice(const Netlist& netlist, const Bench& bench,
                        Time scan_period = 10 * millisecond);

}  // namespace grafwire
