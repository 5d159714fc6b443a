#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/timing_cause.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"
#include "text/message.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "trace/trace.h"
#include "workflow/chart.h"
#include "workflow/drawings.h"
#include "workflow/gate_delays.h"

namespace grafwire {

/// An instant of a simulation gate by gate, as a run on the scale of nanoseconds. Columns are the
/// nets that change within it: inputs, inner nets that are shared, then each X and each output with
/// the nets that are made for it, in the order of the chart. There is a row for what was there
/// before, at a time before 0, and one for each moment at which a net changes.
struct ZoomedInstant {
    Trace trace;
    std::string title;
    std::vector<TimingCause> causes;  ///< which change made which gate change

    ShownRun shown() const { return {trace, title, causes, TimeScale::nanoseconds}; }
};

/// A simulation, and what came of looking for an instant in it. Where the netlist does not settle
/// at its start there are no instants, and that at any time is without rows.
struct ZoomResult {
    SimulateResult simulation;
    std::optional<ZoomedInstant> instant;
    std::vector<Time> nearest;  ///< no such instant: those before and after it
};

/// The simulation of simulate_gates(), with a look into the instant at `at`, or into the scan. Of
/// an instant in which the gates do not settle, the beginning.
ZoomResult zoom_into(const Chart& chart, const Netlist& netlist, const Stimuli& stimuli,
                     const GateDelays& delays, std::optional<Time> period, bool with_waveform,
                     Time at, Language language);

}  // namespace grafwire
