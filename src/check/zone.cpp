// Difference-bound matrices: D. L. Dill, "Timing assumptions and verification of finite-state
// concurrent systems" (1989); J. Bengtsson and W. Yi, "Timed automata: semantics, algorithms and
// tools" (2004).
//
// A matrix holds for every pair the bound r(i) - r(j) < c or <= c, with r(0) = 0 for the bounds of
// single components. It is kept closed: no bound can be derived that is tighter than the one that
// is written (all shortest paths are in place). Then a zone is empty only where tightening says so,
// inclusion is comparison bound by bound, and leaving a component out is leaving its row and column
// out.
//
// Timed automata have clocks that run up from 0 and are compared with constants. Here remaining
// times run down from a length to 0: the same, mirrored. Since no delay runs beyond its length, all
// bounds lie between the longest length and its negative, and there are finitely many zones without
// any extrapolation.

#include "check/zone.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace grafwire {

namespace {

/// Beyond every time, and small enough for sums of bounds to fit.
constexpr std::int64_t far = std::numeric_limits<std::int64_t>::max() / 8;

}  // namespace

Zone Zone::unbounded(std::size_t delays) {
    // No delay is overdue.
    Zone zone(delays);
    for (std::size_t i = 1; i < zone.size_; ++i) {
        for (std::size_t j = 0; j < zone.size_; ++j) {
            if (i != j) zone.bound(i, j) = strict(far);
        }
    }
    return zone;
}

/// Components sink together, so their differences stay; their upper bounds hold without the bounds
/// themselves, since some time has passed; their lower bounds become 0 at most.
Zone Zone::later() const {
    Zone zone = *this;
    for (std::size_t i = 1; i < size_; ++i) {
        zone.bound(i, 0) &= ~Bound{1};
        // 0 - r(i): from above by what r(j) - r(i) allows when r(j) is at 0 or more.
        Bound lowest = weak(0);
        for (std::size_t j = 1; j < size_; ++j) lowest = std::min(lowest, bound(j, i));
        zone.bound(0, i) = lowest;
    }
    return zone;
}

/// Differences stay; upper bounds hold without the bounds themselves; there are no lower bounds.
Zone Zone::at_a_scan() const {
    Zone zone = *this;
    for (std::size_t i = 1; i < size_; ++i) {
        zone.bound(i, 0) &= ~Bound{1};
        zone.bound(0, i) = strict(far);
    }
    return zone;
}

Zone Zone::after(std::int64_t quanta) const {
    Zone zone = *this;
    for (std::size_t i = 1; i < size_; ++i) {
        zone.bound(i, 0) -= 2 * quanta;
        zone.bound(0, i) += 2 * quanta;
    }
    return zone;
}

bool Zone::tighten(std::size_t a, std::size_t b, Bound limit) {
    if (sum(limit, bound(b, a)) < weak(0)) return false;
    if (limit >= bound(a, b)) return true;
    for (std::size_t i = 0; i < size_; ++i) {
        const Bound to_b = sum(bound(i, a), limit);
        for (std::size_t j = 0; j < size_; ++j) {
            const Bound over = sum(to_b, bound(b, j));
            if (over < bound(i, j)) bound(i, j) = over;
        }
    }
    return true;
}

Zone Zone::with(const std::vector<Origin>& origins) const {
    Zone zone(origins.size());
    // A delay that begins is the constant 0 moved up by its length.
    struct Place {
        std::size_t row;
        std::int64_t moved;
    };
    std::vector<Place> places{{0, 0}};
    for (const Origin& origin : origins) {
        if (origin.delay == Origin::begins) {
            places.push_back({0, origin.quanta});
        } else {
            places.push_back({origin.delay + 1, 0});
        }
    }
    for (std::size_t i = 0; i < zone.size_; ++i) {
        for (std::size_t j = 0; j < zone.size_; ++j) {
            zone.bound(i, j) =
                bound(places[i].row, places[j].row) + 2 * (places[i].moved - places[j].moved);
        }
    }
    return zone;
}

bool Zone::includes(const Zone& other) const {
    assert(size_ == other.size_);
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        if (other.bounds_[i] > bounds_[i]) return false;
    }
    return true;
}

}  // namespace grafwire
