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

/// One value for every input, declared inputs first, then Init, AUdur, AUdoux; 0 or 1 each.
using InputValues = std::vector<std::uint8_t>;

/// The same in three values, all known.
std::vector<Logic> known_inputs(const InputValues& values);

/// What is applied to the inputs over time.
struct Stimuli {
    struct Assignment {
        std::uint32_t input = 0;  ///< declared inputs first, then Init, AUdur, AUdoux
        bool value = false;
    };
    /// One instant at which inputs are set; several lines of one instant are merged.
    struct Change {
        Time at = 0;
        std::vector<Assignment> assignments;  ///< may be empty
        Location where;
    };
    std::vector<Change> changes;  ///< strictly in the order of time
    Time end = 0;                 ///< the last instant, with a row of its own
};

/// Reads a `.stim` text. Errors go into `diagnostics`, and the result is empty then.
std::optional<Stimuli> parse_stimuli(const SourceFile& source, const Grafcet& grafcet,
                                     Diagnostics& diagnostics);

/// The stimuli as a `.stim` text; reading it back gives the same stimuli.
std::string write_stimuli(const Stimuli& stimuli, const Grafcet& grafcet);

/// Whether one assumption of the GRAFCET, given by its index, is 1 under these inputs.
bool assumption_holds(const Grafcet& grafcet, std::size_t assumption, const InputValues& inputs);

/// Whether a declared assumption is 0 under these inputs: the index of the first that is, else
/// assumptions.size().
std::size_t broken_assumption(const Grafcet& grafcet, const InputValues& inputs);

}  // namespace grafwire
