#pragma once

#include <cstdint>
#include <random>

#include "all_orders.h"
#include "netlist/netlist.h"
#include "settling/circuit.h"
#include "settling/settling_model.h"

namespace grafwire::testing {

/// A netlist of a few gates and latches that read one another and two inputs, loops and all.
Netlist random_gates(std::mt19937& random, std::size_t gates);

Bits random_bits(std::mt19937& random, const Netlist& netlist);

/// Everything counts.
inline std::vector<std::uint8_t> all_nets(const Netlist& netlist) {
    return std::vector<std::uint8_t>(netlist.net_count(), 1);
}

/// States to go through, for what is asked here.
inline constexpr std::size_t enough = SettlingModel::usual_states;

/// The state of a netlist without timers and pulse cells with these values.
CircuitState state_of(const Bits& bits);
/// Its values; a net that is unknown is 2.
Bits bits_of(const CircuitState& state);

}  // namespace grafwire::testing
