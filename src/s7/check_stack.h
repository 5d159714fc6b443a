#pragma once

#include "s7/listing.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// The levels of the stack of bits; what is pushed out at the bottom is lost.
inline constexpr std::size_t stack_levels = 9;

/// Whether each instruction of a network that works on several levels of the stack finds there what
/// the network itself has loaded.
void check_stack(const Network& network, Diagnostics& diagnostics);

}  // namespace grafwire::s7
