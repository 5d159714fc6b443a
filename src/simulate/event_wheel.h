#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace grafwire {

/// A count of time slots; a slot is the greatest common divisor of all delays.
using Tick = std::int64_t;
inline constexpr Tick no_tick = INT64_MAX;

/// Nets that are to change at a tick to come. Near ticks have a list each, found by the low bits of
/// the tick; far ones are in a heap. Entries are never taken out before their tick: the reader
/// asks the net whether the change still stands.
class EventWheel {
  public:
    struct Far {
        Tick tick = 0;
        std::uint32_t net = 0;
    };

    /// `reach`: the longest delay in ticks that is worth a list of its own.
    explicit EventWheel(Tick reach) {
        const auto wanted = static_cast<std::size_t>(std::clamp<Tick>(reach + 1, 64, most_lists));
        lists_.resize(std::bit_ceil(wanted));
        occupied_.resize(lists_.size() / 64);
    }

    /// `tick` is later than `now`.
    void add(Tick now, Tick tick, std::uint32_t net) {
        if (tick - now >= static_cast<Tick>(lists_.size())) {
            add_far(tick, net);
            return;
        }
        const std::size_t place = place_of(tick);
        lists_[place].push_back(net);
        occupied_[place / 64] |= std::uint64_t{1} << (place % 64);
    }
    void add_far(Tick tick, std::uint32_t net) {
        far_.push_back({tick, net});
        std::push_heap(far_.begin(), far_.end(), later);
    }

    /// The first tick after `now` with an entry, no_tick if there is none.
    Tick next(Tick now) const { return std::min(next_near(now), next_far()); }
    Tick next_far() const { return far_.empty() ? no_tick : far_.front().tick; }

    /// The near entries of a tick; the caller clears them with clear_list.
    const std::vector<std::uint32_t>& list(Tick tick) const { return lists_[place_of(tick)]; }
    void clear_list(Tick tick) {
        const std::size_t place = place_of(tick);
        lists_[place].clear();
        occupied_[place / 64] &= ~(std::uint64_t{1} << (place % 64));
    }
    /// Expects a far entry.
    std::uint32_t take_far() {
        std::pop_heap(far_.begin(), far_.end(), later);
        const std::uint32_t net = far_.back().net;
        far_.pop_back();
        return net;
    }

    void clear() {
        far_.clear();
        for (std::size_t word = 0; word < occupied_.size(); ++word) {
            for (; occupied_[word] != 0; occupied_[word] &= occupied_[word] - 1) {
                lists_[64 * word + static_cast<std::size_t>(std::countr_zero(occupied_[word]))]
                    .clear();
            }
        }
    }

    /// Calls `visit(net)` for every entry, those that no longer stand included.
    template <typename Visit>
    void for_each(Visit visit) const {
        for (const std::vector<std::uint32_t>& list : lists_) {
            for (const std::uint32_t net : list) visit(net);
        }
        for (const Far& far : far_) visit(far.net);
    }

  private:
    static constexpr Tick most_lists = 4096;

    static bool later(const Far& a, const Far& b) { return a.tick > b.tick; }
    std::size_t place_of(Tick tick) const {
        return static_cast<std::size_t>(tick) & (lists_.size() - 1);
    }
    Tick next_near(Tick now) const {
        const std::size_t start = place_of(now + 1);
        std::size_t word = start / 64;
        std::uint64_t bits = occupied_[word] & (~std::uint64_t{0} << (start % 64));
        // One turn more than there are words: the first word is looked at again for its low bits.
        for (std::size_t turn = 0; turn <= occupied_.size(); ++turn) {
            if (bits != 0) {
                const std::size_t place =
                    64 * word + static_cast<std::size_t>(std::countr_zero(bits));
                return now + 1 + static_cast<Tick>((place - start) & (lists_.size() - 1));
            }
            word = (word + 1) & (occupied_.size() - 1);
            bits = occupied_[word];
        }
        return no_tick;
    }

    std::vector<std::vector<std::uint32_t>> lists_;
    std::vector<std::uint64_t> occupied_;
    std::vector<Far> far_;
};

}  // namespace grafwire
