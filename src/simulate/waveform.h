#pragma once

#include <optional>
#include <string>

#include "netlist/netlist.h"
#include "simulate/simulator.h"
#include "trace/vcd_writer.h"

namespace grafwire {

/// Records every net of a netlist while it is simulated.
class Waveform {
  public:
    /// `delays` and the times of the stimuli decide the timescale: nanoseconds where they fit.
    Waveform(const Netlist& netlist, const CellDelays& delays, bool whole_nanoseconds);

    /// Writes down the present values as those of time 0 and follows the simulator from there.
    /// The waveform must stay where it is until the simulator has gone or stop() was called.
    void follow(Simulator& simulator);
    std::string stop(Simulator& simulator, Time end);

  private:
    VcdWriter writer_;
    std::size_t net_count_;
};

}  // namespace grafwire
