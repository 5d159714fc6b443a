#include "referee/gate_simulator.h"

#include <algorithm>
#include <span>
#include <utility>

// Two things are more than a table of gates.
//
// Time conditions count from the instant at which their operand changed, so `now_` stands still
// while the gates tick. A delay that ends at an instant does so before the first tick: the inputs
// have changed, and the timer takes its operand if that, read under the new inputs, still asks for
// it. The operand has not been worked out by the gates then; foreseen() reads it through them.
//
// Before the first instant the inputs have been what they are since always. With modes, Init = 1
// brings about the situation; pulse cells must not take the changes this needs for edges, so they
// compare with what they see while the steps are held at the initial situation under the inputs as
// they really are.

namespace grafwire::testing {

namespace {

NetId net_named(const std::vector<Port>& ports, std::string_view name) {
    for (const Port& port : ports) {
        if (port.name == name) return port.net;
    }
    return no_net;
}

bool gives_pulses(CellType type) {
    return type == CellType::rise_pulse || type == CellType::fall_pulse;
}

bool is_gate(const Cell& cell) {
    const CellTypeRow& row = row_of(cell.type);
    return !row.has_memory && !row.has_timing;
}

/// What a gate makes of its pins, each read by `value`.
template <typename Value>
bool gate(CellType type, std::span<const NetId> pins, Value value) {
    std::size_t ones = 0;
    for (const NetId net : pins) ones += value(net) ? 1 : 0;
    switch (type) {
        case CellType::high:
            return true;
        case CellType::buffer:
        case CellType::or_gate:
            return ones != 0;
        case CellType::inverter:
        case CellType::nor_gate:
            return ones == 0;
        case CellType::and_gate:
            return ones == pins.size();
        case CellType::nand_gate:
            return ones != pins.size();
        case CellType::xor_gate:
            return ones % 2 == 1;
        default:
            return false;
    }
}

}  // namespace

GateSimulator::GateSimulator(const Grafcet& grafcet, const Netlist& netlist)
    : grafcet_(grafcet), netlist_(netlist) {
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        inputs_.push_back(net_named(netlist.inputs, input_name(grafcet, i)));
    }
    for (const Step& step : grafcet.steps) {
        shown_.push_back(net_named(netlist.outputs, "X" + step.name));
    }
    for (const Output& output : grafcet.outputs) {
        shown_.push_back(net_named(netlist.outputs, output.name));
    }
    for (const Cell& cell : netlist.cells) has_pulses_ = has_pulses_ || gives_pulses(cell.type);
}

std::vector<bool> GateSimulator::shown() const {
    std::vector<bool> values;
    for (const NetId net : shown_) values.push_back(state_.values[index_of(net)] != 0);
    return values;
}

Time GateSimulator::next_end() const {
    return state_.due.empty() ? never : *std::min_element(state_.due.begin(), state_.due.end());
}

// Power-up.

void GateSimulator::power_up(const std::vector<bool>& values) {
    now_ = 0;
    state_.values.assign(values.begin(), values.end());
    for (const Cell& cell : netlist_.cells) {
        if (!row_of(cell.type).has_memory || cell.initial == Logic::unknown) continue;
        state_.values[index_of(cell.output)] = cell.initial == Logic::one ? 1 : 0;
    }
    for (const auto& [net, value] : netlist_.initial_values) {
        state_.values[index_of(net)] = value ? 1 : 0;
    }
    for (const Cell& cell : netlist_.cells) {
        if (gives_pulses(cell.type)) state_.values[index_of(cell.output)] = 0;
    }
    state_.pulse_left.assign(netlist_.cells.size(), 0);
    state_.due.assign(netlist_.cells.size(), never);
    state_.seen.resize(netlist_.cells.size());
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        const Cell& cell = netlist_.cells.items()[i];
        if (is_gate(cell) || (gives_pulses(cell.type) && pulses_remember_)) continue;
        state_.seen[i].clear();
        for (const NetId net : netlist_.pins_of(cell)) {
            state_.seen[i].push_back(state_.values[index_of(net)]);
        }
    }
    held_.assign(netlist_.net_count(), 0);
}

void GateSimulator::hold_memories() {
    for (const Cell& cell : netlist_.cells) {
        if (row_of(cell.type).has_memory && cell.initial != Logic::unknown) {
            held_[index_of(cell.output)] = 1;
        }
    }
    for (const auto& initial : netlist_.initial_values) held_[index_of(initial.net)] = 1;
}

void GateSimulator::hold_steps() {
    for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
        held_[index_of(shown_[i])] = 1;
        state_.values[index_of(shown_[i])] = grafcet_.steps.items()[i].initial ? 1 : 0;
    }
}

