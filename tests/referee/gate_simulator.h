#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "text/time.h"
#include "trace/input_values.h"

namespace grafwire::testing {

/// A netlist under unit delays, simulated a nanosecond at a time with two values: in every tick
/// every cell looks at its pins as they are, and all that change do so together at the next. With
/// one delay for all cells that is what inertial delays come to. Written as plainly as it can be,
/// and apart from src/simulate, to judge what is proved with that.
class GateSimulator {
  public:
    /// Both must outlive it. The ports of the netlist are found by the names of the GRAFCET; X of
    /// every step and every output must be there.
    GateSimulator(const Grafcet& grafcet, const Netlist& netlist);

    /// From power-up to the state before instant 0, whose inputs are given. `power_up`: per net,
    /// what it is at power-up if nothing in the netlist says so. False where it does not settle.
    bool start(const InputValues& inputs, const std::vector<bool>& power_up);
    /// An instant, until nothing moves; of a clocked netlist: clock cycles until one of them
    /// changes nothing. False where it does not settle.
    bool instant(Time now, const InputValues& inputs);
    /// A clock cycle of a clocked netlist.
    bool scan(Time now, const InputValues& inputs);

    /// The first moment at which a running delay ends; `never` where none runs.
    Time next_end() const;
    /// X of every step, then the outputs.
    std::vector<bool> shown() const;
    /// Of every net.
    std::vector<bool> values() const { return {state_.values.begin(), state_.values.end()}; }

  private:
    /// All that the next tick depends on.
    struct State {
        std::vector<std::uint8_t> values;  ///< per net
        std::vector<std::vector<std::uint8_t>>
            seen;                               ///< per cell that asks for it: its pins, last tick
        std::vector<std::uint32_t> pulse_left;  ///< per cell: ticks for which its pulse goes on
        std::vector<Time> due;                  ///< per cell: when its delay ends, or `never`
        bool operator==(const State&) const = default;
    };

    void power_up(const std::vector<bool>& values);
    bool start_by_init(const InputValues& inputs, const std::vector<bool>& values);
    bool start_held(const InputValues& inputs, const std::vector<bool>& values);
    void hold_memories();
    void hold_steps();
    void set_inputs(const InputValues& inputs);
    void set_control(ControlInput control, bool value);
    void end_delays();
    bool foreseen(NetId net, std::map<NetId, bool>& known) const;

    bool tick();
    bool settle();
    bool cycle();
    bool cycle_until_stable();
    /// Repeats a step until it changes nothing; false where a state comes back before.
    bool repeat(const std::function<bool()>& step);

    bool pin(const Cell& cell, std::size_t number) const;
    bool next_value(std::size_t number, const Cell& cell);
    bool timed(Time& due, const Timing& timing, bool operand, bool shown) const;
    bool clocked_timed(Time& due, const Timing& timing, bool operand, bool shown) const;
    bool pulse(std::size_t number, const Cell& cell);
    bool look_ahead(std::size_t number, const Cell& cell, bool rises);

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    std::vector<NetId> inputs_;  ///< no_net where there is no such port
    std::vector<NetId> shown_;
    bool has_pulses_ = false;

    State state_;
    std::vector<std::uint8_t> held_;  ///< per net: keeps its value whatever its cell says
    bool pulses_held_ = false;
    bool pulses_remember_ = false;  ///< while held, they keep what they saw
    Time now_ = 0;
};

}  // namespace grafwire::testing
