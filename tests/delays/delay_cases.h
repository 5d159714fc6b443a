#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "delays/gate_orders.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "trace/input_values.h"

namespace grafwire::testing {

/// One event in a stable situation: an input changes, or a time condition whose delay runs
/// becomes 1.
struct DelayEvent {
    bool is_input = true;
    std::size_t index = 0;  ///< of the input (all_input_count), or the time condition
};

/// What a chart does at an event, told to whoever judges whether it depends on an order of its own.
struct ChartCase {
    const EvolutionState& state;
    const InputValues& before;
    const InputValues& after;
    DelayEvent event;
};

struct DelayOptions {
    Firing firing = Firing::one_gate;
    std::size_t most_cases = 1'000'000;
    std::size_t most_states = 400'000;  ///< per case
    bool with_controls = true;          ///< Init, AUdur and AUdoux change as well
    /// Cases for which the netlist has nothing to answer for: the chart itself depends on the order
    /// in which its transitions clear.
    std::function<bool(const ChartCase&)> is_ordered;
};

struct DelayReport {
    std::size_t cases = 0;  ///< in which the netlist was judged
    std::size_t right = 0;
    std::size_t ordered = 0;    ///< left out, see DelayOptions::is_ordered
    std::size_t unstable = 0;   ///< left out: the chart has no stable situation
    std::size_t too_large = 0;  ///< left out: more states than allowed
    std::size_t most_states = 0;
    bool is_complete = true;  ///< every case that can be reached was looked at
    std::string first_wrong;  ///< in words; empty where all are right

    bool is_right() const { return cases == right && first_wrong.empty(); }
};

/// From every stable situation that can be reached, every single event, in every order of the
/// gates, against the reference evolution. All that is in the ports is compared.
DelayReport explore_delays(const Grafcet& grafcet, const Netlist& netlist,
                           const DelayOptions& options = {});

/// What the reference makes of an event: the state afterwards with all running delays due at
/// `far_away`, so that states that differ in the time alone are one. False: it does not settle.
bool reference_after(const Evolution& evolution, EvolutionState& state, const InputValues& after,
                     DelayEvent event);
inline constexpr Time far_away = 1'000'000 * second;

/// A name for every part of a state that its future depends on.
std::string key_of(const EvolutionState& state);

}  // namespace grafwire::testing
