// The cells that are more than a gate: latches, flip-flops, timers, and in the second half of the
// file pulse cells. The kernel evaluates them from their pins (evaluate_special), not from the
// counts in their words.
//
// Clocked cells take their data as it was when they were last evaluated before the clock's rise:
// any change of the data pin evaluates them, so that is the value of the tick before. While the
// clock is unknown it may rise at any time, and take the data as it was until now or as it is
// from now on.
//
// A timer whose operand is unknown is taken to have begun its delay, but towards unknown: before it
// ends the output cannot have changed, from then on it may have. Where the operand becomes known
// only at a later instant, the delay may have begun at either, and the output becomes unknown at
// once. Operands that are unknown for a few nanoseconds after power-up thus do no harm.
//
// The look-ahead of a clocked timer keeps the same delay as that timer, from the same times, and
// shows between two rises of the clock what the timer will make of its operand at the next. Where
// it is not known whether a delay is running, or since when, its delay is lost: none is running,
// but towards unknown.

#include <algorithm>

#include "simulate/kernel.h"

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

std::uint8_t Simulator::Kernel::evaluate_flip_flop(MemoryCell& cell) {
    const Logic clock = values_[cell.control];
    Logic taken = aimed_value(cell.node);
    switch (rise_between(cell.control_seen, clock)) {
        case Edge::absent:
            break;
        case Edge::certain:
            taken = cell.data_seen;
            break;
        case Edge::possible:
            taken = agreed(cell.data_seen, taken);
            break;
    }
    if (clock == Logic::unknown) taken = agreed(values_[cell.data], taken);
    return static_cast<std::uint8_t>(taken);
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
    const Logic clock = values_[cell.control];
    const Edge rise = rise_between(cell.control_seen, clock);
    if (rise == Edge::certain) return count_scan(cell.detail, cell.data_seen, aimed);
    // A rise that may have been, or may come, changes nothing where the timer is at rest.
    const bool may_have_risen = rise == Edge::possible;
    const bool may_rise = clock == Logic::unknown;
    if (!may_have_risen && !may_rise) return no_change;
    Time& due = due_[cell.detail];
    const bool rests = due == never && (!may_have_risen || cell.data_seen == aimed) &&
                       (!may_rise || values_[cell.data] == aimed);
    if (rests) return no_change;
    due = never;
    return static_cast<std::uint8_t>(Logic::unknown);
}

bool Simulator::Kernel::is_lost(std::size_t timer) const {
    return due_[timer] == never && towards_[timer] == Logic::unknown;
}

void Simulator::Kernel::lose_delay(std::size_t timer) {
    due_[timer] = never;
    towards_[timer] = Logic::unknown;
}

/// Whether a timer that shows `shown` takes a new value of its operand at once, if that is one.
bool Simulator::Kernel::follows_at_once(std::size_t timer, Logic operand, Logic shown) const {
    const Logic next = operand == Logic::unknown ? ~shown : operand;
    if (next == Logic::unknown) return false;
    return next == shown || (next == Logic::one ? rise_delays_ : fall_delays_)[timer] == 0;
}

/// What the delay of a look-ahead becomes when the clock rises.
void Simulator::Kernel::count_ahead(std::size_t timer, Logic operand, Logic shown) {
    Time& due = due_[timer];
    Logic& towards = towards_[timer];
    if (follows_at_once(timer, operand, shown)) {
        due = never;
        towards = Logic::zero;
        return;
    }
    if (is_lost(timer)) return;
    if (shown == Logic::unknown) return lose_delay(timer);
    const Time delay = (shown == Logic::zero ? rise_delays_ : fall_delays_)[timer];
    const Time end = add_times(instant_, delay);
    if (due == never || towards == shown) {
        due = end;
        towards = operand;
    } else if (operand == Logic::unknown) {
        towards = operand;  // the running delay may or may not go on
    } else if (towards == Logic::unknown && due != end) {
        return lose_delay(timer);  // it may have begun at either instant
    } else {
        towards = operand;
    }
    if (due <= instant_) due = never;
}

/// What a look-ahead is to show: what the timer would if the clock rose now.
Logic Simulator::Kernel::looked_ahead(std::size_t timer, Logic operand, Logic shown) const {
    if (follows_at_once(timer, operand, shown)) return operand;
    if (shown == Logic::unknown || is_lost(timer)) return Logic::unknown;
    const bool ends = due_[timer] <= instant_ && towards_[timer] != shown;
    return ends ? agreed(towards_[timer], operand) : shown;
}

std::uint8_t Simulator::Kernel::evaluate_scan_timer_next(MemoryCell& cell) {
    const std::size_t timer = cell.detail;
    const Logic clock = values_[cell.control];
    // After a rise that may or may not have been, only what it leaves at rest is known.
    const auto count_perhaps = [&](Logic operand, Logic shown) {
        const bool rested = due_[timer] == never && !is_lost(timer);
        count_ahead(timer, operand, shown);
        if (!rested || due_[timer] != never) lose_delay(timer);
    };
    const Edge rise = rise_between(cell.control_seen, clock);
    if (rise == Edge::certain) count_ahead(timer, cell.data_seen, cell.held_seen);
    if (rise == Edge::possible) count_perhaps(cell.data_seen, cell.held_seen);
    cell.held_seen = values_[cell.held];
    if (clock == Logic::unknown) count_perhaps(values_[cell.data], cell.held_seen);
    return static_cast<std::uint8_t>(looked_ahead(timer, values_[cell.data], cell.held_seen));
}

