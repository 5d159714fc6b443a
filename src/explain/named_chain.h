#pragma once

#include <vector>

#include "explain/causal_chain.h"
#include "explain/explain.h"
#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// A causal chain with names in the place of numbers. `instant`: what moments are counted from.
std::vector<Explanation::Link> named_chain(const Netlist& netlist, const NetHistory& history,
                                           const std::vector<CausalLink>& links, Time instant);

}  // namespace grafwire
