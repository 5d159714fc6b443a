#pragma once

#include <cstdint>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

/// The indices of Grafcet::enclosures with the outermost first, those of one depth in the order of
/// the file: the order in which they act.
std::vector<std::uint32_t> enclosures_inwards(const Grafcet& grafcet);

}  // namespace grafwire
