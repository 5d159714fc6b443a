// Gates and wires of any finite delay.
//
// Where wires are cells, the orders of firings (any_order.cpp) are all there is to them, but there
// are many more. For such circuits ternary simulation is more than a safe answer: a net that it
// leaves unknown does end at either value, or never at rest, as delays want (J. A. Brzozowski,
// C.-J. H. Seger, "Asynchronous Circuits", 1995, chapter 7). That is so of gates with inputs of
// their own; latches, pulse cells, timers and inputs tied together are taken for worse than they
// may be. So where the orders are too many, its one rest, with what is unknown in it, stands for
// all of them: nothing is missed. A difference that comes of it has to be shown by a run, as any
// other, and for that orders with one late gate or wire are tried.

#include "settling/any_wire.h"

#include <algorithm>
#include <iterator>

#include "settling/late_orders.h"
#include "settling/ternary.h"

namespace grafwire {

namespace {

/// With wires, what is not found among a few states is seldom found among many.
constexpr std::size_t share_of_states = 10;

}  // namespace

Rests AnyWire::settle(const CircuitState& start, bool with_firings, std::size_t most_states) {
    Rests rests = any_order_.settle(start, with_firings, most_states / share_of_states);
    const bool may_try_again = !with_firings && most_states < usual_states;
    if (!rests.is_too_large || rests.broken_off || may_try_again) return rests;
    if (!with_firings) {
        rests.rests.assign(1, Rest());
        rests.rests[0].state = ternary_rest(circuit_, start);
        rests.is_too_large = false;
        return rests;
    }
    Rests late = rests_of_late_gates(circuit_, start, keep_going_);
    rests.broken_off = late.broken_off;
    std::move(late.rests.begin(), late.rests.end(), std::back_inserter(rests.rests));
    return rests;
}

Pulsing AnyWire::pulsing(const CircuitState& start, const WatchedNet& watched,
                         std::size_t most_states) {
    Pulsing pulsing = any_order_.pulsing(start, watched, most_states / share_of_states);
    if (pulsing.answer != Pulsing::Answer::open) return pulsing;
    if (auto late = late_order_with_pulse(circuit_, start, watched, keep_going_)) {
        pulsing.answer = Pulsing::Answer::shown;
        pulsing.firings = std::move(*late);
    }
    return pulsing;
}

}  // namespace grafwire
