#pragma once

#include <cstddef>

#include "trace/stimuli.h"

namespace grafwire {

/// Whether one assumption of the GRAFCET, given by its index, is 1 under these inputs.
bool assumption_holds(const Grafcet& grafcet, std::size_t assumption, const InputValues& inputs);

}  // namespace grafwire
