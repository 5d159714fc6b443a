#pragma once

#include <map>
#include <utility>
#include <vector>

#include "equations/equations.h"
#include "text/diagnostics.h"

namespace grafwire {

/// What the clearing of each transition writes in the end: the stored output or
/// var, by its number in Equations::stored, and the value. Stored actions that
/// a transition alone does not decide are reported.
Table<TransitionId, std::map<std::uint32_t, bool>> writes_of_transitions(const Grafcet& grafcet,
                                                                         const Equations& equations,
                                                                         Diagnostics& diagnostics);

}  // namespace grafwire
