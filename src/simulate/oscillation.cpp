// How an oscillation is told from a long cascade
//
// With the inputs held, the state of a simulation (the values of all nets and what is going to
// happen to them, counted from now) decides all that follows. It therefore oscillates if and only
// if some state comes back; a token that runs through a million steps never repeats one. Brent's
// scheme (R. P. Brent, "An improved Monte Carlo factorization algorithm", BIT 20, 1980) finds the
// repetition with a single kept state: every state is compared with it, and after stretches of
// doubling length the present state takes its place. Once the kept state lies on the circle and the
// stretch is longer than the circle, the first state equal to it ends the search, one period later.
//
// The first stretch is long enough for the copies of the state to cost little beside the events.
//
// Comparing whole states at every tick would be too slow, so a hash of the values is kept up to
// date at every change (the sum of one number per net and value, after Zobrist). Only where it
// equals the hash of the kept state are the states themselves compared; the answer never rests on
// the hash. Numbers that mark the stretch of a net's last change yield the nets of the period.

#include "simulate/oscillation.h"

#include <algorithm>

namespace grafwire {

std::uint64_t hash_of(const std::vector<Logic>& values) {
    std::uint64_t hash = 0;
    for (std::size_t net = 0; net < values.size(); ++net) {
        hash += value_hash(static_cast<std::uint32_t>(net), values[net]);
    }
    return hash;
}

RecurrenceWatch::RecurrenceWatch(std::size_t net_count, Snapshot&& present)
    : kept_(std::move(present)),
      hash_(hash_of(kept_.values)),
      kept_hash_(hash_),
      stretch_length_(std::max<std::uint64_t>(64, net_count / 4)),
      changed_in_(net_count, 0) {}

void RecurrenceWatch::keep() {
    kept_hash_ = hash_;
    ticks_ = 0;
    stretch_length_ *= 2;
    ++stretch_;
}

std::vector<NetId> RecurrenceWatch::changing() const {
    std::vector<NetId> nets;
    for (std::size_t net = 0; net < changed_in_.size(); ++net) {
        if (changed_in_[net] == stretch_) nets.push_back(static_cast<NetId>(net));
    }
    return nets;
}

}  // namespace grafwire
