#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

/// What the chart gives a name, in the order in which a ladder diagram and a sequential function
/// chart declare it: inputs, Init, AUdur, AUdoux, outputs, steps (`X5`), vars, counters. Whoever
/// makes identifiers of them in this order makes the same ones.
std::vector<std::string> declared_names(const Grafcet& grafcet);

}  // namespace grafwire
