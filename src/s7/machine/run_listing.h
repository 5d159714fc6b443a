#pragma once

#include <optional>

#include "grafcet/grafcet.h"
#include "s7/machine/binding.h"
#include "s7/machine/machine.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire::s7 {

/// A run of a listing over stimuli.
struct ListingRun {
    Trace trace;  ///< in the columns of the GRAFCET; up to the error, where there is one
    struct Failure {
        Time at = 0;
        RunError error;
    };
    std::optional<Failure> failure;
};

/// Scan by scan, as run_scans lets the reference run: at 0, period, 2·period … up to and including
/// the end of the stimuli. What the binding has no address for is 0.
ListingRun run_listing(Machine& machine, const Grafcet& grafcet, const Binding& binding,
                       const Stimuli& stimuli, Time period);

}  // namespace grafwire::s7