bool GateSimulator::start(const InputValues& inputs, const std::vector<bool>& values) {
    pulses_held_ = true;
    const NetId init = inputs_[grafcet_.inputs.size()];
    const bool by_init = netlist_.has_modes && init != no_net && !netlist_.is_clocked();
    const bool settled = by_init ? start_by_init(inputs, values) : start_held(inputs, values);
    pulses_held_ = false;
    pulses_remember_ = false;
    return settled;
}

bool GateSimulator::start_by_init(const InputValues& inputs, const std::vector<bool>& values) {
    if (has_pulses_) {
        power_up(values);
        set_inputs(inputs);
        hold_memories();
        hold_steps();
        pulses_remember_ = settle();
    }
    power_up(values);
    set_inputs(inputs);
    set_control(ControlInput::init, true);
    set_control(ControlInput::au_dur, false);
    set_control(ControlInput::au_doux, false);
    hold_memories();
    settle();  // what swings as long as memories are held may come to rest once they are let go
    held_.assign(netlist_.net_count(), 0);
    return settle();
}

bool GateSimulator::start_held(const InputValues& inputs, const std::vector<bool>& values) {
    const bool has_init = netlist_.has_modes && inputs_[grafcet_.inputs.size()] != no_net;
    power_up(values);
    set_inputs(inputs);
    if (netlist_.is_clocked()) state_.values[index_of(netlist_.clock)] = 0;
    hold_memories();
    if (!has_init) hold_steps();
    if (!settle()) return false;
    held_.assign(netlist_.net_count(), 0);
    const bool needs_init =
        std::any_of(netlist_.cells.begin(), netlist_.cells.end(), [](const Cell& cell) {
            return cell.type == CellType::flip_flop && cell.initial == Logic::unknown;
        });
    if (!has_init || !needs_init) return true;
    set_control(ControlInput::init, true);
    set_control(ControlInput::au_dur, false);
    set_control(ControlInput::au_doux, false);
    if (!cycle()) return false;
    set_inputs(inputs);
    return settle();
}

// Instants and scans.

void GateSimulator::set_inputs(const InputValues& inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (inputs_[i] != no_net) state_.values[index_of(inputs_[i])] = inputs[i] != 0 ? 1 : 0;
    }
}

void GateSimulator::set_control(ControlInput control, bool value) {
    const NetId net = inputs_[grafcet_.inputs.size() + static_cast<std::size_t>(control)];
    if (net != no_net) state_.values[index_of(net)] = value ? 1 : 0;
}

/// What a net comes to under the inputs as they are, with all that is remembered as it is.
bool GateSimulator::foreseen(NetId net, std::map<NetId, bool>& known) const {
    if (const auto found = known.find(net); found != known.end()) return found->second;
    known[net] = state_.values[index_of(net)] != 0;
    for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
        if (shown_[i] == net) return known[net];
    }
    for (const Cell& cell : netlist_.cells) {
        if (cell.output != net || !is_gate(cell)) continue;
        known[net] = gate(cell.type, netlist_.pins_of(cell),
                          [&](NetId pin_net) { return foreseen(pin_net, known); });
    }
    return known[net];
}

void GateSimulator::end_delays() {
    std::vector<std::size_t> ending;
    std::map<NetId, bool> known;
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        if (state_.due[i] > now_) continue;
        const Cell& cell = netlist_.cells.items()[i];
        const NetId held =
            cell.type == CellType::scan_timer_next ? netlist_.pins_of(cell)[1] : cell.output;
        const bool shown = state_.values[index_of(held)] != 0;
        if (foreseen(netlist_.pins_of(cell)[0], known) != shown) ending.push_back(i);
    }
    for (const std::size_t i : ending) {
        state_.due[i] = never;
        const Cell& cell = netlist_.cells.items()[i];
        if (cell.type != CellType::scan_timer_next) state_.values[index_of(cell.output)] ^= 1U;
    }
}

bool GateSimulator::instant(Time now, const InputValues& inputs) {
    now_ = now;
    set_inputs(inputs);
    if (now > 0) end_delays();
    return netlist_.is_clocked() ? cycle_until_stable() : settle();
}

bool GateSimulator::scan(Time now, const InputValues& inputs) {
    now_ = now;
    set_inputs(inputs);
    return cycle();
}

bool GateSimulator::cycle() {
    if (!settle()) return false;
    for (const bool level : {true, false}) {
        state_.values[index_of(netlist_.clock)] = level ? 1 : 0;
        if (!settle()) return false;
    }
    return true;
}

