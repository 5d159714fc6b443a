// The cases of a chart, breadth first, each run in every order (order_case.cpp).
//
// States and cases are those of a check, without a netlist: an input stays unassigned as long as
// nothing looks at it (check/reference_case.cpp), here in no order; delays end when their lengths
// allow (check/zone.h), which is left out of account until a race is found that no times fit. After
// a race the search goes on from where the reference has come to.
//
// Where the chart is to be like another, that one goes along, case by case. Its delays have places
// of their own among those that run, shared as long as both began together.

#include "orders/find_races.h"

#include <algorithm>
#include <deque>
#include <set>
#include <string>
#include <tuple>

#include "check/partial_inputs.h"
#include "check/path.h"
#include "check/reference_case.h"
#include "check/running_delays.h"
#include "check/state_encoding.h"
#include "check/state_space.h"
#include "evolution/run.h"

namespace grafwire {

namespace {

/// A stable state of the chart, and of the one it is to be like.
struct OrderState {
    EvolutionState chart;
    EvolutionState other;
    PartialInputs inputs;
    RunningDelays delays;
    std::string encoding;
    std::uint32_t step = PredecessorTree::root;  ///< that led to it
};

/// An instant that comes to a state (nullptr: the first).
struct OrderEdge {
    const OrderState* source = nullptr;
    RunningDelays::Ending ending{};
};

class RaceSearch {
  public:
    RaceSearch(const Grafcet& grafcet, const RaceOptions& options, Passing passing)
        : grafcet_(grafcet),
          other_(options.like == nullptr ? grafcet : *options.like),
          options_(options),
          cases_(grafcet, options.keep_going),
          other_evolution_(other_),
          reference_(cases_.evolution(), options.keep_going),
          other_reference_(other_evolution_, options.keep_going),
          relevance_(grafcet),
          assumptions_(grafcet),
          predecessors_(assumptions_, false) {
        facts_.passing = passing;
        facts_.quantum = common_quantum(grafcet, {}, 0);
        facts_.is_relevant_condition = relevance_.time_conditions();
        if (!is_compared()) return;
        facts_.is_relevant_timer = Relevance(other_).time_conditions();
        for (std::uint32_t i = 0; i < facts_.is_relevant_timer.size(); ++i) {
            facts_.condition_of_timer.push_back(i);
        }
    }

    RaceReport run() {
        explore({}, first_inputs());
        while (!done_ && !waiting_.empty()) {
            const OrderState state = std::move(waiting_.front());
            waiting_.pop_front();
            if (!visited_.is_covered(state.encoding, state.delays.zone())) expand(state);
        }
        report_.is_complete = !done_ && !has_open_cases_;
        return std::move(report_);
    }
    /// Whether a race was found for which there are no times.
    bool needs_lengths() const { return needs_lengths_; }

  private:
    bool is_compared() const { return options_.like != nullptr; }

    PartialInputs first_inputs() const;
    void expand(const OrderState& state);
    void explore(const OrderEdge& edge, const PartialInputs& inputs);
    ReferenceOutcome run_case(const OrderEdge& edge, const PartialInputs& inputs);
    void judge(const OrderEdge& edge, const ReferenceOutcome& expected);
    bool is_alike(const EvolutionState& chart, bool is_stable) const;
    void run_other(const OrderEdge& edge, const PartialInputs& inputs,
                   std::vector<std::uint8_t>& consulted);
    std::optional<PathStep> step_to(const OrderEdge& edge, const PartialInputs& inputs) const;
    std::optional<Stimuli> stimuli_to(const OrderEdge& edge, const PathStep& step);
    void add_race(const OrderEdge& edge, const PathStep& step);
    void add_successor(const OrderEdge& edge, const PathStep& step, EvolutionState&& chart,
                       EvolutionState&& other);
    void leave_unread_inputs(OrderState& state) const;
    void encode(OrderState& state) const;

