#pragma once

#include <vector>

#include "explain/net_history.h"
#include "netlist/netlist.h"

namespace grafwire {

/// A change and those that brought it about, as indices into a history.
struct CausalLink {
    std::size_t change = 0;
    /// Empty where it began: an input changed, or a delay ended.
    std::vector<std::size_t> causes;
};

/// Everything on the way to some changes, in the order in which it happened.
std::vector<CausalLink> causal_chain(const Netlist& netlist, const CellDelays& delays,
                                     const NetHistory& history,
                                     const std::vector<std::size_t>& targets);

}  // namespace grafwire
