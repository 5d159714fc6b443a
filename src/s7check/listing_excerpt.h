#pragma once

#include <cstdint>
#include <vector>

#include "s7/listing.h"

namespace grafwire {

/// Of a network the instructions that write one of some places: the logic before each of them, up
/// to it. Where none does, those that set something or leave the network, for one of them should
/// have; and where there are none of these either, its first ones. At most `most` of them.
std::vector<const s7::Instruction*> excerpt(const s7::Network& network,
                                            const std::vector<s7::Operand>& places,
                                            std::size_t most);

}  // namespace grafwire
