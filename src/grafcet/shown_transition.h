#pragma once

#include <string>

#include "grafcet/grafcet.h"

namespace grafwire {

/// A transition as people name it, with the steps before and behind it: `(1) 2, 3 -> 4`; `(0) -> 1`
/// of a source, `(5) 4 ->` of a sink.
std::string shown_transition(const Grafcet& grafcet, TransitionId id);

}  // namespace grafwire
