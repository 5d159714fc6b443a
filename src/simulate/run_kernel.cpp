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
// - Node and cell are one 32-byte record that also holds up to three readers, so a change of a net
//   touches its own record and those of its readers, and a list of readers only for greater fan-out.
// - Gates keep a sum of their inputs (evaluate_cell.h): applying a change adds one number to the sum
//   of each reader, and evaluation is a look-up, whatever the number of pins.
// - Both phases write into lists without a branch: the entry is always written, and the size grows
//   by a condition. Mispredicted branches were half the time otherwise.
// - If all delays are equal there is no wheel at all but two lists, and a gate can have no pending
//   change when it is evaluated: whatever it was aiming at has just been applied.
// - What is not always there (observer, watch for oscillation, unequal delays) is compiled out.
//
// A cell has one pending change at most (inertial delay): a re-evaluation that gives the present
// value again cancels it. If it gives `unknown` while a known value is on its way, that becomes
// unknown at the moment it was due; if a cell is on its way to unknown and then knows better, it
// is evaluated again once unknown has come.

namespace grafwire {

namespace {

/// What a change adds to the sums of readers with controlling value 0 and 1, by old and new value.
struct Shares {
    std::array<InputSum, 2> of;
};
constexpr std::array<Shares, 16> make_share_table() {
    std::array<Shares, 16> table{};
    for (unsigned from = 0; from < 3; ++from) {
        for (unsigned to = 0; to < 3; ++to) {
            for (unsigned control = 0; control < 2; ++control) {
                table[4 * from + to].of[control] =
                    contribution(static_cast<Logic>(control), static_cast<Logic>(to)) -
                    contribution(static_cast<Logic>(control), static_cast<Logic>(from));
            }
        }
    }
    return table;
}
constexpr std::array<Shares, 16> share_table = make_share_table();

/// Moments of one settle() before the watch for oscillation begins.
constexpr std::uint64_t patience = 64;
constexpr std::size_t read_ahead = 12;

}  // namespace

template <bool observed, bool watched>
inline void Simulator::Kernel::change(std::uint32_t net, Logic value,
                                      [[maybe_unused]] RecurrenceWatch* watch) {
    Node* const nodes = nodes_.data();
    Node& node = nodes[net];
    const Logic before = node.value;
    if constexpr (watched) watch->note(net, before, value);
    node.value = value;
    values_[net] = value;
    const Shares shares =
        share_table[4 * static_cast<std::size_t>(before) + static_cast<std::size_t>(value)];
    std::uint32_t* const touched = touched_.items.data();
    std::size_t size = touched_.size;
    const auto tell = [&](std::uint32_t reader) {
        Node& cell = nodes[reader >> 1U];
        cell.sum += shares.of[reader & 1U];
        touched[size] = reader >> 1U;
        size += static_cast<std::size_t>(!cell.touched);
        cell.touched = true;
    };
    if (node.reader_count <= 3) [[likely]] {
        for (unsigned i = 0; i < node.reader_count; ++i) tell(node.readers[i]);
    } else {
        const std::uint32_t* const readers = more_readers_.data();
        for (std::uint32_t i = node.readers[0]; i < node.readers[1]; ++i) tell(readers[i]);
    }
    touched_.size = size;
    if constexpr (observed) observer_(now(), static_cast<NetId>(net), value);
}

void Simulator::Kernel::touch(std::uint32_t net) {
    touched_.items[touched_.size] = net;
    touched_.size += static_cast<std::size_t>(!nodes_[net].touched);
    nodes_[net].touched = true;
}

void Simulator::Kernel::change_unseen(std::uint32_t net, Logic value) {
    change<false, false>(net, value, nullptr);
}

void Simulator::Kernel::change_now(std::uint32_t net, Logic value) {
    if (nodes_[net].value == value) return;
    if (observer_) {
        change<true, false>(net, value, nullptr);
    } else {
        change_unseen(net, value);
    }
    ++changes_;
}

Tick Simulator::Kernel::due_tick(std::uint32_t net) const {
    const Node& node = nodes_[net];
    if (node.type == CellType::rise_pulse || node.type == CellType::fall_pulse) {
        return pulses_[memories_[node.memory].detail].due;
    }
    return timings_[net].due;
}

/// Unequal delays: the output of a cell is to become `target`.
void Simulator::Kernel::aim(std::uint32_t net, Logic target) {
    Node& node = nodes_[net];
    NodeTiming& timing = timings_[net];
    if (node.pending != no_change) {
        const auto pending = static_cast<Logic>(node.pending);
        if (target == pending) return;
        if (target == node.value) {
            node.pending = no_change;
            --live_;
            return;
        }
        if (target == Logic::unknown) {
            node.pending = static_cast<std::uint8_t>(Logic::unknown);
            return;
        }
        if (pending == Logic::unknown) return;
        node.pending = no_change;
        --live_;
    }
    if (target == node.value) return;
    const bool rises = target == Logic::one || node.value == Logic::zero;
    timing.due = tick_ + (rises ? timing.rise : timing.fall);
    node.pending = static_cast<std::uint8_t>(target);
    ++live_;
    wheel_.add(tick_, timing.due, net);
}

template <bool uniform>
void Simulator::Kernel::evaluate_touched() {
    Node* const nodes = nodes_.data();
    const std::uint32_t* const touched = touched_.items.data();
    std::uint32_t* const next = next_.items.data();
    std::size_t size = next_.size;
    for (std::size_t i = 0; i < touched_.size; ++i) {
        const std::uint32_t net = touched[i];
        Node& node = nodes[net];
        node.touched = false;
        unsigned target = look_up(node.table, node.sum);
        if (node.table >= special) [[unlikely]] {
            target = evaluate_special(net);
            if (target == no_change) continue;
        }
        if constexpr (uniform) {
            next[size] = net << 2U | target;
            size += static_cast<std::size_t>(target != static_cast<unsigned>(node.value));
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
        __builtin_prefetch(&nodes_[entries[i + read_ahead] >> 2U], 1);
        change<observed, watched>(entries[i] >> 2U, static_cast<Logic>(entries[i] & 3U), watch);
    }
    changes_ += size;
}

/// Unequal delays: the entries of this tick whose changes still stand.
template <bool observed, bool watched>
void Simulator::Kernel::apply_wheel(RecurrenceWatch* watch) {
    const std::vector<std::uint32_t>& entries = wheel_.list(tick_);
    for (const std::uint32_t net : entries) {
        Node& node = nodes_[net];
        if (node.pending == no_change || timings_[net].due != tick_) continue;
        const auto value = static_cast<Logic>(node.pending);
        node.pending = no_change;
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
        Node& node = nodes_[net];
        if (node.pending == no_change || due_tick(net) != tick_) continue;
        const auto value = static_cast<Logic>(node.pending);
        node.pending = no_change;
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

template <bool uniform, bool observed>
Settling Simulator::Kernel::run() {
    Settling settling;
    const std::uint64_t enough = changes_ + nodes_.size() / 8;
    evaluate_touched<uniform>();
    for (std::uint64_t moments = 0; is_live(); ++moments) {
        if (moments >= patience && changes_ >= enough) {
            watch<uniform, observed>(settling);
            break;
        }
        next_moment<uniform, observed, false>(nullptr);
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
    RecurrenceWatch watch(nodes_.size(), std::move(present));
    while (is_live()) {
        next_moment<uniform, observed, true>(&watch);
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

void Simulator::Kernel::take_snapshot(Snapshot& snapshot) const {
    snapshot.values = values_;
    std::vector<ComingChange>& coming = snapshot.coming;
    coming.clear();
    for (std::size_t i = 0; i < next_.size; ++i) {
        coming.push_back({1, next_.items[i] >> 2U, next_.items[i] & 3U});
    }
    wheel_.for_each([&](std::uint32_t net) {
        const Node& node = nodes_[net];
        if (node.pending != no_change) {
            coming.push_back({due_tick(net) - tick_, net, node.pending});
        }
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

void Simulator::Kernel::drop_pending(std::uint32_t net) {
    if (nodes_[net].pending != no_change) {
        nodes_[net].pending = no_change;
        --live_;
    }
    const auto begin = next_.items.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(next_.size);
    const auto kept =
        std::remove_if(begin, end, [net](std::uint32_t entry) { return entry >> 2U == net; });
    next_.size = static_cast<std::size_t>(kept - begin);
}

void Simulator::Kernel::drop_all_pending() {
    wheel_.for_each([this](std::uint32_t net) { nodes_[net].pending = no_change; });
    wheel_.clear();
    next_.size = 0;
    live_ = 0;
    for (std::size_t i = 0; i < touched_.size; ++i) nodes_[touched_.items[i]].touched = false;
    touched_.size = 0;
}

}  // namespace grafwire
