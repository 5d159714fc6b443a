// Which delays run in a product state, which of them can end next, and what remains afterwards.
//
// The delays of both sides stand in one zone (zone.h), a place for each. A timer that began with
// the time condition it stands for, and is as long, shares its place, so a netlist whose timers are
// right costs no more places than the reference alone. All sets of delays that can end together are
// found by tightening the zone delay by delay: "it ends" and "it runs on" are both tried, and what
// leaves the zone empty is dropped at once.

#include "check/running_delays.h"

#include <numeric>
#include <string>

namespace grafwire {

void RunningDelays::for_each_ending(const std::function<bool(const Ending&)>& visit) const {
    std::vector<bool> ends(zone_.delays());
    choose(zone_, ends.size(), ends, visit);
}

/// Decides for the first `left` delays whether they end; false once nothing more is wanted.
bool RunningDelays::choose(const Zone& zone, std::size_t left, std::vector<bool>& ends,
                           const std::function<bool(const Ending&)>& visit) const {
    if (left == 0) return visit(ending(zone, ends));
    const std::size_t delay = left - 1;
    for (const bool end : {false, true}) {
        Zone rest = zone;
        const bool possible = end ? rest.let_end(delay) : rest.let_run_on(delay);
        if (!possible) continue;
        ends[delay] = end;
        if (!choose(rest, delay, ends, visit)) return false;
    }
    return true;
}

RunningDelays::Ending RunningDelays::ending(const Zone& zone, const std::vector<bool>& ends) const {
    Ending ending{{}, {}, zone};
    for (std::uint32_t k = 0; k < of_condition_.size(); ++k) {
        if (of_condition_[k] != none && ends[of_condition_[k]])
            ending.ended.conditions.push_back(k);
    }
    for (std::uint32_t i = 0; i < of_timer_.size(); ++i) {
        if (of_timer_[i] != none && ends[of_timer_[i]]) ending.ended.timers.push_back(i);
    }
    for (std::size_t i = 0; i < delays_.size(); ++i) {
        ending.running.push_back({delays_[i].begun, delays_[i].length, ends[i]});
    }
    return ending;
}

namespace {

/// Of a delay that is running: it goes on where it was, or has just begun.
Zone::Origin origin_of(std::uint32_t place, Time due, Time quantum) {
    if (due == some_time) return {place, 0};
    return {Zone::Origin::begins, due / quantum};
}

Zone zone_after(const DelayFacts& facts, const Zone& at_instant,
                const std::vector<Zone::Origin>& origins) {
    switch (facts.passing) {
        case Passing::free:
            return Zone::unbounded(origins.size());
        case Passing::to_an_end:
            return at_instant.with(origins).later();
        case Passing::to_a_scan:
            return at_instant.with(origins).at_a_scan();
        case Passing::by_a_period:
            return at_instant.with(origins).after(facts.period / facts.quantum);
    }
    return {};
}

}  // namespace

std::uint32_t RunningDelays::add(RunningDelays& next, std::vector<Zone::Origin>& origins,
                                 Zone::Origin origin, Time length, std::size_t instant) const {
    origins.push_back(origin);
    if (origin.delay == Zone::Origin::begins) {
        next.delays_.push_back({instant, length});
    } else {
        next.delays_.push_back(delays_[origin.delay]);
    }
    return static_cast<std::uint32_t>(origins.size() - 1);
}

RunningDelays RunningDelays::after(const DelayFacts& facts, const Zone& at_instant,
                                   std::vector<Time>& due_of_conditions,
                                   std::vector<Time>& due_of_timers, std::size_t instant) const {
    RunningDelays next(facts);
    std::vector<Zone::Origin> origins;
    for (std::size_t k = 0; k < of_condition_.size(); ++k) {
        Time& due = due_of_conditions[k];
        if (facts.is_relevant_condition[k] == 0) due = never;
        if (due == never) continue;
        const Zone::Origin origin = origin_of(of_condition_[k], due, facts.quantum);
        next.of_condition_[k] = add(next, origins, origin, due, instant);
        due = some_time;
    }
    for (std::size_t i = 0; i < of_timer_.size(); ++i) {
        Time& due = due_of_timers[i];
        if (facts.is_relevant_timer[i] == 0) due = never;
        if (due == never) continue;
        const Zone::Origin origin = origin_of(of_timer_[i], due, facts.quantum);
        const std::uint32_t shared = next.of_condition_[facts.condition_of_timer[i]];
        const bool shares = shared != none && origins[shared] == origin;
        next.of_timer_[i] = shares ? shared : add(next, origins, origin, due, instant);
        due = some_time;
    }
    if (!origins.empty()) next.zone_ = zone_after(facts, at_instant, origins);
    return next;
}

void RunningDelays::encode(std::string& encoding) const {
    std::uint32_t places = 0;
    for (const std::uint32_t place : of_condition_) {
        encoding += place == none ? '.' : '!';
        if (place != none) ++places;
    }
    // Timers with places of their own take them in order, so it is enough to say which do.
    for (const std::uint32_t place : of_timer_) {
        encoding += place == none ? '.' : place < places ? '=' : '!';
    }
}

Time common_quantum(const Grafcet& grafcet, const std::vector<Time>& delays, Time period) {
    Time quantum = period;
    for (const ExprId id : grafcet.expressions.time_conditions()) {
        const TimeCondition& condition = grafcet.expressions.time_condition_of(id);
        quantum = std::gcd(quantum, std::gcd(condition.on_delay, condition.off_delay));
    }
    for (const Time delay : delays) quantum = std::gcd(quantum, delay);
    return quantum == 0 ? 1 : quantum;
}

}  // namespace grafwire
