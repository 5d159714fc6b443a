#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire::testing {

/// One wrong wire, gate or initial value.
struct Mutation {
    enum class Kind {
        other_type,     ///< AND for OR, NAND for NOR, NOT for a buffer, … ; set and reset swapped
        other_initial,  ///< a memory starts at the other value
        no_pin,         ///< an input left out
        inverted_pin,   ///< an input through an inverter
        moved_pin,      ///< an input taken from a neighbouring net
    };
    Kind kind = Kind::other_type;
    CellId cell{};
    std::uint32_t pin = 0;
};

/// Every mutation of a netlist, in the order of its cells.
std::vector<Mutation> mutations_of(const Netlist& netlist);

/// The netlist with one mutation.
Netlist mutated(Netlist netlist, const Mutation& mutation);

/// "an input left out: NAND gate X7$set of step 7, pin 1".
std::string describe(const Netlist& netlist, const Mutation& mutation);

}  // namespace grafwire::testing