bool GateSimulator::repeat(const std::function<bool()>& step) {
    State landmark = state_;
    for (std::uint64_t count = 1, next_landmark = 64;; ++count) {
        if (!step()) return true;
        if (state_ == landmark) return false;
        if (count == next_landmark) {
            landmark = state_;
            next_landmark *= 2;
        }
    }
}

bool GateSimulator::settle() {
    return repeat([&] { return tick(); });
}

bool GateSimulator::cycle_until_stable() {
    bool settles = settle();
    const bool ends = settles && repeat([&] {
                          const State before = state_;
                          settles = cycle();
                          return settles && !(state_ == before);
                      });
    return settles && ends;
}

// A tick.

bool GateSimulator::tick() {
    bool is_alive = false;
    std::vector<std::uint8_t> next = state_.values;
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        const Cell& cell = netlist_.cells.items()[i];
        const std::size_t net = index_of(cell.output);
        const bool value = held_[net] != 0 ? state_.values[net] != 0 : next_value(i, cell);
        next[net] = value ? 1 : 0;
        is_alive =
            is_alive || next[net] != state_.values[net] || (gives_pulses(cell.type) && value);
        if (state_.seen[i].empty() ||
            (gives_pulses(cell.type) && pulses_held_ && pulses_remember_)) {
            continue;
        }
        for (std::size_t p = 0; p < cell.pin_count; ++p) state_.seen[i][p] = pin(cell, p) ? 1 : 0;
    }
    state_.values = std::move(next);
    return is_alive;
}

bool GateSimulator::pin(const Cell& cell, std::size_t number) const {
    return state_.values[index_of(netlist_.pins[cell.first_pin + number])] != 0;
}

bool GateSimulator::next_value(std::size_t number, const Cell& cell) {
    if (is_gate(cell)) {
        return gate(cell.type, netlist_.pins_of(cell),
                    [&](NetId net) { return state_.values[index_of(net)] != 0; });
    }
    const bool shown = state_.values[index_of(cell.output)] != 0;
    const std::vector<std::uint8_t>& seen = state_.seen[number];
    const bool rises =
        row_of(cell.type).is_clocked && seen.back() == 0 && pin(cell, cell.pin_count - 1);
    switch (cell.type) {
        case CellType::latch:
            return pin(cell, 0) || (!pin(cell, 1) && shown);
        case CellType::hold_latch:
            return pin(cell, 1) ? pin(cell, 0) : shown;
        case CellType::flip_flop:
            return rises ? seen[0] != 0 : shown;
        case CellType::timer:
            return timed(state_.due[number], netlist_.timings[cell.timing], pin(cell, 0), shown);
        case CellType::scan_timer:
            if (!rises) return shown;
            return clocked_timed(state_.due[number], netlist_.timings[cell.timing], seen[0] != 0,
                                 shown);
        case CellType::scan_timer_next:
            return look_ahead(number, cell, rises);
        default:
            return pulse(number, cell);
    }
}

/// What a timer is to show at the next tick, and when its delay ends.
bool GateSimulator::timed(Time& due, const Timing& timing, bool operand, bool shown) const {
    const Time delay = operand ? timing.rise : timing.fall;
    if (operand == shown || delay == 0) {
        due = never;
        return operand;
    }
    if (due == never) due = add_times(now_, delay);
    return shown;
}

/// The same at a rise of the clock, where delays end as well.
bool GateSimulator::clocked_timed(Time& due, const Timing& timing, bool operand, bool shown) const {
    const bool value = timed(due, timing, operand, shown);
    if (due > now_) return value;
    due = never;
    return operand;
}

/// The look-ahead counts along with its timer, and shows what that will be.
bool GateSimulator::look_ahead(std::size_t number, const Cell& cell, bool rises) {
    const Timing& timing = netlist_.timings[cell.timing];
    const std::vector<std::uint8_t>& seen = state_.seen[number];
    if (rises) clocked_timed(state_.due[number], timing, seen[0] != 0, seen[1] != 0);
    Time due = state_.due[number];
    return clocked_timed(due, timing, pin(cell, 0), pin(cell, 1));
}

bool GateSimulator::pulse(std::size_t number, const Cell& cell) {
    const bool from = state_.seen[number][0] != 0;
    const bool to = pin(cell, 0);
    const bool is_edge = cell.type == CellType::rise_pulse ? !from && to : from && !to;
    std::uint32_t& left = state_.pulse_left[number];
    if (is_edge && !pulses_held_) {
        left = static_cast<std::uint32_t>(netlist_.timings[cell.timing].fall / nanosecond);
    }
    if (left == 0) return false;
    --left;
    return true;
}

}  // namespace grafwire::testing
