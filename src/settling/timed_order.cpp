// Gates whose delays have bounds: all orders in which they can fire, and no others.
//
// The cheapest question first. Where ternary simulation knows everything, there is one rest and no
// delay matters. Else all times at which a state can be reached are merged (timed_graph.h), which
// finds every rest and perhaps more: if it finds a single one, and nothing that could go on for
// ever, that is the one there is. Else some times are told apart, then all. Where these are too
// many, what was found with some is the answer, as it misses nothing; what is too much of it does
// not stand a replay.

#include "settling/timed_order.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "settling/ternary.h"

namespace grafwire {

namespace {

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

/// With all their times, states are many more; what is not found among so many is not soon found.
constexpr std::size_t most_exact_classes = 10'000;

/// As many rests as there must be.
bool is_settled(const Rests& rests) {
    return rests.rests.size() == 1 && rests.rests[0].kind == Rest::Kind::settles;
}

bool may_go_on(const Rests& rests) {
    const auto& found = rests.rests;
    return std::any_of(found.begin(), found.end(),
                       [](const Rest& rest) { return rest.kind == Rest::Kind::oscillates; });
}

}  // namespace

TimedOrder::TimedOrder(const Circuit& circuit, CellBands bands, KeepGoing keep_going)
    : circuit_(circuit), keep_going_(std::move(keep_going)), graph_(circuit, std::move(bands)) {}

Rests TimedOrder::explore(const CircuitState& start, const TimedGraph::Search& search,
                          bool with_firings) {
    const TimedGraph::End end = graph_.build(start, search, keep_going_);
    Rests rests;
    rests.states = graph_.class_count();
    rests.broken_off = end == TimedGraph::End::broken_off;
    rests.is_too_large = end == TimedGraph::End::too_large;
    rests.rests = graph_.rests(with_firings);
    std::vector<Rest> oscillations = graph_.oscillations();
    std::move(oscillations.begin(), oscillations.end(), std::back_inserter(rests.rests));
    return rests;
}

/// With the firings that lead to each rest. How many rests there are at most is asked first.
Rests TimedOrder::with_ways(const CircuitState& start, std::size_t most_classes) {
    Rests merged = explore(start, {1, most_classes, 0, false}, false);
    const bool is_bound = !merged.broken_off && !merged.is_too_large && !may_go_on(merged);
    const std::size_t most_rests = is_bound ? merged.rests.size() : 0;
    const std::size_t most = std::min(most_classes, most_exact_classes);
    Rests shortest = explore(start, {all, most, most_rests, false}, true);
    if (!shortest.is_too_large) return shortest;
    return explore(start, {all, most, most_rests, true}, true);
}

Rests TimedOrder::settle(const CircuitState& start, bool with_firings, std::size_t most_states) {
    if (with_firings) return with_ways(start, most_states);
    if (auto rest = rest_of_all_delays(circuit_, start)) return std::move(*rest);
    Rests found = explore(start, {1, most_states, 0, false}, false);
    for (const std::size_t most_of_a_state : {std::size_t{8}, std::size_t{64}, all}) {
        if (found.broken_off || found.is_too_large || is_settled(found) || graph_.is_exact()) break;
        const std::size_t most = std::min(most_states, most_exact_classes);
        Rests closer = explore(start, {most_of_a_state, most, 0, false}, false);
        closer.states += found.states;
        if (closer.is_too_large) break;
        found = std::move(closer);
    }
    return found;
}

/// What merged classes do not show cannot be; what they show counts only where none is merged.
Pulsing TimedOrder::pulsing(const CircuitState& start, const WatchedNet& watched,
                            std::size_t most_states) {
    Pulsing pulsing;
    for (const std::size_t most_of_a_state : {std::size_t{1}, std::size_t{8}, all}) {
        const std::size_t most = std::min(most_states, most_exact_classes);
        const TimedGraph::End end =
            graph_.build(start, {most_of_a_state, most, 0, false}, keep_going_, &watched);
        if (end == TimedGraph::End::complete && !graph_.is_drifting()) {
            pulsing.answer = Pulsing::Answer::never;
        }
        if (end != TimedGraph::End::exceeded) return pulsing;
        if (!graph_.is_exact()) continue;
        pulsing.answer = Pulsing::Answer::shown;
        pulsing.firings = graph_.last_way();
        return pulsing;
    }
    return pulsing;
}

}  // namespace grafwire
