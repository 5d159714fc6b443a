#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "text/time.h"

namespace grafwire {

/// Which remaining times of the running delays are possible together: a set of vectors with one
/// component per delay, bounded by how large each component and each difference of two can be. With
/// no delay running there is the one empty vector.
///
/// Time counts here in quanta: a quantum divides all lengths, which keeps the bounds small.
class Zone {
  public:
    Zone() : Zone(0) {}
    /// Everything is possible: any delays end at any time.
    static Zone unbounded(std::size_t delays);

    std::size_t delays() const { return size_ - 1; }

    /// The zone some time later, at any moment at which no delay is overdue: a positive time has
    /// passed, and each delay has some of its time left or ends at that very moment.
    Zone later() const;
    /// The zone at the next scan, with any time in between: delays may be overdue there.
    Zone at_a_scan() const;
    /// The zone exactly this many quanta later; delays may be overdue there.
    Zone after(std::int64_t quanta) const;

    /// Keeps the moments at which a delay ends or is overdue. False where there is none; the zone
    /// is of no use then.
    bool let_end(std::size_t delay) { return tighten(delay + 1, 0, weak(0)); }
    /// Keeps the moments at which some of the delay's time is left. False where there is none.
    bool let_run_on(std::size_t delay) { return tighten(0, delay + 1, strict(0)); }

    /// Where a delay comes from.
    struct Origin {
        static constexpr std::uint32_t begins = 0xffffffffU;
        std::uint32_t delay = begins;  ///< it is this one of another zone; or it begins now
        std::int64_t quanta = 0;       ///< with this length
        bool operator==(const Origin&) const = default;
    };
    /// The zone of other delays: some of these go on, in a new order, and some begin now.
    Zone with(const std::vector<Origin>& origins) const;

    /// Whether everything that is possible in the other zone, of as many delays, is so in this one.
    bool includes(const Zone& other) const;

    bool operator==(const Zone&) const = default;

  private:
    /// An upper bound: twice the time, plus 1 where the time itself is within the bound.
    using Bound = std::int64_t;
    static constexpr Bound weak(std::int64_t quanta) { return 2 * quanta + 1; }
    static constexpr Bound strict(std::int64_t quanta) { return 2 * quanta; }
    static constexpr Bound sum(Bound a, Bound b) { return a + b - ((a | b) & 1); }

    explicit Zone(std::size_t delays) : size_(delays + 1), bounds_(size_ * size_, weak(0)) {}
    Bound& bound(std::size_t i, std::size_t j) { return bounds_[i * size_ + j]; }
    Bound bound(std::size_t i, std::size_t j) const { return bounds_[i * size_ + j]; }
    bool tighten(std::size_t i, std::size_t j, Bound limit);

    std::size_t size_;           ///< the delays, and before them the constant 0
    std::vector<Bound> bounds_;  ///< row i, column j: of component i minus component j
};

}  // namespace grafwire
