// The verdict on a netlist, from one exploration or several (exploration.cpp).
//
// The cheapest question comes first. Lengths of delays count only where ignoring them leads to a
// difference that they exclude; single scan periods are tried only where none is found for all;
// values at power-up are gone through only where three values do not tell. Where one change at a
// time is asked for and makes no difference, many at once are looked at as well
// (check_many_changes), since nothing on a bench keeps two contacts from closing within a few
// nanoseconds. Last comes what no X and no output depends on (find_unobserved_oscillation).

#include "check/check_equivalence.h"

#include <algorithm>
#include <limits>

#include "check/exploration.h"
#include "check/netlist_case.h"
#include "check/netlist_witness.h"
#include "check/path.h"
#include "check/pulse_search.h"
#include "check/racing_case.h"
#include "evolution/evolution.h"
#include "evolution/run.h"
#include "grafcet/plant_conditions.h"
#include "grafcet/write_grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr std::uint64_t most_cases_of_a_period = 200'000;
constexpr std::size_t most_uninitialised_memories = 8;

/// Of a netlist that is wrong somewhere: cases with more are mostly those, and pulses are looked
/// for in the others.
constexpr std::size_t most_states_of_wrong_netlists = 2'000;

/// What is left of the bounds after some cases.
CheckOptions rest_of(const CheckOptions& options, std::uint64_t cases) {
    CheckOptions rest = options;
    if (rest.max_cases != 0) rest.max_cases -= std::min(rest.max_cases - 1, cases);
    return rest;
}

