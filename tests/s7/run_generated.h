#pragma once

#include <string>

#include "grafcet/grafcet.h"
#include "s7/generate/listing_from.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire::testing {

/// Executes a generated listing in the machine, a scan every period, and gives the trace in the
/// columns of the reference. The memory holds what another program has left there. A run that ends
/// with an error gives a message in `problem`.
Trace run_generated(const s7::AssignedListing& generated, const Grafcet& grafcet,
                    const Stimuli& stimuli, Time period, std::string& problem);

}  // namespace grafwire::testing
