#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire::testing {

/// The values of all nets, none unknown.
using Bits = std::vector<std::uint8_t>;

/// What a netlist of gates and latches can come to from some values on, where any gates that ask
/// for another value may change at any moment, alone or together.
struct Outcomes {
    std::set<Bits> rests;
    bool can_go_on_for_ever = false;  ///< with every gate getting its turn, or resting, sometimes
};

/// Goes through all of it, as the definition says.
Outcomes outcomes_by_definition(const Netlist& netlist, const Bits& start);

/// How often a net can change on the way, but no more than `most`.
unsigned changes_by_definition(const Netlist& netlist, const Bits& start, NetId net, unsigned most);

}  // namespace grafwire::testing
