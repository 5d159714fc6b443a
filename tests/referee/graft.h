#pragma once

#include <string>

#include "netlist/netlist.h"
#include "random/random_source.h"

namespace grafwire::testing {

/// A netlist with something foreign in it that is seldom seen: a few cells more (pulses, latches,
/// flip-flops, chains of buffers, gates over nets taken at random) that lead to one more pin of a
/// gate; or a timer or pulse cell of another length. `told`: in words, what was done.
Netlist grafted(Netlist netlist, RandomSource& random, std::string& told);

}  // namespace grafwire::testing
