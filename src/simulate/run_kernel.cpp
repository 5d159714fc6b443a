// How the gates are simulated
//
// The method is event-driven selective trace (E. G. Ulrich, "Exclusive simulation of activity in
// digital networks", CACM 12, 1969) on a timing wheel. Each tick has two phases: first all
// changes of that tick are applied, then every cell with a changed input is evaluated once. So
// simultaneous changes are simultaneous, and the order of cells in the netlist decides nothing.
//
// What makes it fast:
// - Node and cell are one number. A change of a net touches 16 bytes that hold up to three readers,
//   and the word (evaluate_cell.h) of each reader; lists of readers are there for greater fan-out
//   only.
// - Applying a change adds one number to the word of each reader. If that leaves the row of its
//   table as it was, the reader need not even be evaluated, and evaluation is a look-up. So an
//   input that is read by 100 000 gates costs little where it decides none of them.
// - Lists are written without a branch: the entry is always written, and the size grows by a
//   condition.
// - If all delays are equal there is no wheel at all but two lists, and a gate can have no pending
//   change when it is evaluated: whatever it was aiming at has just been applied.
// - What is not always there (observer, watch for oscillation, unequal delays) is compiled out.
//
// Measured on one core of a shared two-core virtual AMD EPYC, in processor time: a ring of 1 000
// phase modules (four gates a step, a token every eight steps, all moved by alternating inputs)
// does 90 to 109 million changes of nets a second, one of 100 000 modules 50 to 70 million, one of
// a million 24 million; with delays of 1 to 5 ns at random, 64 and 14 million. By the profile
// (perf) of the first two, applying changes takes 57 to 60 % of the time, evaluation 21 to 25 %,
// and the inputs, each read by half of the modules, 13 to 19 %.
//
// A two-valued cell has one pending change at most (inertial delay): a re-evaluation that gives the
// present value again cancels it. So its output is 1 once its function has been 1 for the delay of
// the rise, 0 once it has been 0 for that of the fall, and else what it was: the more its function
// is 1, the more its output is. A value in three is therefore kept as two in two, the least and the
// greatest that the output can be (0 and 0, 1 and 1, or for unknown 0 and 1), each with a pending
// change of its own; one follows the least that the function can be, the other the greatest. That
// is neither too optimistic nor, for a cell by itself, too pessimistic.

#include <algorithm>
#include <cassert>

#include "simulate/kernel.h"

