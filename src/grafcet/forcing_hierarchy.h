#pragma once

#include <cstddef>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

/// Per graph, how deep it is in the hierarchy of forcing orders: 0 where nothing forces it, else
/// one more than the deepest of the graphs whose steps do. Freezing orders do not count. All orders
/// of a scan are read before any is obeyed (one pass, Cordier, section 5.6): a program that obeys
/// them one by one takes the deepest graphs first.
std::vector<std::size_t> forcing_depths(const Grafcet& grafcet);

}  // namespace grafwire
