#include <algorithm>
#include <array>

#include "simulate/kernel.h"

// The cells that are more than a gate: latches, flip-flops, pulse cells, timers.
//
// Clocked cells take their data as it was when they were last evaluated before the clock's rise:
// any change of the data pin evaluates them, so that is the value of the moment before.
//
// A timer whose operand is unknown is taken to have begun its delay, but towards unknown: before it
// ends the output cannot have changed, from then on it may have. Where the operand becomes known
// only at a later instant, the delay may have begun at either, and the output becomes unknown at
// once. Operands that are unknown for a few nanoseconds after power-up thus do no harm.
//
// The look-ahead of a clocked timer keeps the same delay as that timer, from the same moments, and
// shows between two rises of the clock what the timer will make of its operand at the next.

namespace grafwire {

std::uint8_t Simulator::Kernel::evaluate_special(std::uint32_t net) {
    const bool is_forced = (words_[net] & forced_flag) != 0;
    if (memory_of_[net] == no_memory) {
        const bool is_xor = types_[net] == CellType::xor_gate && !is_forced;
        return is_xor ? static_cast<std::uint8_t>(xor_value(words_[net])) : no_change;
    }
    MemoryCell& cell = memories_[memory_of_[net]];
    const Logic data = values_[cell.data];
    const Logic control = values_[cell.control];
    std::uint8_t target = no_change;
    switch (types_[net]) {
        case CellType::latch:
            target = static_cast<std::uint8_t>(latch_value(data, control, values_[net]));
            break;
        case CellType::hold_latch:
            target = static_cast<std::uint8_t>(hold_latch_value(data, control, values_[net]));
            break;
        case CellType::flip_flop:
            target = evaluate_flip_flop(cell);
            break;
        case CellType::scan_timer:
            if (!is_forced) target = evaluate_scan_timer(cell);
            break;
        case CellType::scan_timer_next:
            if (!is_forced) target = evaluate_scan_timer_next(cell);
            break;
        case CellType::timer:
            if (!is_forced) target = evaluate_timer(cell.detail, data, aimed_value(net));
            break;
        case CellType::rise_pulse:
        case CellType::fall_pulse:
            evaluate_pulse(cell);
            break;
        default:
            break;
    }
    if (!(pulses_held_ && pulses_remember_)) cell.data_seen = data;
    cell.control_seen = control;
    return is_forced ? no_change : target;
}

/// What the output of a cell is, or is about to be.
Logic Simulator::Kernel::aimed_value(std::uint32_t net) const {
    if (uniform_ || timings_[net].pending == no_change) return values_[net];
    return static_cast<Logic>(timings_[net].pending);
}

std::uint8_t Simulator::Kernel::evaluate_flip_flop(MemoryCell& cell) {
    const Logic held = aimed_value(cell.node);
    switch (rise_between(cell.control_seen, values_[cell.control])) {
        case Edge::none:
            return no_change;
        case Edge::certain:
            return static_cast<std::uint8_t>(cell.data_seen);
        default:
            return static_cast<std::uint8_t>(agreed(cell.data_seen, held));
    }
}

/// What a timer is to show at once, given its operand and what it shows or is about to show.
std::uint8_t Simulator::Kernel::evaluate_timer(std::size_t timer, Logic operand, Logic aimed) {
    Time& due = due_[timer];
    Logic& towards = towards_[timer];
    if (operand == aimed) {
        due = never;
        return static_cast<std::uint8_t>(operand);
    }
    const bool rises = operand == Logic::one || (operand != Logic::zero && aimed == Logic::zero);
    const Time delay = rises ? rise_delays_[timer] : fall_delays_[timer];
    if (delay == 0) {
        due = never;
        return static_cast<std::uint8_t>(operand);
    }
    const Time end = add_times(instant_, delay);
    if (due != never && towards != operand && operand == Logic::unknown &&
        aimed != Logic::unknown) {
        towards = operand;  // the running delay may or may not go on
        return no_change;
    }
    const bool doubtful = due != never && towards == Logic::unknown && due != end;
    if (due == never || towards != operand) {
        due = end;
        towards = operand;
    }
    return doubtful && operand != Logic::unknown ? static_cast<std::uint8_t>(Logic::unknown)
                                                 : no_change;
}

/// What a clocked timer is to show after a rise of the clock, given its operand and what it shows.
std::uint8_t Simulator::Kernel::count_scan(std::size_t timer, Logic operand, Logic shown) {
    const std::uint8_t target = evaluate_timer(timer, operand, shown);
    if (due_[timer] > instant_) return target;
    due_[timer] = never;
    return static_cast<std::uint8_t>(towards_[timer]);
}

std::uint8_t Simulator::Kernel::evaluate_scan_timer(MemoryCell& cell) {
    const Logic aimed = aimed_value(cell.node);
    Time& due = due_[cell.detail];
    switch (rise_between(cell.control_seen, values_[cell.control])) {
        case Edge::none:
            return no_change;
        case Edge::certain:
            return count_scan(cell.detail, cell.data_seen, aimed);
        default:
            if (cell.data_seen == aimed && due == never) return no_change;
            due = never;
            return static_cast<std::uint8_t>(Logic::unknown);
    }
}

std::uint8_t Simulator::Kernel::evaluate_scan_timer_next(MemoryCell& cell) {
    switch (rise_between(cell.control_seen, values_[cell.control])) {
        case Edge::none:
            break;
        case Edge::certain:
            count_scan(cell.detail, cell.data_seen, cell.held_seen);
            break;
        default:
            due_[cell.detail] = never;
            break;
    }
    cell.held_seen = values_[cell.held];
    // As if the clock rose now.
    const Time due = due_[cell.detail];
    const Logic towards = towards_[cell.detail];
    const std::uint8_t next = count_scan(cell.detail, values_[cell.data], cell.held_seen);
    due_[cell.detail] = due;
    towards_[cell.detail] = towards;
    return next == no_change ? static_cast<std::uint8_t>(cell.held_seen) : next;
}

Logic Simulator::Kernel::pulse_value(const Pulse& pulse, Tick tick) {
    if (pulse.certain_from <= tick && tick < pulse.certain_to) return Logic::one;
    if (pulse.possible_from <= tick && tick < pulse.possible_to) return Logic::unknown;
    return Logic::zero;
}

void Simulator::Kernel::evaluate_pulse(MemoryCell& cell) {
    const Logic input = values_[cell.data];
    const Edge edge = types_[cell.node] == CellType::rise_pulse
                          ? rise_between(cell.data_seen, input)
                          : fall_between(cell.data_seen, input);
    Pulse& pulse = pulses_[cell.detail];
    if (edge != Edge::none && !pulses_held_) fire(pulse, edge);
    aim_pulse(pulse);
}

void Simulator::Kernel::fire(Pulse& pulse, Edge edge) {
    const Tick from = tick_ + pulse.delay;
    const Tick to = from + pulse.width;
    Tick& start = edge == Edge::certain ? pulse.certain_from : pulse.possible_from;
    Tick& end = edge == Edge::certain ? pulse.certain_to : pulse.possible_to;
    if (tick_ >= end) start = from;
    end = to;
}

/// Makes the next moment at which the output differs from what it is the pending change.
void Simulator::Kernel::aim_pulse(Pulse& pulse) {
    const std::uint32_t net = memories_[pulse.memory].node;
    drop_change(net);
    std::array<Tick, 4> bounds{pulse.certain_from, pulse.certain_to, pulse.possible_from,
                               pulse.possible_to};
    std::sort(bounds.begin(), bounds.end());
    for (const Tick bound : bounds) {
        if (bound <= tick_ || pulse_value(pulse, bound) == values_[net]) continue;
        pulse.due = bound;
        pulse.pending = static_cast<std::uint8_t>(pulse_value(pulse, bound));
        ++live_;
        wheel_.add_far(bound, net);
        return;
    }
}

void Simulator::Kernel::doubt_unknown_pulses() {
    for (Pulse& pulse : pulses_) {
        if (values_[memories_[pulse.memory].data] != Logic::unknown) continue;
        fire(pulse, Edge::possible);
        aim_pulse(pulse);
    }
}

void Simulator::Kernel::hold_pulses(bool on) {
    pulses_held_ = on;
    if (on) return;
    // Cells that remember what they saw before the initialisation look again once they may fire:
    // an input that has come to rest since would give them no other occasion.
    if (pulses_remember_) {
        for (const Pulse& pulse : pulses_) touch(memories_[pulse.memory].node);
    }
    pulses_remember_ = false;
}

void Simulator::Kernel::remember_pulse_inputs() {
    pulses_remember_ = true;
}

}  // namespace grafwire