namespace grafwire {

namespace {

/// Ticks of one settle() before the watch for oscillation begins; there must also have been twice
/// as many changes as there are nets, for the watch costs as much to set up.
constexpr std::uint64_t patience = 64;
/// Ticks for which a netlist that oscillates is followed where its delays are yet to change.
constexpr std::uint64_t patience_for_delays = 65'536;
constexpr std::uint64_t ticks_between_questions = 1024;

}  // namespace

template <bool observed, bool watched>
inline void Simulator::Kernel::change(std::uint32_t net, Logic value,
                                      [[maybe_unused]] RecurrenceWatch* watch) {
    CellWord* const words = words_.data();
    const unsigned before = value_in(words[net]);
    if constexpr (watched) watch->note(net, static_cast<Logic>(before), value);
    words[net] = with_value(words[net], value);
    values_[net] = value;
    const Shares shares = share_table[4 * before + static_cast<unsigned>(value)];
    std::uint32_t* const touched = touched_.items.data();
    std::size_t size = touched_.size;
    for_each_reader(net, [&](std::uint32_t reader) {
        const CellWord old = words[reader >> 1U];
        const CellWord now = old + shares[reader & 1U];
        const bool decides = table_row(old) != table_row(now) || (now & special_flag) != 0;
        touched[size] = reader >> 1U;
        size += static_cast<std::size_t>(decides && (old & touched_flag) == 0);
        words[reader >> 1U] = now | (decides ? touched_flag : 0);
    });
    touched_.size = size;
    if constexpr (observed) observer_(now(), static_cast<NetId>(net), value);
}

void Simulator::Kernel::touch(std::uint32_t net) {
    touched_.items[touched_.size] = net;
    touched_.size += static_cast<std::size_t>((words_[net] & touched_flag) == 0);
    words_[net] |= touched_flag;
}

void Simulator::Kernel::change_unseen(std::uint32_t net, Logic value) {
    change<false, false>(net, value, nullptr);
}

void Simulator::Kernel::change_now(std::uint32_t net, Logic value) {
    if (values_[net] == value) return;
    if (observer_) {
        change<true, false>(net, value, nullptr);
    } else {
        change_unseen(net, value);
    }
    ++changes_;
}

/// Unequal delays: the output of a cell is to become `target`.
void Simulator::Kernel::aim(std::uint32_t net, Logic target) {
    NodeTiming& timing = timings_[net];
    const auto aim_bound = [&](Tick& due, bool present, bool wanted) {
        if ((due != no_tick) == (present != wanted)) return false;
        due = present == wanted ? no_tick : tick_ + (wanted ? timing.rise : timing.fall);
        live_ += present == wanted ? ~std::uint64_t{0} : 1;
        return due != no_tick;
    };
    const Logic present = values_[net];
    const bool low = aim_bound(timing.low_due, least(present), least(target));
    const bool high = aim_bound(timing.high_due, greatest(present), greatest(target));
    if (low) wheel_.add(tick_, timing.low_due, net);
    if (high && !(low && timing.high_due == timing.low_due)) {
        wheel_.add(tick_, timing.high_due, net);
    }
}

/// What the output of a cell is, or is about to be.
Logic Simulator::Kernel::aimed_value(std::uint32_t net) const {
    const Logic present = values_[net];
    if (uniform_) return present;
    const NodeTiming& timing = timings_[net];
    return between(least(present) != (timing.low_due != no_tick),
                   greatest(present) != (timing.high_due != no_tick));
}

/// The value of a pulse cell, or where delays are unequal of any cell, with the changes that are
/// due at this tick.
Logic Simulator::Kernel::take_due(std::uint32_t net) {
    const Logic present = values_[net];
    if (is_pulse(net)) {
        Pulse& pulse = pulse_of(net);
        if (pulse.due != tick_) return present;
        pulse.due = no_tick;
        --live_;
        return pulse_value(pulse, tick_);
    }
    NodeTiming& timing = timings_[net];
    bool low = least(present);
    bool high = greatest(present);
    for (auto [due, bound] : {std::pair(&timing.low_due, &low), {&timing.high_due, &high}}) {
        if (*due != tick_) continue;
        *due = no_tick;
        *bound = !*bound;
        --live_;
    }
    return between(low, high);
}

template <bool uniform>
void Simulator::Kernel::evaluate_touched() {
    CellWord* const words = words_.data();
    const std::uint32_t* const touched = touched_.items.data();
    std::uint32_t* const next = next_.items.data();
    std::size_t size = next_.size;
    for (std::size_t i = 0; i < touched_.size; ++i) {
        const std::uint32_t net = touched[i];
        const CellWord word = words[net];
        words[net] = word & ~touched_flag;
        unsigned target = look_up(word);
        if ((word & special_flag) != 0) [[unlikely]] {
            target = evaluate_special(net);
            if (target == no_change) continue;
        }
        if constexpr (uniform) {
            next[size] = net << 2U | target;
            size += static_cast<std::size_t>(target != value_in(word));
        } else {
            aim(net, static_cast<Logic>(target));
        }
    }
    next_.size = size;
    touched_.size = 0;
}

/// What changes before the first instant sees the delays of the start only.
void Simulator::Kernel::take_delays_of_now() {
    take_delays(pulses_held_ ? 0 : now());
}

/// Equal delays: the changes that were aimed at the tick before.
template <bool observed, bool watched>
void Simulator::Kernel::apply_current(RecurrenceWatch* watch) {
    const std::uint32_t* const entries = current_.items.data();
    const std::size_t size = current_.size;
    for (std::size_t i = 0; i < size; ++i) {
        __builtin_prefetch(&readers_[entries[i + read_ahead] >> 2U]);
        __builtin_prefetch(&words_[entries[i + read_ahead] >> 2U], 1);
        change<observed, watched>(entries[i] >> 2U, static_cast<Logic>(entries[i] & 3U), watch);
    }
    changes_ += size;
}

/// An entry of the wheel for this tick; false where what it stood for was cancelled.
template <bool observed, bool watched>
bool Simulator::Kernel::apply_due(std::uint32_t net, RecurrenceWatch* watch) {
    const Logic value = take_due(net);
    if (value == values_[net]) return false;
    ++changes_;
    change<observed, watched>(net, value, watch);
    return true;
}

/// Unequal delays: the entries of this tick.
template <bool observed, bool watched>
void Simulator::Kernel::apply_wheel(RecurrenceWatch* watch) {
    for (const std::uint32_t net : wheel_.list(tick_)) apply_due<observed, watched>(net, watch);
    wheel_.clear_list(tick_);
}

template <bool observed, bool watched>
void Simulator::Kernel::apply_far(RecurrenceWatch* watch) {
    while (wheel_.next_far() <= tick_) {
        const std::uint32_t net = wheel_.take_far();
        const bool has_changed = apply_due<observed, watched>(net, watch);
        if (has_changed && is_pulse(net)) touch(net);  // to aim at its next change
    }
}

template <bool uniform, bool observed, bool watched>
inline void Simulator::Kernel::next_tick(RecurrenceWatch* watch) {
    if constexpr (uniform) {
        tick_ = next_.size != 0 ? tick_ + 1 : wheel_.next_far();
        std::swap(current_, next_);
        next_.size = 0;
        apply_current<observed, watched>(watch);
    } else {
        tick_ = wheel_.next(tick_);
        apply_wheel<observed, watched>(watch);
    }
    if (wheel_.next_far() <= tick_) apply_far<observed, watched>(watch);
    if constexpr (!uniform) {
        if (next_delays_at_ <= now()) [[unlikely]]
            take_delays_of_now();
    }
    evaluate_touched<uniform>();
}

/// Asks now and then whether to go on.
bool Simulator::Kernel::is_broken_off(std::uint64_t ticks, Settling& settling) const {
    if (ticks % ticks_between_questions != ticks_between_questions - 1) return false;
    if (!keep_going_ || keep_going_()) return false;
    settling.settled = false;
    settling.broken_off = true;
    return true;
}

template <bool uniform, bool observed>
Settling Simulator::Kernel::run() {
    Settling settling;
    const std::uint64_t enough = changes_ + 2 * words_.size();
    if (next_delays_at_ <= now()) take_delays_of_now();
    evaluate_touched<uniform>();
    for (std::uint64_t ticks = 0; is_live(); ++ticks) {
        if (ticks >= patience && changes_ >= enough) {
            watch<uniform, observed>(settling);
            break;
        }
        next_tick<uniform, observed, false>(nullptr);
        if (is_broken_off(ticks, settling)) break;
    }
    if (!is_live()) {
        wheel_.clear();  // entries whose changes were cancelled may be left over
        rest_pulses();
    }
    settling.events = changes_ - changes_told_;
    changes_told_ = changes_;
    return settling;
}

template <bool uniform, bool observed>
void Simulator::Kernel::watch(Settling& settling) {
    Snapshot present;
    take_snapshot(present);
    RecurrenceWatch watch(words_.size(), std::move(present));
    for (std::uint64_t ticks = 0; is_live(); ++ticks) {
        next_tick<uniform, observed, true>(&watch);
        if (is_broken_off(ticks, settling)) return;
        if (!watch.came_back([this](Snapshot& snapshot) { take_snapshot(snapshot); })) continue;
        if (next_delays_at_ == never || ticks >= patience_for_delays) {
            settling.settled = false;
            settling.oscillating = watch.changing();
            return;
        }
    }
}

Settling Simulator::Kernel::settle() {
    if (uniform_) return observer_ ? run<true, true>() : run<true, false>();
    return observer_ ? run<false, true>() : run<false, false>();
}

void Simulator::Kernel::take_snapshot(Snapshot& snapshot) {
    snapshot.values = values_;
    snapshot.delays_taken = next_delays_;
    std::vector<ComingChange>& coming = snapshot.coming;
    coming.clear();
    for (std::size_t i = 0; i < next_.size; ++i) {
        coming.push_back({1, next_.items[i] >> 2U, next_.items[i] & 3U});
    }
    wheel_.for_each([&](std::uint32_t net) {
        if (is_pulse(net)) return;
        const NodeTiming& timing = timings_[net];
        if (timing.low_due != no_tick) coming.push_back({timing.low_due - tick_, net, 0});
        if (timing.high_due != no_tick) coming.push_back({timing.high_due - tick_, net, 1});
    });
    for (const Pulse& pulse : pulses_) {
        append_coming(pulse, memories_[pulse.memory].node, tick_, coming);
    }
    std::sort(coming.begin(), coming.end());
    coming.erase(std::unique(coming.begin(), coming.end()), coming.end());
}

/// Of a pulse cell, or where delays are unequal of any cell.
void Simulator::Kernel::drop_change(std::uint32_t net) {
    const auto drop = [this](Tick& due) {
        live_ -= static_cast<std::uint64_t>(due != no_tick);
        due = no_tick;
    };
    if (is_pulse(net)) {
        drop(pulse_of(net).due);
    } else {
        drop(timings_[net].low_due);
        drop(timings_[net].high_due);
    }
}

void Simulator::Kernel::drop_pending(std::uint32_t net) {
    if (!uniform_ || is_pulse(net)) drop_change(net);
    const auto begin = next_.items.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(next_.size);
    const auto kept =
        std::remove_if(begin, end, [net](std::uint32_t entry) { return entry >> 2U == net; });
    next_.size = static_cast<std::size_t>(kept - begin);
}

void Simulator::Kernel::drop_all_pending() {
    wheel_.for_each([this](std::uint32_t net) { drop_change(net); });
    wheel_.clear();
    next_.size = 0;
    for (std::size_t i = 0; i < touched_.size; ++i) words_[touched_.items[i]] &= ~touched_flag;
    touched_.size = 0;
}

}  // namespace grafwire