ExplorationResult explore_netlist(const Grafcet& grafcet, const Netlist& netlist,
                                  const CheckOptions& options, const ExplorationPlan& plan,
                                  PulseSearch* pulses = nullptr, bool is_wrong = false) {
    const CellDelays delays = cell_delays(netlist, options.delays);
    const auto make_netlist = [&](const KeepGoing& keep_going) -> std::unique_ptr<ExploredNetlist> {
        if (options.delays.is_fixed()) {
            return std::make_unique<NetlistCases>(grafcet, netlist, delays, keep_going);
        }
        const std::size_t most_states =
            is_wrong ? most_states_of_wrong_netlists : std::numeric_limits<std::size_t>::max();
        return std::make_unique<RacingCases>(grafcet, netlist, delays, options.delays, keep_going,
                                             most_states);
    };
    return explore(grafcet, make_netlist, options, plan, pulses);
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
    all.gate_states += more.gate_states;
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

namespace {

// Many inputs at once, where one at a time makes no difference: what becomes of the verdict, and
// what keeps it.
//
// The witness of a difference under Changes::many has been made as small as it can be, so every
// change in it is needed, and the last instant at which several things happen says what must not
// happen together. Whether the GRAFCET can say that the plant never does so is tried: with the
// assumption that the inputs never are what they all become there, the check has to come out
// equivalent under both kinds of change, with nothing unexercised that was exercised before.

/// The last line of the stimuli that changes several inputs, else the last that changes any.
const Stimuli::Change* decisive_line(const Stimuli& stimuli) {
    const Stimuli::Change* decisive = nullptr;
    for (const Stimuli::Change& change : stimuli.changes) {
        if (change.at == 0) continue;  // what the inputs are at the start is no change
        const std::size_t least = decisive != nullptr && decisive->assignments.size() > 1 ? 2 : 1;
        if (change.assignments.size() >= least) decisive = &change;
    }
    return decisive;
}

ExprId variable_of(Grafcet& grafcet, std::uint32_t input) {
    const auto declared = static_cast<std::uint32_t>(grafcet.inputs.size());
    return grafcet.expressions.variable(input < declared
                                            ? Variable{VariableKind::input, input}
                                            : Variable{VariableKind::control, input - declared});
}

/// "Not all of these together", as an expression of the GRAFCET: `/(a . /b)`, or `a + b` where all
/// become 0.
ExprId never_together(Grafcet& grafcet, const std::vector<Stimuli::Assignment>& assignments) {
    const bool all_fall = std::none_of(assignments.begin(), assignments.end(),
                                       [](const auto& set) { return set.value; });
    std::vector<ExprId> literals;
    for (const Stimuli::Assignment& set : assignments) {
        const ExprId variable = variable_of(grafcet, set.input);
        const bool as_it_is = set.value || all_fall;
        literals.push_back(as_it_is ? variable : grafcet.expressions.negation(variable));
    }
    if (all_fall) return grafcet.expressions.disjunction(literals);
    return grafcet.expressions.negation(grafcet.expressions.conjunction(literals));
}

/// The assumption that keeps the inputs apart, if it does and costs nothing.
std::string assumption_against(const Grafcet& grafcet, const Netlist& netlist,
                               const CheckOptions& options, const NeverExercised& unexercised,
                               const std::vector<Stimuli::Assignment>& assignments) {
    Grafcet assuming = grafcet;
    const ExprId expression = never_together(assuming, assignments);
    assuming.assumptions.push_back({expression, {}});
    if (!contradicting_assumptions(assuming).empty()) return {};
    for (const Changes changes : {Changes::one, Changes::many}) {
        CheckOptions some = options;
        some.changes = changes;
        const CheckResult result = check_changes(assuming, netlist, some);
        if (result.verdict != Verdict::equivalent) return {};
        if (changes == Changes::one && result.never != unexercised) return {};
    }
    return write_expression(assuming, assuming.expressions, expression);
}

/// Where delays are open, a case of many changes can take thousands of times as long as one of a
/// single change, for what is a remark beside the verdict.
std::uint64_t most_cases_of_many(std::uint64_t cases_of_one) {
    return 5'000 + 10 * cases_of_one;
}

/// What becomes of an asynchronous netlist that is equivalent under Changes::one where many inputs
/// change at once. `unexercised`: what Changes::one did not exercise; `cases`: how many it took.
Together check_many_changes(const Grafcet& grafcet, const Netlist& netlist,
                            const CheckOptions& options, const NeverExercised& unexercised,
                            std::uint64_t cases) {
    CheckOptions at_once = options;
    at_once.changes = Changes::many;
    if (!options.delays.is_fixed()) {
        const std::uint64_t most = most_cases_of_many(cases);
        at_once.max_cases = options.max_cases == 0 ? most : std::min(options.max_cases, most);
    }
    CheckResult result = check_changes(grafcet, netlist, at_once);
    Together together;
    together.verdict = result.verdict;
    if (!result.witness) return together;
    together.witness = std::move(result.witness);
    const Stimuli::Change* line = decisive_line(together.witness->stimuli);
    if (line == nullptr) return together;
    for (const Stimuli::Assignment& set : line->assignments) together.inputs.push_back(set.input);
    std::sort(together.inputs.begin(), together.inputs.end());
    together.with_delay = line->assignments.size() == 1;
    const bool is_of_the_plant = std::all_of(
        line->assignments.begin(), line->assignments.end(),
        [&](const Stimuli::Assignment& set) { return set.input < grafcet.inputs.size(); });
    if (line->assignments.size() > 1 && is_of_the_plant) {
        together.assumption =
            assumption_against(grafcet, netlist, options, unexercised, line->assignments);
    }
    return together;
}

// Oscillation where no X and no output looks.
//
// A ring of gates that nothing reads makes no X wrong, but it never comes to rest, which matters
// when it is wired. Its state is no part of the exploration, and in three values it may rest at
// unknown, where the real one goes on and on. So it is simulated in two values, along random walks
// of single changes. Only netlists that have such loops pay for it, and generated ones have none.

constexpr int walks = 16;
constexpr int instants = 60;

bool has_unobserved_loops(const Grafcet& grafcet, const Netlist& netlist) {
    const PortMap ports = map_ports(grafcet, netlist);
    std::vector<NetId> compared = ports.steps;
    compared.insert(compared.end(), ports.outputs.begin(), ports.outputs.end());
    const std::vector<std::uint8_t> relevant = cone_of_influence(netlist, compared);
    const std::vector<std::uint8_t> on_loop = cells_on_loops(netlist);
    for (std::size_t i = 0; i < on_loop.size(); ++i) {
        if (on_loop[i] != 0 && relevant[index_of(netlist.cells.items()[i].output)] == 0)
            return true;
    }
    return false;
}

/// The same numbers every time.
class Dice {
  public:
    explicit Dice(int seed) : state_(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15U + 1) {}
    std::size_t below(std::size_t limit) {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<std::size_t>(state_ >> 33U) % limit;
    }

  private:
    std::uint64_t state_;
};

/// Single changes, one every 10 ms, the first instant with any inputs that the assumptions allow.
std::optional<Stimuli> walk(const Grafcet& grafcet, const Assumptions& assumptions, bool has_modes,
                            Dice& dice) {
    InputValues values(grafcet.all_input_count(), 0);
    for (std::size_t i = 0; i < grafcet.inputs.size(); ++i) {
        values[i] = static_cast<std::uint8_t>(dice.below(2));
    }
    const auto start = assumptions.complete(unassigned_inputs(grafcet, has_modes), values);
    if (!start) return std::nullopt;
    Stimuli stimuli;
    stimuli.changes.push_back({0, differences(InputValues(values.size(), 0), *start), {}});
    PartialInputs inputs = assigned_inputs(*start);
    values = *start;
    for (int instant = 1; instant < instants; ++instant) {
        std::vector<PartialInputs> changes = single_changes(assumptions, inputs, has_modes);
        if (changes.empty()) break;
        inputs = changes[dice.below(changes.size())];
        const InputValues next = *assumptions.complete(inputs, values);
        stimuli.end = instant * 10 * millisecond;
        stimuli.changes.push_back({stimuli.end, differences(values, next), {}});
        values = next;
    }
    return stimuli;
}

/// The values at power-up without which it would not oscillate.
std::vector<Netlist::InitialValue> values_needed(const Grafcet& grafcet, const Netlist& netlist,
                                                 const CellDelays& delays, const Witness& witness,
                                                 std::vector<Netlist::InitialValue> power_up) {
    for (std::size_t i = power_up.size(); i-- > 0;) {
        std::vector<Netlist::InitialValue> rest = power_up;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        const auto again = replay(grafcet, with_power_up(netlist, rest), delays, witness.stimuli,
                                  witness.scan_period);
        if (again && again->kind == DifferenceKind::oscillation) power_up = std::move(rest);
    }
    return power_up;
}

/// Looks for an oscillation beside X and outputs that are right: in parts on which none of these
/// depends, which the exploration does not go through for their own sake, and in memories that have
/// never been given a value (`has_uninitialised_memory`). Walks at random, from known values at
/// power-up. Found, it is a witness; not found, nothing is said.
std::optional<Witness> find_unobserved_oscillation(const Grafcet& grafcet, const Netlist& netlist,
                                                   const CheckOptions& options,
                                                   bool has_uninitialised_memory) {
    if (!has_uninitialised_memory && !has_unobserved_loops(grafcet, netlist)) return std::nullopt;
    const Assumptions assumptions(grafcet);
    const Time period = !netlist.is_clocked() ? 0 : options.scan_period.value_or(10 * millisecond);
    const CellDelays delays = cell_delays(netlist, options.delays);
    for (int number = 0; number < walks; ++number) {
        if (options.keep_going && !options.keep_going()) return std::nullopt;
        Dice dice(number);
        const auto stimuli = walk(grafcet, assumptions, netlist.has_modes, dice);
        if (!stimuli) return std::nullopt;
        const std::vector<Netlist::InitialValue> power_up = power_up_values(netlist, number);
        const Netlist powered = with_power_up(netlist, power_up);
        auto witness = replay(grafcet, powered, delays, *stimuli, period);
        if (!witness || witness->kind != DifferenceKind::oscillation) continue;
        witness->power_up = values_needed(grafcet, netlist, delays, *witness, power_up);
        for (Witness::Value& value : witness->values) value.got = value.expected;
        return witness;
    }
    return std::nullopt;
}

/// Looks for X and outputs that change too often, in an exploration of its own: so the verdict is
/// the same whether it is asked for or not. Where something stays open, it may be that lengths of
/// delays exclude it: then all is gone through with them.
Pulses find_pulses(const Grafcet& grafcet, const Netlist& netlist, const CheckOptions& options,
                   Verdict verdict) {
    const bool is_wrong = verdict == Verdict::different;
    const CellDelays delays = cell_delays(netlist, options.delays);
    ExplorationPlan plan;
    plan.changes = options.changes;
    PulseSearch search(grafcet, netlist, delays, options);
    ExplorationResult explored =
        explore_netlist(grafcet, netlist, options, plan, &search, is_wrong);
    const bool is_told = explored.result.complete && !search.has_open();
    const bool is_cut_short = explored.result.coverage.waiting != 0;
    if (!is_told && !is_cut_short && !grafcet.expressions.time_conditions().empty()) {
        search.begin_again();
        plan.passing = passing_with_lengths(netlist);
        explored = explore_netlist(grafcet, netlist, options, plan, &search, is_wrong);
    }
    Pulses pulses = search.take();
    pulses.complete = explored.result.complete;
    return pulses;
}

}  // namespace

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
        result.together =
            check_many_changes(grafcet, netlist, rest_of(options, result.coverage.cases),
                               result.never, result.coverage.cases);
    }
    if (options.looks_for_pulses && !netlist.is_clocked()) {
        result.pulses = find_pulses(grafcet, netlist, options, result.verdict);
    }
    return result;
}

}  // namespace grafwire
