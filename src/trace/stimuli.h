#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "logic/logic.h"
#include "text/diagnostics.h"
#include "text/time.h"

namespace grafwire {

/// What is applied to the inputs over time. An input that is never set is 0.
struct Stimuli {
    struct Assignment {
        std::uint32_t input = 0;  ///< declared inputs first, then Init, AUdur, AUdoux
        bool value = false;
    };
    /// One instant at which inputs are set; several lines of one instant are merged.
    struct Change {
        Time at = 0;
        std::vector<Assignment> assignments;  ///< may be empty
        Location where{};
    };
    std::vector<Change> changes;  ///< strictly in the order of time
    Time end = 0;                 ///< the last instant, with a row of its own
};

/// Reads a `.stim` text (UTF-8; a byte order mark at its beginning is skipped):
///
///     # time : assignments
///     0ms   : v0=1 h0=1        before the first scan
///     +50ms : dcy=0            relative to the line before
///     +1s   : "a b"=1 Init=1   names other than letters, digits and _ are quoted
///     10s   : end              optional; without it the last line ends the run
///
/// Times have the units us, ms, s, min, h and do not go back; of two assignments to an input at one
/// instant the last one counts. Errors go into `diagnostics`, and the result is empty then.
std::optional<Stimuli> parse_stimuli(const SourceFile& source, const Grafcet& grafcet,
                                     Diagnostics& diagnostics);

/// The stimuli as a `.stim` text; reading it back gives the same stimuli.
std::string write_stimuli(const Stimuli& stimuli, const Grafcet& grafcet);

}  // namespace grafwire
