#pragma once

#include <string>

#include "formats/shared/bench.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

/// The netlist and a bench as one ngspice deck (ngspice 39 or later) of XSPICE digital models.
/// `ngspice -b` on it prints the sampled outputs with `eprint`: a row in which the node `sample`
/// has come back to 0 shows them as they were at one instant, instant after instant.
///
/// The netlist must have no clocked timers (with_counted_timers() makes counters of them). The
/// clock rises once at every instant of the bench, so the instants should be scans.
///
/// The first line of a deck is its title, which ngspice does not read as part of the circuit, but
/// obeys where it looks like a command. That of this text is a comment, and so should be what is
/// put in front of it.
std::string write_spice(const Netlist& netlist, const Bench& bench, const DelayModel& delays = {});

}  // namespace grafwire
