#pragma once

#include <string>
#include <vector>

#include "check/check_result.h"
#include "explain/explain.h"
#include "explain/write_explanation.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Why a net changes too often in an instant: what should have been the later of two ways through
/// the gates was the sooner, or the two should have come together.
struct PulseRace {
    /// The nets, in their order, on the way to the first change that is too many and not on that to
    /// the next, and the other way round. Where one way has none of its own, what it last came by.
    std::vector<NetId> sooner;
    std::vector<NetId> later;
    /// Everything in the instant that led to the changes of the net.
    std::vector<Explanation::Link> chain;
};

/// Simulates the netlist, with these nominal delays, once more.
PulseRace race_of(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                  const Pulse& pulse);

/// In words: how often the net changes, which gates race, the delays that it takes, what changes at
/// the instant and what the reference makes of it, and the chain of changes.
std::string write_pulse(const Grafcet& grafcet, const Netlist& netlist, const Pulse& pulse,
                        const PulseRace& race, const ExplanationOptions& options);

}  // namespace grafwire
