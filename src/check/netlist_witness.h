#pragma once

#include <optional>
#include <vector>

#include "check/check_result.h"
#include "check/witness.h"
#include "evolution/run.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_schedule.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"
#include "trace/stimuli.h"

namespace grafwire {

/// A choice of values for every memory (a cell, or a net on a loop of gates) of which nothing is
/// known at power-up: number 0 is all 0, 1 all 1, the others are at random, the same every time.
std::vector<Netlist::InitialValue> power_up_values(const Netlist& netlist, int number);
/// The netlist with these values at power-up.
Netlist with_power_up(const Netlist& netlist, const std::vector<Netlist::InitialValue>& values);

/// Runs reference and netlist over stimuli, from power-up, and reports the first difference;
/// nothing where none shows. `period`: of a clocked netlist, which is run scan by scan; else 0.
/// `schedule`: delays of single gates that differ.
std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli, Time period,
                              const DelaySchedule& schedule = {});

/// How often a net changes in the last instant of the stimuli under these delays; 0 where the
/// netlist shows something else than the reference (`expected`) at the end of some instant.
unsigned changes_at_end(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& nominal,
                        const Stimuli& stimuli, const RunResult& expected,
                        const DelaySchedule& schedule, NetId net);

/// A witness of the same netlist that changes as few inputs as possible: none of its changes can be
/// left out; one whose delays change in time is left as it is. `options` say what may happen in one
/// instant of it, and how long to look.
Witness smallest_witness(const Grafcet& grafcet, const Netlist& netlist, Witness witness,
                         const CheckOptions& options);

}  // namespace grafwire
