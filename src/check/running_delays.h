#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "check/path.h"
#include "check/zone.h"
#include "grafcet/grafcet.h"

namespace grafwire {

/// In the states that the exploration keeps, delays have no time at which they end: `due` is
/// `never` where none is running, else this. A Zone says what remains of them.
inline constexpr Time some_time = never - 1;

/// How time passes from one instant to the next, or from one scan to the next.
enum class Passing {
    free,         ///< any running delay can end at any time, whatever its length
    to_an_end,    ///< lengths count, and there is an instant at the end of every delay
    to_a_scan,    ///< lengths count, and any time lies between two scans
    by_a_period,  ///< lengths count, and a given time lies between two scans
};

/// What is known of the delays of both sides from the start.
struct DelayFacts {
    Passing passing = Passing::free;
    Time period = 0;   ///< of by_a_period
    Time quantum = 1;  ///< a duration that divides all lengths, and the period
    /// Per timer, the time condition it stands for.
    std::vector<std::uint32_t> condition_of_timer;
    /// Whether anything that is compared depends on them; the others are left out.
    std::vector<std::uint8_t> is_relevant_condition;
    std::vector<std::uint8_t> is_relevant_timer;
};

/// The delays that run in a state of reference and netlist, and what can remain of them.
///
/// A timer of the netlist whose delay began together with that of the time condition it stands for,
/// and has the same length, shares its place in the zone: so it is as long as the netlist is right.
/// Any other has a place of its own.
class RunningDelays {
  public:
    RunningDelays() = default;
    /// Before the first instant: no delay is running.
    explicit RunningDelays(const DelayFacts& facts)
        : of_condition_(facts.is_relevant_condition.size(), none),
          of_timer_(facts.is_relevant_timer.size(), none) {}

    /// What can remain at the next instant, before it is known which delays end by it.
    const Zone& zone() const { return zone_; }

    /// One way in which the next instant can come.
    struct Ending {
        EndedDelays ended;
        std::vector<RunningDelay> running;  ///< all delays, the instants as given to after()
        Zone zone;                          ///< what can remain of them at the instant
    };
    /// Every set of delays that can end together, and before the others; the empty set too, as far
    /// as there is time before the first must end. At a scan those end that have fallen due since
    /// the one before. `visit` says whether to go on.
    void for_each_ending(const std::function<bool(const Ending&)>& visit) const;

    /// The delays after an instant. `at_instant` is the zone at it; the times at which time
    /// conditions and timers are due are as the instant left them, `some_time` for a delay that
    /// goes on and the length of one that began at it. They get `some_time` for these too, and
    /// `never` for delays on which nothing depends. `instant` is the number of the instant.
    RunningDelays after(const DelayFacts& facts, const Zone& at_instant,
                        std::vector<Time>& due_of_conditions, std::vector<Time>& due_of_timers,
                        std::size_t instant) const;

    /// Appends to an encoding what is not in the zone: which delays run, and which share a place.
    void encode(std::string& encoding) const;

  private:
    static constexpr std::uint32_t none = 0xffffffffU;  ///< no place: the delay is not running
    struct Delay {
        std::size_t begun;
        Time length;
    };
    bool choose(const Zone& zone, std::size_t left, std::vector<bool>& ends,
                const std::function<bool(const Ending&)>& visit) const;
    Ending ending(const Zone& zone, const std::vector<bool>& ends) const;
    std::uint32_t add(RunningDelays& next, std::vector<Zone::Origin>& origins, Zone::Origin origin,
                      Time length, std::size_t instant) const;

    std::vector<std::uint32_t> of_condition_;  ///< per time condition: its place, or none
    std::vector<std::uint32_t> of_timer_;      ///< per timer cell: the same
    std::vector<Delay> delays_;                ///< by place
    Zone zone_;
};

/// The greatest duration that divides the lengths of all delays, those of the GRAFCET and the given
/// ones of the other side, and the period if it is not 0.
Time common_quantum(const Grafcet& grafcet, const std::vector<Time>& delays, Time period);

}  // namespace grafwire
