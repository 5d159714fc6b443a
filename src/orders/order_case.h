#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "text/keep_going.h"
#include "text/table.h"
#include "trace/input_values.h"

namespace grafwire {

/// What goes otherwise in another order.
enum class RaceKind : std::uint8_t {
    withdrawn,   ///< a transition that could be cleared no longer can be, without having been
    arrival,     ///< a step is activated that an outstanding transition is still to leave
    difference,  ///< what there is in the end is not the same
    unrest,      ///< there is an order in which there is no end
};

/// Two transitions that can be cleared at one moment, and an order in which it matters which of
/// them comes first.
struct OrderRace {
    RaceKind kind = RaceKind::withdrawn;
    /// What is cleared before the other, to ill effect; `none`: it is no transition but what
    /// becomes of an order, an enclosure or a time condition.
    TransitionId first = none;
    TransitionId second{};  ///< the other
    BitTable together;      ///< the situation in the end where all are cleared at once
    /// That in the end where `first` goes before; none where there is no end.
    std::optional<BitTable> apart;
};

/// What a case comes to.
struct OrderOutcome {
    enum class Kind : std::uint8_t {
        independent,  ///< every order has the same end
        dependent,    ///< `race` says why not
        unstable,     ///< the chart has no stable situation there by itself
        too_large,    ///< more orders than are gone through
        broken_off,   ///< the work is to stop
    };
    Kind kind = Kind::independent;
    std::optional<OrderRace> race;
    EvolutionState state;  ///< that of the reference in the end, where it has one
    /// How the reference ran: per transition, 1 where it was cleared.
    std::vector<std::uint8_t> cleared;
    std::vector<std::uint8_t> consulted;  ///< per input, 1 where any order looked at it
};

/// What is looked up in a chart, worked out once.
struct OrderFacts {
    explicit OrderFacts(const Grafcet& grafcet);

    /// Per transition, the products of which its receptivity is the sum.
    std::vector<std::vector<ExprId>> products;
    /// Per transition, 1 where its receptivity reads an edge.
    std::vector<std::uint8_t> reads_edge;
};

/// A chart, case by case, in every order in which its transitions can be cleared. The GRAFCET must
/// outlive it.
class OrderCases {
  public:
    explicit OrderCases(const Grafcet& grafcet, KeepGoing keep_going = {})
        : grafcet_(grafcet),
          keep_going_(std::move(keep_going)),
          evolution_(grafcet),
          facts_(grafcet) {}

    /// One instant, at time 0, from a stable state: its inputs have become these, and the delays
    /// that end at it have ended (Evolution::end_delays).
    OrderOutcome outcome(const EvolutionState& state, const InputValues& inputs) const;

    const Evolution& evolution() const { return evolution_; }

  private:
    const Grafcet& grafcet_;
    KeepGoing keep_going_;
    Evolution evolution_;
    OrderFacts facts_;
};

}  // namespace grafwire
