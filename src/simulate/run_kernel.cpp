#include <algorithm>
#include <cassert>

#include "simulate/kernel.h"

// How the gates are simulated
//
// The method is event-driven selective trace (E. G. Ulrich, "Exclusive simulation of activity in
// digital networks", CACM 12, 1969) on a timing wheel. Each moment has two phases: first all
// changes of that moment are applied, then every cell with a changed input is evaluated once. So
// simultaneous changes are simultaneous, and the order of cells in the netlist decides nothing.
//
// What makes it fast:
// - Node and cell are one number. A change of a net touches 16 bytes that hold up to three readers,
//   and the word (cell_word.h) of each reader; lists of readers are there for greater fan-out only.
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
// A cell has one pending change at most (inertial delay): a re-evaluation that gives the present
// value again cancels it. If it gives `unknown` while a known value is on its way, that becomes
// unknown at the moment it was due; if a cell is on its way to unknown and then knows better, it
// is evaluated again once unknown has come.

namespace grafwire {

namespace {

/// Moments of one settle() before the watch for oscillation begins; there must also have been twice
/// as many changes as there are nets, for the watch costs as much to set up.
constexpr std::uint64_t patience = 64;
constexpr std::size_t read_ahead = 12;
constexpr std::uint64_t moments_between_questions = 1024;

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

Tick Simulator::Kernel::due_tick(std::uint32_t net) const {
    return is_pulse(net) ? pulses_[memories_[memory_of_[net]].detail].due : timings_[net].due;
}

/// The pending change of a pulse cell, or where delays are unequal of any cell.
std::uint8_t& Simulator::Kernel::pending(std::uint32_t net) {
    return is_pulse(net) ? pulses_[memories_[memory_of_[net]].detail].pending
                         : timings_[net].pending;
}

/// Unequal delays: the output of a cell is to become `target`.
void Simulator::Kernel::aim(std::uint32_t net, Logic target) {
    NodeTiming& timing = timings_[net];
    const Logic present = values_[net];
    if (timing.pending != no_change) {
        const auto pending = static_cast<Logic>(timing.pending);
        if (target == pending) return;
        if (target != present && target == Logic::unknown) {
            timing.pending = static_cast<std::uint8_t>(Logic::unknown);
            return;
        }
        if (target != present && pending == Logic::unknown) return;
        timing.pending = no_change;
        --live_;
    }
    if (target == present) return;
    const bool rises = target == Logic::one || present == Logic::zero;
    timing.due = tick_ + (rises ? timing.rise : timing.fall);
    timing.pending = static_cast<std::uint8_t>(target);
    ++live_;
    wheel_.add(tick_, timing.due, net);
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

/// Unequal delays: the entries of this tick whose changes still stand.
template <bool observed, bool watched>
void Simulator::Kernel::apply_wheel(RecurrenceWatch* watch) {
    const std::vector<std::uint32_t>& entries = wheel_.list(tick_);
    for (const std::uint32_t net : entries) {
        NodeTiming& timing = timings_[net];
        if (timing.pending == no_change || timing.due != tick_) continue;
        const auto value = static_cast<Logic>(timing.pending);
        timing.pending = no_change;
        --live_;
        ++changes_;
        change<observed, watched>(net, value, watch);
        if (value == Logic::unknown) touch(net);
    }
    wheel_.clear_list(tick_);
}

template <bool observed, bool watched>
void Simulator::Kernel::apply_far(RecurrenceWatch* watch) {
    while (wheel_.next_far() <= tick_) {
        const std::uint32_t net = wheel_.take_far();
        if (pending(net) == no_change || due_tick(net) != tick_) continue;
        const auto value = static_cast<Logic>(pending(net));
        pending(net) = no_change;
        --live_;
        ++changes_;
        change<observed, watched>(net, value, watch);
        touch(net);
    }
}

template <bool uniform, bool observed, bool watched>
inline void Simulator::Kernel::next_moment(RecurrenceWatch* watch) {
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
    evaluate_touched<uniform>();
}

/// Asks now and then whether to go on.
bool Simulator::Kernel::is_broken_off(std::uint64_t moments, Settling& settling) const {
    if (moments % moments_between_questions != moments_between_questions - 1) return false;
    if (!keep_going_ || keep_going_()) return false;
    settling.settled = false;
    settling.broken_off = true;
    return true;
}

template <bool uniform, bool observed>
Settling Simulator::Kernel::run() {
    Settling settling;
    const std::uint64_t enough = changes_ + 2 * words_.size();
    evaluate_touched<uniform>();
    for (std::uint64_t moments = 0; is_live(); ++moments) {
        if (moments >= patience && changes_ >= enough) {
            watch<uniform, observed>(settling);
            break;
        }
        next_moment<uniform, observed, false>(nullptr);
        if (is_broken_off(moments, settling)) break;
    }
    // Entries whose changes were cancelled may be left over.
    if (!is_live()) wheel_.clear();
    settling.events = changes_ - changes_told_;
    changes_told_ = changes_;
    return settling;
}

template <bool uniform, bool observed>
void Simulator::Kernel::watch(Settling& settling) {
    Snapshot present;
    take_snapshot(present);
    RecurrenceWatch watch(words_.size(), std::move(present));
    for (std::uint64_t moments = 0; is_live(); ++moments) {
        next_moment<uniform, observed, true>(&watch);
        if (is_broken_off(moments, settling)) return;
        if (watch.came_back([this](Snapshot& snapshot) { take_snapshot(snapshot); })) {
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
    std::vector<ComingChange>& coming = snapshot.coming;
    coming.clear();
    for (std::size_t i = 0; i < next_.size; ++i) {
        coming.push_back({1, next_.items[i] >> 2U, next_.items[i] & 3U});
    }
    wheel_.for_each([&](std::uint32_t net) {
        const std::uint8_t to = pending(net);
        if (to != no_change) coming.push_back({due_tick(net) - tick_, net, to});
    });
    for (const Pulse& pulse : pulses_) {
        const std::uint32_t net = memories_[pulse.memory].node;
        const std::array<Tick, 4> bounds{pulse.certain_from, pulse.certain_to, pulse.possible_from,
                                         pulse.possible_to};
        for (std::uint32_t i = 0; i < bounds.size(); ++i) {
            if (bounds[i] > tick_) coming.push_back({bounds[i] - tick_, net, 4 + i});
        }
    }
    std::sort(coming.begin(), coming.end());
    coming.erase(std::unique(coming.begin(), coming.end()), coming.end());
}

/// Of a pulse cell, or where delays are unequal of any cell.
void Simulator::Kernel::drop_change(std::uint32_t net) {
    if (pending(net) == no_change) return;
    pending(net) = no_change;
    --live_;
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
    wheel_.for_each([this](std::uint32_t net) { pending(net) = no_change; });
    wheel_.clear();
    next_.size = 0;
    live_ = 0;
    for (std::size_t i = 0; i < touched_.size; ++i) words_[touched_.items[i]] &= ~touched_flag;
    touched_.size = 0;
}

}  // namespace grafwire
