// From power-up to the state in which a netlist starts
//
// The reference deems all inputs to have been what they are since always: nothing has an edge at
// the start, and stored outputs, vars and time conditions are 0. So pulse cells are held, and every
// cell or net that has an initial value is held at it while the gates work out the rest. With modes
// the situation comes about as on a real machine, by Init = 1 alone; without, the steps are held
// too, and let go as the first instant begins: what evolves from the initial situation belongs to
// that.
//
// The control inputs are no exception to "since always", although Init has to be 1 first: an edge
// of Init or AUdur in a receptivity must not see the first instant as a change. Where there are
// pulse cells, the netlist is therefore powered up twice. The first time all inputs have their true
// values and the steps are held at the initial situation; what the pulse cells see then is what
// they compare with from the first instant on.

#include "simulate/netlist_machine.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace grafwire {

namespace {

using NetsByName = std::unordered_map<std::string_view, NetId>;

NetsByName nets_by_name(const std::vector<Port>& ports) {
    NetsByName nets;
    for (const Port& port : ports) nets.emplace(port.name, port.net);
    return nets;
}

NetId find_net(const NetsByName& nets, std::string_view name) {
    const auto found = nets.find(name);
    return found == nets.end() ? no_net : found->second;
}

class Initialisation {
  public:
    Initialisation(Simulator& simulator, const Grafcet& grafcet, const Netlist& netlist,
                   const PortMap& ports)
        : simulator_(simulator),
          preparation_(simulator),
          grafcet_(grafcet),
          netlist_(netlist),
          ports_(ports) {
        const std::size_t first_control = ports.inputs.size() - control_input_count;
        init_ = ports.inputs[first_control + static_cast<std::size_t>(ControlInput::init)];
        au_dur_ = ports.inputs[first_control + static_cast<std::size_t>(ControlInput::au_dur)];
        au_doux_ = ports.inputs[first_control + static_cast<std::size_t>(ControlInput::au_doux)];
    }

    Settling make(const std::vector<Logic>& inputs) {
        const bool by_init = netlist_.has_modes && init_ != no_net;
        return by_init && !netlist_.is_clocked() ? start_by_init(inputs)
                                                 : start_held(inputs, by_init);
    }

  private:
    void set(NetId input, Logic value) {
        if (input != no_net) simulator_.set_input(input, value);
    }
    void set_all(const std::vector<Logic>& inputs) {
        if (netlist_.is_clocked()) simulator_.set_input(netlist_.clock, Logic::zero);
        ports_.set_inputs(simulator_, inputs);
    }
    void set_controls(Logic init) {
        set(init_, init);
        set(au_dur_, Logic::zero);
        set(au_doux_, Logic::zero);
    }

    void hold_memories() {
        for (const Cell& cell : netlist_.cells) {
            if (row_of(cell.type).has_memory && cell.initial != Logic::unknown) {
                preparation_.hold(cell.output, cell.initial);
            }
        }
        for (const Netlist::InitialValue& initial : netlist_.initial_values) {
            preparation_.hold(initial.net, logic_of(initial.value));
        }
    }
    void hold_steps() {
        for (std::size_t i = 0; i < ports_.steps.size(); ++i) {
            const bool initial = grafcet_.steps[grafcet_.steps.id_at(i)].initial;
            if (ports_.steps[i] == no_net) continue;
            preparation_.hold(ports_.steps[i], logic_of(initial));
        }
    }

    /// Settles with what is held, lets go and settles again.
    Settling settle_and_release() {
        Settling settling = simulator_.settle();
        if (!settling.settled) return settling;
        preparation_.release();
        return simulator_.settle();
    }

    bool has_pulse_cells() const {
        for (const Cell& cell : netlist_.cells) {
            if (cell.type == CellType::rise_pulse || cell.type == CellType::fall_pulse) return true;
        }
        return false;
    }

    Settling start_by_init(const std::vector<Logic>& inputs) {
        simulator_.power_up();
        if (has_pulse_cells()) {
            set_all(inputs);
            hold_memories();
            hold_steps();
            // If this does not settle, neither will the first instant.
            if (simulator_.settle().settled) {
                preparation_.power_up_again();
            } else {
                simulator_.power_up();
            }
        }
        set_all(inputs);
        set_controls(Logic::one);
        hold_memories();
        return settle_and_release();
    }

    /// Flip-flops without an initial value (of netlists from elsewhere) need a cycle with Init.
    bool is_known() const {
        for (const Cell& cell : netlist_.cells) {
            if (cell.type == CellType::flip_flop && cell.initial == Logic::unknown) return false;
        }
        return true;
    }

