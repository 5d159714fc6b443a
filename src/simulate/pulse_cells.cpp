// Pulse cells: after each edge of the input, the output is 1 for the width, a delay later.
//
// An edge that may or may not take place at some tick makes the output unknown where it would make
// it 1. From unknown to unknown there may be an edge at every tick. So from the tick at which the
// input becomes unknown the output is so too, a delay later, and stays so until the last tick at
// which there may have been an edge is a delay and a width ago. In a state that is restored it is
// as if the input had been unknown since always: the wiring may be at rest with it, but what is
// unknown may change at any time, between two instants as well. The known spans of a pulse have
// ended wherever a state is saved, so the state needs to hold no more than the values.

#include <algorithm>

#include "simulate/kernel.h"

namespace grafwire {

namespace {

/// Adds a span that begins no earlier than those there are.
template <typename Spans>
void add_span(Spans& spans, Tick from, Tick to) {
    if (!spans.empty() && from <= spans.back().to) {
        spans.back().to = std::max(spans.back().to, to);
    } else {
        spans.push_back({from, to});
    }
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
