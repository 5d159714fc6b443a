#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "grafwire/netlist.h"
#include "grafwire/read.h"

namespace grafwire::api {

/// A run over stimuli.
struct Run {
    std::string csv;  ///< the trace, a row per instant or scan
    std::string vcd;  ///< the waveform
    /// The first instant without a stable situation, or at which the gates do not settle: the run
    /// ends there.
    std::optional<std::chrono::nanoseconds> unstable_at;
};

/// The reference evolution over stimuli (a `.stim` text): scan by scan with that period, which is
/// positive, or until stable where there is none.
Result<Run> run(const Chart& chart, std::string stimuli,
                std::optional<std::chrono::nanoseconds> period = std::nullopt);

/// The gates of a netlist over stimuli, each gate taking as long; a period is for clocked netlists
/// only.
Result<Run> simulate(const Netlist& netlist, std::string stimuli,
                     std::optional<std::chrono::nanoseconds> period = std::nullopt);

}  // namespace grafwire::api
