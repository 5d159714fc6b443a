#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "check/path.h"
#include "check/zone.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"

namespace grafwire {

/// In the states that the exploration keeps, delays have no moment at which they end: `due` is
/// `never` where none is running, else this. What remains of them is told by a Zone.
inline constexpr Time some_time = never - 1;

/// Whether the lengths of delays count: in the first case a running delay can end at any instant.
enum class Lengths { ignored, exact };

/// The delays that run in a state of reference and netlist, and what can remain of them.
///
/// A timer of the netlist whose delay began together with that of the time condition it stands for,
/// and has the same length, shares its place in the zone: so it is as long as the netlist is right.
/// Any other has a place of its own.
class RunningDelays {
  public:
    RunningDelays() = default;
    /// Before the first instant: no delay is running. `grain`: a duration that divides all lengths.
    RunningDelays(std::size_t conditions, std::size_t timers, Time grain, Lengths lengths)
        : lengths_(lengths),
          grain_(grain),
          of_condition_(conditions, none),
          of_timer_(timers, none) {}

    /// What can remain at the next instant, before it is known which delays end at it.
    const Zone& zone() const { return zone_; }

    /// One way in which the next instant can come.
    struct Ending {
        EndedDelays ended;
        std::vector<RunningDelay> running;  ///< all delays, the instants as given to after()
        Zone zone;                          ///< what can remain of them at the instant
    };
    /// Every set of delays that can end together, and before the others; the empty set too, as far
    /// as there is time before the first must end. `visit` says whether to go on.
    void for_each_ending(const std::function<bool(const Ending&)>& visit) const;

    /// The delays after an instant. `at_instant` is the zone at it; both states are as the instant
    /// left them, `due` being `some_time` for a delay that goes on and the length of one that began
    /// at it. They get `some_time` for these too. `instant` is the number of the instant.
    /// `condition_of_timer`: per timer, the time condition it stands for.
    RunningDelays after(const Zone& at_instant, EvolutionState& reference, SimulatorState& netlist,
                        const std::vector<std::uint32_t>& condition_of_timer,
                        std::size_t instant) const;

    /// Adds to a key what is not in the zone: which delays run, and which share a place.
    void append_key(std::string& key) const;

  private:
    static constexpr std::uint32_t none = 0xffffffffU;
    struct Delay {
        std::size_t begun;
        Time length;
    };
    bool choose(const Zone& zone, std::size_t left, std::vector<bool>& ends,
                const std::function<bool(const Ending&)>& visit) const;
    Ending ending(const Zone& zone, const std::vector<bool>& ends) const;
    Zone::Origin origin_of(std::uint32_t place, Time due) const;
    std::uint32_t add(RunningDelays& next, std::vector<Zone::Origin>& origins, Zone::Origin origin,
                      std::size_t instant) const;

    Lengths lengths_ = Lengths::exact;
    Time grain_ = 1;
    std::vector<std::uint32_t> of_condition_;  ///< per time condition: its place, or none
    std::vector<std::uint32_t> of_timer_;      ///< per timer cell: the same
    std::vector<Delay> delays_;                ///< by place
    Zone zone_;
};

/// The greatest duration that divides the lengths of all delays on both sides.
Time common_grain(const Grafcet& grafcet, const Netlist& netlist);

}  // namespace grafwire
