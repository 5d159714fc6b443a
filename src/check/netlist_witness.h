#pragma once

#include <optional>
#include <string>

#include "check/explain.h"
#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"
#include "text/language.h"
#include "trace/stimuli.h"

namespace grafwire {

/// Runs reference and netlist over the stimuli of a path, from power-up, and reports the difference
/// at their end; nothing where none shows.
std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli);

/// How a witness is told.
struct TellingOptions {
    Language language = Language::english;
    /// Of the way through the gates so many links, the last ones, with a hint that witness.txt has
    /// the others; 0: all.
    std::size_t most_links = 0;
    std::string source;  ///< the file that the netlist was read from, if it was
};

/// The witness in words: what changes at the last instant, which transitions the reference clears,
/// where the two sides part, and the explanation.
std::string tell_witness(const Grafcet& grafcet, const Netlist& netlist, const Witness& witness,
                         const Explanation& explanation, const TellingOptions& options);

}  // namespace grafwire
