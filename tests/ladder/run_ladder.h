#pragma once

#include "grafcet/grafcet.h"
#include "ladder/ladder.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire::testing {

/// Executes a ladder diagram, a scan every period, and gives the trace in the columns of the
/// reference, each column being the variable of its name. A name that the diagram does not have
/// ends the run with an empty trace.
Trace run_ladder(const Grafcet& grafcet, const ladder::Ladder& ladder, const Stimuli& stimuli,
                 Time period);

}  // namespace grafwire::testing