// Pulse cells: after each edge of the input, the output is 1 for the width, a delay later.
//
// An edge that may or may not take place at some tick makes the output unknown where it would make
// it 1. From unknown to unknown there may be an edge at every tick. So from the tick at which the
// input becomes unknown the output is so too, a delay later, and stays so until the last tick at
// which there may have been an edge is a delay and a width ago. In a state that is restored it is
// as if the input had been unknown since always: the wiring may be at rest with it, but what is
// unknown may change at any time, between two instants as well. The known spans of a pulse have
// ended wherever a state is saved, so the state needs to hold no more than the values.

namespace {

/// Adds a span, as one with those that it meets. It may begin before spans that are there already:
/// the delay of the cell has become shorter.
template <typename Spans>
void add_span(Spans& spans, Tick from, Tick to) {
    auto first = spans.begin();
    while (first != spans.end() && first->to < from) ++first;
    auto last = first;
    for (; last != spans.end() && last->from <= to; ++last) {
        from = std::min(from, last->from);
        to = std::max(to, last->to);
    }
    spans.insert(spans.erase(first, last), {from, to});
}

template <typename Spans>
bool covers(const Spans& spans, Tick tick) {
    return std::any_of(spans.begin(), spans.end(),
                       [tick](const auto& span) { return span.from <= tick && tick < span.to; });
}

}  // namespace

Logic Simulator::Kernel::pulse_value(const Pulse& pulse, Tick tick) {
    if (covers(pulse.certain, tick)) return Logic::one;
    const bool is_possible = pulse.open_from <= tick || covers(pulse.possible, tick);
    return is_possible ? Logic::unknown : Logic::zero;
}

void Simulator::Kernel::evaluate_pulse(MemoryCell& cell) {
    Pulse& pulse = pulses_[cell.detail];
    const auto is_over = [this](const Span& span) { return span.to <= tick_; };
    std::erase_if(pulse.certain, is_over);
    std::erase_if(pulse.possible, is_over);

    const Logic seen = cell.data_seen;
    const Logic input = values_[cell.data];
    const Edge edge = types_[cell.node] == CellType::rise_pulse ? rise_between(seen, input)
                                                                : fall_between(seen, input);
    const Tick from = tick_ + pulse.delay;
    if (pulses_held_) {
        if (input != Logic::unknown) pulse.open_from = no_tick;
    } else if (input == Logic::unknown) {
        const bool is_first_edge_later = seen != Logic::unknown && edge == Edge::absent;
        if (pulse.open_from == no_tick) pulse.open_from = is_first_edge_later ? from + 1 : from;
    } else {
        if (pulse.open_from < from) {
            // There may have been an edge at the tick before.
            add_span(pulse.possible, pulse.open_from, from - 1 + pulse.width);
        }
        pulse.open_from = no_tick;
        if (edge == Edge::possible) add_span(pulse.possible, from, from + pulse.width);
        if (edge == Edge::certain) add_span(pulse.certain, from, from + pulse.width);
    }
    drop_change(cell.node);
    if ((words_[cell.node] & forced_flag) == 0) aim_pulse(pulse);
}

/// Makes the next tick at which the output differs from what it is the pending change.
void Simulator::Kernel::aim_pulse(Pulse& pulse) {
    const std::uint32_t net = memories_[pulse.memory].node;
    const auto consider = [&](Tick tick) {
        if (tick <= tick_ || tick >= pulse.due) return;
        if (pulse_value(pulse, tick) != values_[net]) pulse.due = tick;
    };
    for (const Spans* spans : {&pulse.certain, &pulse.possible}) {
        for (const Span& span : *spans) {
            consider(span.from);
            consider(span.to);
        }
    }
    if (pulse.open_from != no_tick) consider(pulse.open_from);
    // Without an edge the output differs from what it should be only where it was forced, or where
    // the input has become known while pulses are held.
    if (pulse_value(pulse, tick_) != values_[net]) consider(tick_ + pulse.delay);
    if (pulse.due == no_tick) return;
    ++live_;
    wheel_.add_far(pulse.due, net);
}

/// Once all has settled, any time may pass without a tick.
void Simulator::Kernel::rest_pulses() {
    for (Pulse& pulse : pulses_) {
        if (pulse.open_from == no_tick) continue;
        pulse.possible.clear();
        pulse.open_from = std::min(pulse.open_from, tick_);
    }
}

/// Takes the input for what it has been since always.
void Simulator::Kernel::look_at_pulse_input(Pulse& pulse) {
    const MemoryCell& cell = memories_[pulse.memory];
    pulse.certain.clear();
    pulse.possible.clear();
    pulse.open_from = no_tick;
    if (pulses_held_ || values_[cell.data] != Logic::unknown) return;
    const bool is_open = values_[cell.node] == Logic::unknown;
    pulse.open_from = is_open ? tick_ : tick_ + pulse.delay;
    if (!is_open) touch(cell.node);
}

/// What is to happen to a pulse cell by itself, for the comparison of states.
void Simulator::Kernel::append_coming(const Pulse& pulse, std::uint32_t net, Tick now,
                                      std::vector<ComingChange>& coming) {
    const auto append = [&](Tick tick, std::uint32_t what) {
        if (tick > now) coming.push_back({tick - now, net, what});
    };
    for (const Span& span : pulse.certain) {
        append(span.from, 4);
        append(span.to, 5);
    }
    for (const Span& span : pulse.possible) {
        append(span.from, 6);
        append(span.to, 7);
    }
    if (pulse.open_from != no_tick) append(pulse.open_from, 8);
}

void Simulator::Kernel::release_pulses() {
    pulses_held_ = false;
    pulses_remember_ = false;
    // Cells look again once they may fire. What they remember of the time before the initialisation
    // may differ from what they see, and an input that is unknown may change from now on; an input
    // at rest would give them no other occasion.
    for (const Pulse& pulse : pulses_) touch(memories_[pulse.memory].node);
}

}  // namespace grafwire
