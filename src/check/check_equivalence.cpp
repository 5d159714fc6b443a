// The verdict on a netlist, from one exploration or several (exploration.cpp).
//
// The cheapest question comes first. Lengths of delays count only where ignoring them leads to a
// difference that they exclude; single scan periods are tried only where none is found for all;
// values at power-up are gone through only where three values do not tell. Where one change at a
// time is asked for and makes no difference, many at once are looked at as well (many_changes.cpp),
// since nothing on a bench keeps two contacts from closing within a few nanoseconds. Last comes
// what no X and no output depends on (unobserved_oscillation.cpp).

#include "check/check_equivalence.h"

#include <algorithm>

#include "check/exploration.h"
#include "check/netlist_case.h"
#include "check/netlist_witness.h"

namespace grafwire {

namespace {

constexpr std::uint64_t most_cases_of_a_period = 200'000;
constexpr std::size_t most_uninitialised_memories = 8;

/// What is left of the bounds after some cases.
CheckOptions rest_of(const CheckOptions& options, std::uint64_t cases) {
    CheckOptions rest = options;
    if (rest.max_cases != 0) rest.max_cases -= std::min(rest.max_cases - 1, cases);
    return rest;
}

ExplorationResult explore_netlist(const Grafcet& grafcet, const Netlist& netlist,
                                  const CheckOptions& options, const ExplorationPlan& plan) {
    const CellDelays delays = cell_delays(netlist, options.delays);
    NetlistCases cases(grafcet, netlist, delays, options.keep_going);
    return explore(grafcet, cases, options, plan);
}

/// How time passes where the lengths of delays count.
Passing passing_with_lengths(const Netlist& netlist) {
    return netlist.is_clocked() ? Passing::to_a_scan : Passing::to_an_end;
}

/// Periods worth a look of their own: from one that lets the longest delay end within some scans
/// down to one that divides all lengths, and half of it, so that a delay can begin between the
/// scans of another.
std::vector<Time> telling_periods(const Grafcet& grafcet, const Netlist& netlist) {
    Time longest = 0;
    for (const ExprId id : grafcet.expressions.time_conditions()) {
        const TimeCondition& condition = grafcet.expressions.time_condition_of(id);
        longest = std::max({longest, condition.on_delay, condition.off_delay});
    }
    const Time quantum = common_quantum(grafcet, timer_lengths(netlist), 0);
    std::vector<Time> periods;
    for (Time period = longest / 10; period > quantum && periods.size() < 4; period /= 10) {
        periods.push_back(period);
    }
    for (const Time period : {quantum, quantum / 2}) {
        if (period > longest / 100'000) periods.push_back(period);
    }
    return periods;
}

/// Where no verdict was found for every period, one of them may show a difference all the same. The
/// exploration knows that a delay ends at some scan, not how many scans that takes, and a path that
/// needs many scans is not looked for once there is a shorter one.
std::optional<Witness> difference_with_some_period(const Grafcet& grafcet, const Netlist& netlist,
                                                   const CheckOptions& options) {
    for (const Time period : telling_periods(grafcet, netlist)) {
        CheckOptions some = options;
        if (some.max_cases == 0 || some.max_cases > most_cases_of_a_period) {
            some.max_cases = most_cases_of_a_period;
        }
        ExplorationResult explored = explore_netlist(
            grafcet, netlist, some, {options.changes, Passing::by_a_period, period});
        if (explored.result.witness) return std::move(explored.result.witness);
    }
    return std::nullopt;
}

void add(Coverage& all, const Coverage& more) {
    all.situations = std::max(all.situations, more.situations);
    all.cases += more.cases;
    all.unstable += more.unstable;
    all.waiting += more.waiting;
}

/// Memories that nothing is known of at power-up are unknown in three values. That may be too
/// pessimistic, and it does not tell whether a part comes to rest that stays unknown. So where they
/// are few, every value that they can have is gone through by itself.
void go_through_power_ups(const Grafcet& grafcet, const Netlist& netlist,
                          const CheckOptions& options, CheckResult& result) {
    std::vector<Netlist::InitialValue> power_up = power_up_values(netlist, 0);
    if (power_up.empty() || power_up.size() > most_uninitialised_memories) return;
    for (std::uint32_t number = 0; number < 1U << power_up.size(); ++number) {
        for (std::size_t i = 0; i < power_up.size(); ++i) {
            power_up[i].value = (number >> i & 1U) != 0;
        }
        const CheckResult powered = check_changes(grafcet, with_power_up(netlist, power_up),
                                                  rest_of(options, result.coverage.cases));
        add(result.coverage, powered.coverage);
        if (powered.verdict == Verdict::undecided) return;
        if (powered.verdict == Verdict::different) {
            result.verdict = powered.verdict;
            result.witness = powered.witness;
            result.witness->power_up = power_up;
            return;
        }
    }
    result.verdict = Verdict::equivalent;
    result.complete = true;
    result.is_unexplained = false;
}

}  // namespace

CheckResult check_changes(const Grafcet& grafcet, const Netlist& netlist,
                          const CheckOptions& options) {
    ExplorationPlan plan;
    plan.changes = options.changes;
    if (netlist.is_clocked() && options.scan_period) {
        plan.passing = Passing::by_a_period;
        plan.period = *options.scan_period;
    }
    ExplorationResult explored = explore_netlist(grafcet, netlist, options, plan);
    if (explored.needs_lengths) {
        plan.passing = passing_with_lengths(netlist);
        explored = explore_netlist(grafcet, netlist,
                                   rest_of(options, explored.result.coverage.cases), plan);
    }
    CheckResult& result = explored.result;
    if (result.depends_on_period) {
        result.witness =
            difference_with_some_period(grafcet, netlist, rest_of(options, result.coverage.cases));
        if (result.witness) result.verdict = Verdict::different;
    }
    const bool is_unsettled = result.verdict == Verdict::equivalent
                                  ? result.has_uninitialised_memory
                                  : result.is_unexplained;
    if (is_unsettled && !result.witness) {
        go_through_power_ups(grafcet, netlist, options, result);
    }
    if (result.witness && result.witness->power_up.empty()) {
        result.witness = smallest_witness(grafcet, netlist, *result.witness, options);
    }
    return std::move(result);
}

CheckResult check_equivalence(const Grafcet& grafcet, const Netlist& netlist,
                              const CheckOptions& options) {
    CheckResult result = check_changes(grafcet, netlist, options);
    if (result.verdict == Verdict::equivalent) {
        result.witness =
            find_unobserved_oscillation(grafcet, netlist, options, result.has_uninitialised_memory);
        if (result.witness) result.verdict = Verdict::different;
    }
    if (options.changes == Changes::one && options.looks_at_many && !netlist.is_clocked() &&
        result.verdict == Verdict::equivalent) {
        result.together = check_many_changes(grafcet, netlist,
                                             rest_of(options, result.coverage.cases), result.never);
    }
    return result;
}

}  // namespace grafwire
