// The firing domains of state classes (B. Berthomieu, M. Diaz, "Modeling and verification of time
// dependent systems using time Petri nets", IEEE Trans. Softw. Eng. 17, 1991), as difference-bound
// matrices (D. L. Dill, 1989), which are kept closed: no bound can be derived that is tighter than
// the one that is written. Then a domain is empty only where tightening says so, and leaving a
// component out is leaving its row and column out.
//
// Only differences are kept, as firings are compared with one another and with nothing else.

#include "settling/firing_domain.h"

#include <algorithm>

namespace grafwire {

namespace {

/// Instead of a bound. More than any sum of delays.
constexpr Time unbounded = Time{1} << 50;

Time moved(Time bound, Time by) {
    return bound == unbounded ? unbounded : bound + by;
}

}  // namespace

FiringDomain::FiringDomain(std::span<const DelayBand> bands)
    : size_(bands.size()), bounds_(size_ * size_) {
    for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t j = 0; j < size_; ++j) {
            if (i != j) bound(i, j) = bands[i].max - bands[j].min;
        }
    }
}

bool FiringDomain::tighten(std::size_t a, std::size_t b, Time limit) {
    if (limit + bound(b, a) < 0) return false;
    if (limit >= bound(a, b)) return true;
    for (std::size_t i = 0; i < size_; ++i) {
        if (bound(i, a) == unbounded) continue;
        const Time to_b = bound(i, a) + limit;
        for (std::size_t j = 0; j < size_; ++j) {
            const Time over = moved(bound(b, j), to_b);
            if (over < bound(i, j)) bound(i, j) = over;
        }
    }
    return true;
}

bool FiringDomain::fire(std::span<const std::size_t> first, std::span<const std::size_t> others,
                        std::span<const std::size_t> later, std::span<const Origin> origins,
                        FiringDomain& after) const {
    FiringDomain now = *this;
    for (const std::size_t f : first) {
        for (const std::size_t other : others) {
            if (f != other && !now.tighten(f, other, 0)) return false;
        }
        for (const std::size_t other : later) {
            if (!now.tighten(f, other, -1)) return false;
        }
        if (!now.tighten(f, first[0], 0) || !now.tighten(first[0], f, 0)) return false;
    }
    after.size_ = origins.size();
    after.bounds_.assign(after.size_ * after.size_, 0);
    // One that begins is the moment of the firing itself, moved by what its band allows.
    const auto is_new = [&](std::size_t i) { return origins[i].firing == Origin::begins; };
    const auto row = [&](std::size_t i) { return is_new(i) ? first[0] : origins[i].firing; };
    for (std::size_t i = 0; i < after.size_; ++i) {
        for (std::size_t j = 0; j < after.size_; ++j) {
            if (i == j) continue;
            after.bound(i, j) =
                moved(now.bound(row(i), row(j)), (is_new(i) ? origins[i].band.max : 0) -
                                                     (is_new(j) ? origins[j].band.min : 0));
        }
    }
    return true;
}

bool FiringDomain::includes(const FiringDomain& other) const {
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        if (other.bounds_[i] > bounds_[i]) return false;
    }
    return true;
}

// The greater of two closed matrices, bound by bound, is closed: i - k is at most (i - j) + (j - k)
// in either, so at most the sum of the greater ones.
void FiringDomain::include(const FiringDomain& other) {
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        bounds_[i] = std::max(bounds_[i], other.bounds_[i]);
    }
}

void FiringDomain::include_all() {
    for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t j = 0; j < size_; ++j) {
            if (i != j) bound(i, j) = unbounded;
        }
    }
}

}  // namespace grafwire
