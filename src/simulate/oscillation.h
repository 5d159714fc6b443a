#pragma once

#include <cstdint>
#include <vector>

#include "netlist/netlist.h"
#include "simulate/event_wheel.h"

namespace grafwire {

/// Something that is to happen to a net so many ticks from now.
struct ComingChange {
    Tick in = 0;
    std::uint32_t net = 0;
    std::uint32_t what = 0;
    auto operator<=>(const ComingChange&) const = default;
};

/// All that decides how a simulation goes on while its inputs are held.
struct Snapshot {
    std::vector<Logic> values;
    std::vector<ComingChange> coming;  ///< in order, each once
    std::size_t delays_taken = 0;      ///< how far the schedule of delays has been played
    bool operator==(const Snapshot&) const = default;
};

/// A share of the hash of all values: one number per net and value.
constexpr std::uint64_t value_hash(std::uint32_t net, Logic value) {
    std::uint64_t x = (std::uint64_t{net} << 2U | static_cast<std::uint64_t>(value)) + 1;
    x *= 0x9e3779b97f4a7c15U;
    x ^= x >> 32U;
    return x * 0xd6e8feb86659fd93U;
}

std::uint64_t hash_of(const std::vector<Logic>& values);

/// Finds out whether a simulation has come back to a state it has been in.
class RecurrenceWatch {
  public:
    RecurrenceWatch(std::size_t net_count, Snapshot&& present);

    /// To be called at every change of a net.
    void note(std::uint32_t net, Logic from, Logic to) {
        hash_ += value_hash(net, to) - value_hash(net, from);
        changed_in_[net] = stretch_;
    }

    /// To be called after every tick at which something changed. `take(snapshot)` writes down the
    /// present state. True if it is the one kept for comparison; the search goes on where it is
    /// called again.
    template <typename Take>
    bool came_back(Take take) {
        ++ticks_;
        if (hash_ == kept_hash_) {
            take(present_);
            if (present_ == kept_) return true;
        }
        if (ticks_ >= stretch_length_) {
            take(kept_);
            keep();
        }
        return false;
    }

    /// After came_back was true: the nets that changed since the kept state, in order.
    std::vector<NetId> changing() const;

  private:
    void keep();

    Snapshot kept_;
    Snapshot present_;
    std::uint64_t hash_ = 0;
    std::uint64_t kept_hash_ = 0;
    std::uint64_t ticks_ = 0;  ///< since the kept state
    std::uint64_t stretch_length_;
    std::uint32_t stretch_ = 1;
    std::vector<std::uint32_t> changed_in_;  ///< per net: the stretch in which it last changed
};

}  // namespace grafwire
