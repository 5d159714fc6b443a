#pragma once

#include <string>
#include <string_view>

#include "formats/shared/bench.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

/// The netlist and a bench as one ngspice deck (ngspice 39 or later) of XSPICE digital models.
/// `ngspice -b` on it prints the sampled outputs with `eprint`: a row in which the node `sample`
/// has come back to 0 shows them as they were at one instant, instant after instant.
///
/// The netlist must have no clocked timers (with_counted_timers() makes counters of them). The
/// clock rises once at every instant of the bench, so the instants should be scans. `remark` is one
/// more line for the head of the deck.
std::string write_spice(const Netlist& netlist, const Bench& bench, std::string_view remark = {},
                        const DelayModel& delays = {});

}  // namespace grafwire
