// Equivalence by exploration, breadth first, of the pairs (reference, netlist).
//
// A node is a state of the reference together with the settled state of the netlist that came with
// it. Leaving it, a case changes inputs (control inputs included) and lets running delays of time
// conditions end. The netlist goes on from its own state, so that what it remembers beyond the X is
// explored too. If situation and outputs agree, the pair reached is a new node unless it has been
// seen. If they do not, the way there is turned into stimuli with real moments and replayed from
// power-up; only a difference that shows there is reported.
//
// Asynchronous netlists go from instant to instant, and are compared in stable situations. With
// Changes::one an instant brings the change of one input or the end of delays (fundamental mode:
// S. H. Unger, "Asynchronous Sequential Switching Circuits", 1969), with Changes::many any of both.
// Clocked netlists go from scan to scan, a clock cycle each, and are compared after every scan:
// inputs change between any two, also where the evolution is not stable yet, and all delays that
// have fallen due since the scan before end in one.
//
// At first the lengths of delays are ignored: a running delay can end at any time. That takes the
// fewest nodes, and what agrees then agrees whatever the lengths are. But a difference found that
// way may need delays to end in an order which their real lengths exclude. Then the whole begins
// anew with the lengths: a node also has a zone, all that can remain of its running delays, and
// those end of which the zone says that they can. A node is new unless it has been seen with a zone
// that includes its own. So every way explored is possible, and every possible one is explored
// (zone.h). For scans that holds as long as the time between them may vary; a difference that no
// constant period shows leaves the check without a verdict for every period, unless another shows.
//
// An input that nobody reads in the state reached is forgotten there: it is left open, as it could
// be changed now without any effect. So states that differ only in such inputs are one node. Nobody
// reads it if a further scan of the reference does not consult it, and if the netlist, with the
// input unknown, keeps the value of everything it remembers. Where the way to a difference needs
// the other value after all, the change without effect is put in as instants of its own.
//
// Breadth first, because the shortest way to a difference is the easiest to read.
//
// Which inputs are varied, and why that is enough: see reference_case.cpp.

#include "check/exploration.h"

#include <algorithm>
#include <deque>

#include "check/change_sets.h"
#include "check/netlist_case.h"
#include "check/netlist_witness.h"
#include "check/pair_state.h"
#include "check/reference_case.h"
#include "check/relevance.h"
#include "check/ways.h"
#include "evolution/evolution.h"

namespace grafwire {

namespace {

struct Node {
    PairState pair;
    std::uint32_t way = Ways::start;
};

/// An instant or scan that comes to a node (none: the first).
struct Departure {
    const Node* node = nullptr;
    RunningDelays::Ending ending;

    std::uint32_t way() const { return node == nullptr ? Ways::start : node->way; }
    const EvolutionState* reference() const {
        return node == nullptr ? nullptr : &node->pair.reference;
    }
    const SimulatorState* netlist() const {
        return node == nullptr ? nullptr : &node->pair.netlist;
    }
};

class Exploration {
  public:
    Exploration(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                const CheckOptions& options, const ExplorationPlan& plan)
        : grafcet_(grafcet),
          netlist_(netlist),
          delays_(delays),
          plan_(plan),
          counter_(options, explored_.result.coverage),
          evolution_(grafcet),
          reference_(evolution_, [this] { return counter_.goes_on(); }),
          gates_(grafcet, netlist, delays, [this] { return counter_.goes_on(); }),
          relevance_(grafcet),
          assumptions_(grafcet),
          exercised_(grafcet, assumptions_, netlist.has_modes),
          ways_(assumptions_, !is_one_at_a_time()) {
        facts_.passing = plan.passing;
        facts_.period = plan.period;
        facts_.grain = common_grain(grafcet, netlist, plan.period);
        facts_.condition_of_timer = gates_.conditions_of_timers();
        facts_.is_relevant_condition = relevance_.time_conditions();
        facts_.is_relevant_timer = gates_.relevant_timers();
    }

