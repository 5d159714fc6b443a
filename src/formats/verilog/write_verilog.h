#pragma once

#include <string>

#include "formats/shared/bench.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// The netlist as structural Verilog (IEEE 1364-2005), the top module named after the GRAFCET.
/// `scan_period` is the default of the parameter SCAN_PS of a clocked netlist with timers; the
/// gates of a clocked netlist have no delay.
std::string write_verilog(const Netlist& netlist, Time scan_period = 10 * millisecond,
                          const DelayModel& delays = {});

/// A test bench for that file: applies the bench and prints one CSV row per instant, `time_ms`,
/// then the outputs in the order of the ports. It must stand before the netlist on the simulator's
/// command line, which lets the delays count from the moments of the stimuli. Its module is called
/// `grafwire_bench`. Where the bench says what is expected, the last line printed is PASS, or the
/// first difference, and the simulator ends with the status 1.
std::string write_verilog_bench(const Netlist& netlist, const Bench& bench,
                                Time scan_period = 10 * millisecond, const DelayModel& delays = {});

}  // namespace grafwire
