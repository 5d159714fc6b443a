#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evolution/evolution.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire {

/// A run of the reference over stimuli.
struct RunResult {
    Trace trace;
    /// The first instant without a stable situation, where the run ends; the trace holds the rows
    /// before it.
    std::optional<Time> unstable_at;
    std::vector<std::string> changing;  ///< what keeps changing there, by name
    /// The instants or scans at which an assumption of the GRAFCET is broken by the stimuli.
    struct BrokenAssumption {
        Time at = 0;
        std::size_t assumption = 0;
        bool operator==(const BrokenAssumption&) const = default;
    };
    std::vector<BrokenAssumption> broken_assumptions;  ///< the first per assumption
};

/// Until stable: one row per instant.
RunResult run_until_stable(const Grafcet& grafcet, const Stimuli& stimuli);

/// Scan by scan: one row per scan, at 0, period, 2·period … up to and including the end.
/// The period is positive.
RunResult run_scans(const Grafcet& grafcet, const Stimuli& stimuli, Time period);

}  // namespace grafwire