    Settling start_held(const std::vector<Logic>& inputs, bool has_init) {
        simulator_.power_up();
        set_all(inputs);
        hold_memories();
        if (!has_init && netlist_.starts_initially) hold_steps();
        Settling settling = simulator_.settle();
        preparation_.release();
        if (!has_init || !settling.settled || is_known()) return settling;
        set_controls(Logic::one);
        settling = simulator_.clock_cycle();
        if (!settling.settled) return settling;
        set_all(inputs);
        return simulator_.settle();
    }

    Simulator& simulator_;
    Preparation preparation_;
    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const PortMap& ports_;
    NetId init_ = no_net;
    NetId au_dur_ = no_net;
    NetId au_doux_ = no_net;
};

}  // namespace

PortMap map_ports(const Grafcet& grafcet, const Netlist& netlist) {
    const NetsByName inputs = nets_by_name(netlist.inputs);
    const NetsByName outputs = nets_by_name(netlist.outputs);
    PortMap ports;
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        ports.inputs.push_back(find_net(inputs, input_name(grafcet, i)));
    }
    for (const Step& step : grafcet.steps) {
        ports.steps.push_back(find_net(outputs, "X" + step.name));
    }
    for (const Output& output : grafcet.outputs) {
        ports.outputs.push_back(find_net(outputs, output.name));
    }
    return ports;
}

void PortMap::set_inputs(Simulator& simulator, const std::vector<Logic>& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (inputs[i] != no_net) simulator.set_input(inputs[i], values[i]);
    }
}

NetlistMachine::NetlistMachine(const Grafcet& grafcet, const Netlist& netlist,
                               const CellDelays& delays, const DelaySchedule& schedule)
    : grafcet_(grafcet),
      netlist_(netlist),
      simulator_(netlist, delays, schedule),
      delay_ends_(netlist),
      ports_(map_ports(grafcet, netlist)) {}

Settling NetlistMachine::start(const std::vector<Logic>& inputs) {
    return Initialisation(simulator_, grafcet_, netlist_, ports_).make(inputs);
}

void NetlistMachine::rest_under(const std::vector<Logic>& inputs) {
    const Preparation preparation(simulator_);
    ports_.set_inputs(simulator_, inputs);
    simulator_.settle();
}

void NetlistMachine::begin_instant(Time at, const std::vector<Logic>& inputs) {
    instant_ = at;
    simulator_.begin_instant(at);
    ports_.set_inputs(simulator_, inputs);
}

void NetlistMachine::end_delays() {
    delay_ends_.take_effect(simulator_, instant_);
}

Settling NetlistMachine::settle() {
    return delay_ends_.settle(simulator_, instant_);
}

Settling NetlistMachine::instant(Time at, const std::vector<Logic>& inputs) {
    begin_instant(at, inputs);
    if (at > 0) end_delays();
    return netlist_.is_clocked() ? settle_by_cycles() : settle();
}

Settling NetlistMachine::scan(Time at, const std::vector<Logic>& inputs) {
    begin_instant(at, inputs);
    return simulator_.clock_cycle();
}

/// Cycles that come back to a state they have been in are found as oscillations of gates are, by
/// Brent's scheme.
Settling NetlistMachine::settle_by_cycles() {
    Settling sum = simulator_.settle();
    SimulatorState before = simulator_.save();
    SimulatorState kept = before;
    std::uint64_t cycles = 0;
    std::uint64_t stretch = 1;
    while (sum.settled) {
        const Settling cycle = simulator_.clock_cycle();
        sum.events += cycle.events;
        sum.settled = cycle.settled;
        sum.oscillating = cycle.oscillating;
        if (!cycle.settled) break;
        SimulatorState after = simulator_.save();
        if (after == before) break;
        ++cycles;
        if (after == kept) {
            sum.settled = false;
            sum.oscillating = changing_in(cycles);
            break;
        }
        if (cycles == stretch) {
            kept = after;
            cycles = 0;
            stretch *= 2;
        }
        before = std::move(after);
    }
    return sum;
}

/// The nets whose values between the clock cycles differ during so many cycles.
std::vector<NetId> NetlistMachine::changing_in(std::uint64_t cycles) {
    const SimulatorState first = simulator_.save();
    std::vector<bool> changes(first.values.size(), false);
    for (; cycles > 1; --cycles) {
        simulator_.clock_cycle();
        const SimulatorState state = simulator_.save();
        for (std::size_t net = 0; net < changes.size(); ++net) {
            if (state.values[net] != first.values[net]) changes[net] = true;
        }
    }
    std::vector<NetId> nets;
    for (std::size_t net = 0; net < changes.size(); ++net) {
        if (changes[net]) nets.push_back(static_cast<NetId>(net));
    }
    return nets;
}

}  // namespace grafwire