    const Grafcet& grafcet_;
    const Grafcet& other_;
    const RaceOptions& options_;
    OrderCases cases_;
    Evolution other_evolution_;
    ReferenceCases reference_;
    ReferenceCases other_reference_;
    Relevance relevance_;
    Assumptions assumptions_;
    DelayFacts facts_;
    std::deque<OrderState> waiting_;
    VisitedStates visited_;
    PredecessorTree predecessors_;
    RaceReport report_;
    OrderOutcome outcome_;          ///< of the case that was run last
    ReferenceOutcome found_other_;  ///< the same of the other chart
    std::set<std::tuple<RaceKind, TransitionId, TransitionId>> found_;
    bool done_ = false;
    bool has_open_cases_ = false;
    bool needs_lengths_ = false;
};

/// Any inputs, but no AUdur: what could be cleared at the start would be gone with all else.
PartialInputs RaceSearch::first_inputs() const {
    PartialInputs inputs = unassigned_inputs(grafcet_, options_.has_modes);
    const PartialInputs any = inputs;
    inputs[grafcet_.inputs.size() + static_cast<std::size_t>(ControlInput::au_dur)] =
        PartialInput::zero;
    return assumptions_.can_hold(inputs) ? inputs : any;
}

void RaceSearch::expand(const OrderState& state) {
    state.delays.for_each_ending([&](const RunningDelays::Ending& ending) {
        const OrderEdge edge{&state, ending};
        explore(edge, state.inputs);
        if (!ending.ended.none()) return !done_;
        for (const PartialInputs& changed :
             single_changes(assumptions_, state.inputs, options_.has_modes)) {
            if (!done_) explore(edge, changed);
        }
        return !done_;
    });
}

void RaceSearch::explore(const OrderEdge& edge, const PartialInputs& inputs) {
    for_each_case(
        assumptions_, inputs, [&](const PartialInputs& some) { return run_case(edge, some); },
        [&](const ReferenceOutcome& expected) {
            ++report_.cases;
            const bool is_over = options_.max_cases != 0 && report_.cases >= options_.max_cases;
            const bool goes_on = !options_.keep_going || options_.keep_going();
            if (expected.broken_off || !goes_on) done_ = true;
            if (!done_) judge(edge, expected);
            if (is_over) done_ = true;
            return !done_;
        });
}

/// The state that an instant starts from, at which these delays end.
EvolutionState begun(const EvolutionState* before, const std::vector<std::uint32_t>& due,
                     const Evolution& evolution, const EvolutionInputs& inputs) {
    if (before == nullptr) return evolution.start(inputs);
    EvolutionState state = *before;
    for (const std::uint32_t condition : due) state.due[condition] = 0;
    if (!due.empty()) evolution.end_delays(state, inputs, 0);
    return state;
}

/// The same case of the other chart; the inputs that it looked at are noted.
void RaceSearch::run_other(const OrderEdge& edge, const PartialInputs& inputs,
                           std::vector<std::uint8_t>& consulted) {
    const EvolutionState* before = edge.source == nullptr ? nullptr : &edge.source->other;
    found_other_ = other_reference_.instant(before, edge.ending.ended.timers, inputs);
    for (const std::uint32_t input : found_other_.assigned) consulted[input] = 1;
}

/// A case in every order. Unassigned inputs are 0; those that any order looked at are assigned
/// then.
ReferenceOutcome RaceSearch::run_case(const OrderEdge& edge, const PartialInputs& inputs) {
    InputValues values(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) values[i] = inputs[i] == PartialInput::one;
    std::vector<std::uint8_t> consulted(inputs.size());
    const EvolutionState* before = edge.source == nullptr ? nullptr : &edge.source->chart;
    outcome_ = cases_.outcome(
        begun(before, edge.ending.ended.conditions, cases_.evolution(), {values, &consulted}),
        values);
    if (is_compared()) run_other(edge, inputs, consulted);
    ReferenceOutcome expected;
    expected.stable = outcome_.kind != OrderOutcome::Kind::unstable;
    expected.broken_off = outcome_.kind == OrderOutcome::Kind::broken_off;
    expected.inputs = inputs;
    for (std::uint32_t i = 0; i < inputs.size(); ++i) {
        if ((consulted[i] | outcome_.consulted[i]) == 0) continue;
        if (inputs[i] != PartialInput::unassigned) continue;
        expected.inputs[i] = PartialInput::zero;
        expected.assigned.push_back(i);
    }
    return expected;
}

/// The step to inputs of a case; nothing where it takes more changes at once than one.
std::optional<PathStep> RaceSearch::step_to(const OrderEdge& edge,
                                            const PartialInputs& inputs) const {
    PathStep step{inputs, inputs, edge.ending.ended, edge.ending.running};
    if (edge.source == nullptr) return step;
    auto before = inputs_before(assumptions_, edge.source->inputs, inputs);
    if (!before) return std::nullopt;
    step.before = std::move(*before);
    return step;
}

void RaceSearch::judge(const OrderEdge& edge, const ReferenceOutcome& expected) {
    const auto step = step_to(edge, expected.inputs);
    if (!step) return;
    if (outcome_.kind == OrderOutcome::Kind::too_large) has_open_cases_ = true;
    if (outcome_.race) add_race(edge, *step);
    if (is_compared() && !is_alike(outcome_.state, expected.stable)) {
        if (!report_.unlike) report_.unlike = stimuli_to(edge, *step);
        return;
    }
    if (expected.stable && !done_) {
        add_successor(edge, *step, std::move(outcome_.state), std::move(found_other_.state));
    }
}

/// Whether the other chart has come to the same.
bool RaceSearch::is_alike(const EvolutionState& chart, bool is_stable) const {
    if (found_other_.stable != is_stable) return false;
    const EvolutionState& other = found_other_.state;
    return !is_stable ||
           (chart.situation == other.situation && chart.vars == other.vars &&
            chart.stored_outputs == other.stored_outputs && chart.counters == other.counters);
}

std::optional<Stimuli> RaceSearch::stimuli_to(const OrderEdge& edge, const PathStep& step) {
    const std::uint32_t from = edge.source == nullptr ? PredecessorTree::root : edge.source->step;
    std::vector<PathStep> path = predecessors_.path(from, step);
    if (auto single = one_by_one(assumptions_, path, grafcet_.all_input_count())) {
        path = std::move(*single);
    }
    if (auto stimuli = first_stimuli_for(grafcet_, assumptions_, path)) return stimuli;
    needs_lengths_ = true;
    if (facts_.passing == Passing::free) done_ = true;
    return std::nullopt;
}

void RaceSearch::add_race(const OrderEdge& edge, const PathStep& step) {
    const OrderRace& race = *outcome_.race;
    if (found_.contains({race.kind, race.first, race.second})) return;
    auto stimuli = stimuli_to(edge, step);
    if (!stimuli) return;
    found_.insert({race.kind, race.first, race.second});
    report_.races.push_back({race, std::move(*stimuli)});
}

void RaceSearch::encode(OrderState& state) const {
    state.encoding.clear();
    relevance_.encode(state.encoding, state.chart);
    if (is_compared()) relevance_.encode(state.encoding, state.other);
    state.delays.encode(state.encoding);
    for (const PartialInput value : state.inputs) state.encoding += static_cast<char>(value);
}

void RaceSearch::leave_unread_inputs(OrderState& state) const {
    const std::size_t changing = options_.has_modes ? state.inputs.size() : grafcet_.inputs.size();
    const std::vector<std::uint32_t> unread = reference_.unread_inputs(state.chart, state.inputs);
    std::vector<std::uint32_t> unread_by_other = unread;
    if (is_compared()) {
        unread_by_other = other_reference_.unread_inputs(state.other, state.inputs);
    }
    for (const std::uint32_t input : unread) {
        const bool is_unread_by_both =
            std::binary_search(unread_by_other.begin(), unread_by_other.end(), input);
        if (input < changing && is_unread_by_both) state.inputs[input] = PartialInput::unassigned;
    }
}

void RaceSearch::add_successor(const OrderEdge& edge, const PathStep& step, EvolutionState&& chart,
                               EvolutionState&& other) {
    OrderState next{std::move(chart), std::move(other), step.inputs, {}, {}, predecessors_.next()};
    const RunningDelays& before =
        edge.source == nullptr ? RunningDelays(facts_) : edge.source->delays;
    next.delays = before.after(facts_, edge.ending.zone, next.chart.due, next.other.due, next.step);
    leave_unread_inputs(next);
    encode(next);
    if (!visited_.add(next.encoding, next.delays.zone())) return;
    predecessors_.add(edge.source == nullptr ? PredecessorTree::root : edge.source->step, step);
    waiting_.push_back(std::move(next));
}

}  // namespace

RaceReport find_races(const Grafcet& grafcet, const RaceOptions& options) {
    RaceSearch free(grafcet, options, Passing::free);
    RaceReport report = free.run();
    if (!free.needs_lengths()) return report;
    return RaceSearch(grafcet, options, Passing::to_an_end).run();
}

}  // namespace grafwire