    ExplorationResult run() {
        explore_cases({}, open_inputs(grafcet_, netlist_.has_modes));
        while (!done_ && !waiting_.empty()) {
            const Node node = std::move(waiting_.front());
            waiting_.pop_front();
            if (!seen_.is_covered(node.pair)) leave(node);
        }
        CheckResult& result = explored_.result;
        result.never = exercised_.never();
        result.depends_on_period = no_period_shows_it_ && !result.witness;
        const bool is_complete =
            waiting_.empty() && !done_ && !explored_.result.is_unexplained && !no_period_shows_it_;
        conclude(result, is_complete, waiting_.size());
        return std::move(explored_);
    }

  private:
    bool is_one_at_a_time() const {
        return !netlist_.is_clocked() && plan_.changes == Changes::one;
    }

    void leave(const Node& node);
    void explore_cases(const Departure& departure, const PartialInputs& inputs);
    ReferenceOutcome run_reference(const Departure& departure, const PartialInputs& inputs);
    std::optional<PathStep> step_to(const Departure& departure, const PartialInputs& inputs) const;
    void close(const PathStep& step, const NetlistOutcome& outcome, std::vector<PathStep>& steps);
    void compare(const Departure& departure, const ReferenceOutcome& expected);
    void arrive(const Departure& departure, const PathStep& step, const ReferenceOutcome& expected,
                SimulatorState&& netlist_state);
    void forget_unread_inputs(PairState& pair);
    void write_key(PairState& pair) const;
    bool show_difference(const Departure& departure, const PathStep& step);
    std::vector<PathStep> path_of_instants(const Departure& departure, const PathStep& step) const;
    bool show_after_instants(const std::vector<PathStep>& path);
    bool show_after_scans(const std::vector<PathStep>& path);
    void count(const ReferenceOutcome& expected);
    void note_unstable(const Departure& departure, const PathStep& step,
                       const ReferenceOutcome& expected);

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& delays_;
    ExplorationPlan plan_;
    ExplorationResult explored_;
    CaseCounter counter_;
    Evolution evolution_;
    ReferenceCases reference_;
    NetlistCases gates_;
    Relevance relevance_;
    DelayFacts facts_;
    Assumptions assumptions_;
    Exercised exercised_;
    std::deque<Node> waiting_;
    SeenPairs seen_;
    Ways ways_;
    bool done_ = false;
    bool no_period_shows_it_ = false;
};

void Exploration::leave(const Node& node) {
    const PartialInputs& inputs = node.pair.inputs;
    node.pair.delays.for_each_ending([&](const RunningDelays::Ending& ending) {
        const Departure departure{&node, ending};
        if (!is_one_at_a_time()) {
            explore_cases(departure, open_inputs(grafcet_, netlist_.has_modes));
            return !done_;
        }
        // Delays end, or no input changes that anybody remembers: what the open ones do is seen.
        explore_cases(departure, inputs);
        if (!ending.ended.none()) return !done_;
        for (const PartialInputs& changed :
             single_changes(assumptions_, inputs, netlist_.has_modes)) {
            if (!done_) explore_cases(departure, changed);
        }
        return !done_;
    });
}

ReferenceOutcome Exploration::run_reference(const Departure& departure,
                                            const PartialInputs& inputs) {
    const std::vector<std::uint32_t>& due = departure.ending.ended.conditions;
    return netlist_.is_clocked() ? reference_.scan_after(departure.reference(), due, inputs)
                                 : reference_.instant(departure.reference(), due, inputs);
}

/// All cases of one instant or scan under inputs that are partly open.
void Exploration::explore_cases(const Departure& departure, const PartialInputs& inputs) {
    for_each_case(
        assumptions_, inputs,
        [&](const PartialInputs& some) { return run_reference(departure, some); },
        [&](const ReferenceOutcome& expected) {
            if (expected.broken_off) {
                done_ = true;
            } else {
                compare(departure, expected);
            }
            return !done_;
        });
}

void Exploration::count(const ReferenceOutcome& expected) {
    if (!counter_.count(expected.stable, waiting_.size())) done_ = true;
}

/// The step from a node to inputs of a case; nothing where it takes more changes at once than the
/// plan has.
std::optional<PathStep> Exploration::step_to(const Departure& departure,
                                             const PartialInputs& inputs) const {
    PathStep step{inputs, inputs, departure.ending.ended, departure.ending.running};
    if (departure.node == nullptr) return step;
    step.before = departure.node->pair.inputs;
    if (!is_one_at_a_time()) return step;
    auto before = inputs_before(assumptions_, departure.node->pair.inputs, inputs);
    if (!before) return std::nullopt;
    step.before = std::move(*before);
    return step;
}

/// The steps in which the open input is closed that the netlist turns out to react to.
void Exploration::close(const PathStep& step, const NetlistOutcome& outcome,
                        std::vector<PathStep>& steps) {
    for (const Logic value : {Logic::one, Logic::zero}) {
        PathStep closed = step;
        if (!outcome.split_before) closed.inputs[outcome.split] = value;
        if (outcome.split_before || is_one_at_a_time()) closed.before[outcome.split] = value;
        if (is_one_at_a_time() && assumptions_.can_hold(closed.inputs) &&
            !assumptions_.can_hold(closed.before)) {
            // It cannot have been so before, together with the inputs that change: it changes too.
            closed.before[outcome.split] = ~value;
        }
        steps.push_back(std::move(closed));
    }
}

/// Compares the netlist in a case of the reference, closing the open inputs it turns out to react
/// to.
void Exploration::compare(const Departure& departure, const ReferenceOutcome& expected) {
    const Node* node = departure.node;
    const PartialInputs& left = node == nullptr ? expected.inputs : node->pair.inputs;
    std::vector<PathStep> remaining;
    if (auto step = step_to(departure, expected.inputs)) remaining.push_back(std::move(*step));
    while (!remaining.empty() && !done_) {
        PathStep step = std::move(remaining.back());
        remaining.pop_back();
        if (node == nullptr) step.before = step.inputs;
        if (!assumptions_.can_hold(step.inputs) || !assumptions_.can_hold(step.before)) continue;
        if (!expected.stable) {
            note_unstable(departure, step, expected);
            exercised_.note(expected, step.inputs);
            count(expected);
            continue;
        }
        NetlistOutcome outcome = gates_.run(departure.netlist(), left, step, expected);
        switch (outcome.kind) {
            case NetlistOutcome::Kind::broken_off:
                done_ = true;
                return;
            case NetlistOutcome::Kind::open:
                close(step, outcome, remaining);
                continue;
            default:
                break;
        }
        count(expected);
        exercised_.note(expected, step.inputs);
        if (outcome.has_open_memory) explored_.result.has_open_memory = true;
        if (outcome.kind == NetlistOutcome::Kind::agrees) {
            arrive(departure, step, expected, std::move(outcome.state));
        } else if (show_difference(departure, step)) {
            return;
        }
    }
}

void Exploration::write_key(PairState& pair) const {
    pair.key.clear();
    relevance_.append_key(pair.key, pair.reference);
    pair.delays.append_key(pair.key);
    for (const Logic value : pair.inputs) pair.key += static_cast<char>(value);
    gates_.append_key(pair.key, pair.netlist);
}

void Exploration::arrive(const Departure& departure, const PathStep& step,
                         const ReferenceOutcome& expected, SimulatorState&& netlist_state) {
    PairState next{expected.state, std::move(netlist_state), step.inputs, {}, {}};
    const RunningDelays& before =
        departure.node == nullptr ? RunningDelays(facts_) : departure.node->pair.delays;
    next.delays =
        before.after(facts_, departure.ending.zone, next.reference, next.netlist, ways_.next());
    write_key(next);
    if (!seen_.add(next)) return;
    forget_unread_inputs(next);
    if (next.inputs != step.inputs) {
        write_key(next);
        if (!seen_.add(next)) return;
    }
    counter_.note(next.reference.situation);
    const std::uint32_t way = ways_.next();
    ways_.add(departure.way(), step);
    waiting_.push_back({std::move(next), way});
}

void Exploration::forget_unread_inputs(PairState& pair) {
    std::vector<std::uint32_t> unread;
    // Without modes Init, AUdur and AUdoux are 0 for ever.
    const std::size_t changing = netlist_.has_modes ? pair.inputs.size() : grafcet_.inputs.size();
    if (netlist_.is_clocked()) {
        // Between two scans the reference reads no input.
        for (std::uint32_t i = 0; i < changing; ++i) {
            if (pair.inputs[i] != Logic::unknown) unread.push_back(i);
        }
    } else {
        unread = reference_.unread_inputs(pair.reference, pair.inputs);
        std::erase_if(unread, [&](std::uint32_t input) { return input >= changing; });
    }
    if (unread.empty()) return;
    auto forgotten = gates_.forget(pair.netlist, unread);
    if (!forgotten) {
        // Together they matter to the netlist; some of them may not.
        std::vector<std::uint32_t> rest;
        for (const std::uint32_t input : unread) {
            rest.push_back(input);
            if (auto more = gates_.forget(pair.netlist, rest)) {
                forgotten = std::move(more);
            } else {
                rest.pop_back();
            }
        }
        unread = std::move(rest);
    }
    if (!forgotten) return;
    for (const std::uint32_t input : unread) pair.inputs[input] = Logic::unknown;
    pair.netlist = std::move(*forgotten);
}

/// Turns a difference into the witness, which ends the exploration; false where no run with real
/// moments shows it.
bool Exploration::show_difference(const Departure& departure, const PathStep& step) {
    if (netlist_.is_clocked() ? show_after_scans(ways_.path(departure.way(), step))
                              : show_after_instants(path_of_instants(departure, step))) {
        done_ = true;
        return true;
    }
    return false;
}

/// The way to a step of an asynchronous netlist, with no more changes at an instant than the plan
/// has.
std::vector<PathStep> Exploration::path_of_instants(const Departure& departure,
                                                    const PathStep& step) const {
    std::vector<PathStep> path = ways_.path(departure.way(), step);
    if (!is_one_at_a_time()) return path;
    auto single = one_by_one(assumptions_, path, grafcet_.all_input_count());
    return single ? std::move(*single) : path;
}

bool Exploration::show_after_instants(const std::vector<PathStep>& path) {
    bool has_moments = false;
    for (const Time gap : gaps_for(path)) {
        const auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap);
        if (!stimuli) continue;
        has_moments = true;
        explored_.result.witness = replay(grafcet_, netlist_, delays_, *stimuli, 0);
        if (explored_.result.witness) return true;
    }
    if (!has_moments && plan_.passing == Passing::free) {
        explored_.needs_lengths = true;
        done_ = true;
    } else {
        explored_.result.is_unexplained = true;
    }
    return false;
}

bool Exploration::show_after_scans(const std::vector<PathStep>& path) {
    const auto scans = scans_for(grafcet_, assumptions_, path, plan_.period);
    if (scans) {
        explored_.result.witness =
            replay(grafcet_, netlist_, delays_, scans->stimuli, scans->period);
        if (explored_.result.witness) return true;
        explored_.result.is_unexplained = true;
    } else if (plan_.passing == Passing::free) {
        explored_.needs_lengths = true;
        done_ = true;
    } else {
        no_period_shows_it_ = true;
    }
    return false;
}

void Exploration::note_unstable(const Departure& departure, const PathStep& step,
                                const ReferenceOutcome& expected) {
    if (explored_.result.first_unstable) return;
    const std::vector<PathStep> path = path_of_instants(departure, step);
    for (const Time gap : gaps_for(path)) {
        if (auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap)) {
            explored_.result.first_unstable =
                CheckResult::Unstable{std::move(*stimuli), expected.changing};
            return;
        }
    }
}

}  // namespace

ExplorationResult explore(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                          const CheckOptions& options, const ExplorationPlan& plan) {
    return Exploration(grafcet, netlist, delays, options, plan).run();
}

}  // namespace grafwire
