// Equivalence by exploration, breadth first, of the pairs (reference, netlist).
//
// A node is a stable state of the reference together with the settled state of the netlist that
// came with it. Leaving it, a case changes any inputs at once (control inputs included) and lets
// any running delays of time conditions end. The netlist settles from its own state, so that what
// it remembers beyond the X is explored too. If situation and outputs agree, the pair reached is a
// new node unless it has been seen. If they do not, the way there is turned into stimuli with real
// moments and replayed from power-up; only a difference that shows there is reported.
//
// At first the lengths of delays are ignored: a running delay can end at any instant. That takes
// the fewest nodes, and what agrees then agrees whatever the lengths are. But a difference found
// that way may need delays to end in an order which their real lengths exclude. Then the whole
// begins anew with the lengths: a node also has a zone, all that can remain of its running delays,
// and those delays end together, and before the others, of which the zone says that they can. A
// node is new unless it has been seen with a zone that includes its own. So every way explored is
// possible, and every possible one is explored (zone.h).
//
// An input that nobody reads in the state reached is forgotten there: it is left open, as it could
// be changed now without any effect. So states that differ only in such inputs are one node. Nobody
// reads it if a further scan of the reference does not consult it, and if the netlist, with the
// input unknown, keeps the value of everything it remembers. Where the way to a difference needs
// the other value after all, the change without effect is put in as an instant of its own (ways.h).
//
// Breadth first, because the shortest way to a difference is the easiest to read.
//
// Which inputs are varied, and why that is enough: see reference_case.cpp.

#include "check/check_equivalence.h"

#include <algorithm>
#include <deque>

#include "check/netlist_case.h"
#include "check/netlist_witness.h"
#include "check/pair_state.h"
#include "check/reference_case.h"
#include "check/ways.h"
#include "evolution/evolution.h"

namespace grafwire {

namespace {

struct Node {
    PairState pair;
    std::uint32_t way = Ways::start;
};

/// An instant that comes to a node (none: the first instant).
struct Departure {
    const Node* node = nullptr;
    RunningDelays::Ending ending;

    std::uint32_t way() const { return node == nullptr ? Ways::start : node->way; }
};

class Exploration {
  public:
    Exploration(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                const CheckOptions& options, Lengths lengths)
        : grafcet_(grafcet),
          netlist_(netlist),
          delays_(delays),
          evolution_(grafcet),
          reference_(evolution_, netlist.is_clocked()),
          gates_(grafcet, netlist, delays),
          condition_of_timer_(gates_.conditions_of_timers()),
          no_delays_(grafcet.expressions.time_conditions().size(), condition_of_timer_.size(),
                     common_grain(grafcet, netlist), lengths),
          assumptions_(grafcet),
          ways_(assumptions_),
          counter_(options, result_.coverage) {}

    CheckResult run() {
        explore_instant({});
        while (!done_ && !waiting_.empty()) {
            const Node node = std::move(waiting_.front());
            waiting_.pop_front();
            if (!seen_.is_covered(node.pair)) leave(node);
        }
        conclude(result_, waiting_.empty() && !done_ && !is_unexplained_, waiting_.size());
        return std::move(result_);
    }

    bool is_given_up() const { return is_given_up_; }

  private:
    void leave(const Node& node);
    void explore_instant(const Departure& departure);
    void compare(const Departure& departure, const ReferenceOutcome& expected);
    void arrive(const Departure& departure, const PathStep& step, const ReferenceOutcome& expected,
                SimulatorState&& netlist_state);
    void forget_unread_inputs(PairState& pair);
    bool show_difference(const Departure& departure, const PathStep& step);
    void give_up();
    void count(const ReferenceOutcome& expected);
    void note_unstable(const Departure& departure, const PathStep& step,
                       const ReferenceOutcome& expected);

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& delays_;
    Evolution evolution_;
    ReferenceCases reference_;
    NetlistCases gates_;
    std::vector<std::uint32_t> condition_of_timer_;
    RunningDelays no_delays_;
    Assumptions assumptions_;
    std::deque<Node> waiting_;
    SeenPairs seen_;
    Ways ways_;
    CheckResult result_;
    CaseCounter counter_;
    bool done_ = false;
    bool is_given_up_ = false;
    /// A difference was found that no replay from power-up shows. That should not be; if nothing
    /// else is found, there is no verdict.
    bool is_unexplained_ = false;
};

void Exploration::leave(const Node& node) {
    node.pair.delays.for_each_ending([&](const RunningDelays::Ending& ending) {
        explore_instant({&node, ending});
        return !done_;
    });
}

/// All cases of one instant.
void Exploration::explore_instant(const Departure& departure) {
    const Node* node = departure.node;
    const EvolutionState* start = node == nullptr ? nullptr : &node->pair.reference;
    for_each_case(
        assumptions_, open_inputs(grafcet_, netlist_.has_modes),
        [&](const PartialInputs& inputs) {
            return reference_.run(start, departure.ending.ended.conditions, inputs);
        },
        [&](const ReferenceOutcome& expected) {
            compare(departure, expected);
            return !done_;
        });
}

void Exploration::count(const ReferenceOutcome& expected) {
    if (!counter_.count(expected.stable, waiting_.size())) done_ = true;
}

/// Compares the netlist in a case of the reference, closing the open inputs it turns out to react
/// to.
void Exploration::compare(const Departure& departure, const ReferenceOutcome& expected) {
    const Node* node = departure.node;
    const PartialInputs& left = node == nullptr ? expected.inputs : node->pair.inputs;
    std::vector<PathStep> remaining{
        {left, expected.inputs, departure.ending.ended, departure.ending.running}};
    while (!remaining.empty() && !done_) {
        PathStep step = std::move(remaining.back());
        remaining.pop_back();
        if (node == nullptr) step.before = step.inputs;
        if (!assumptions_.can_hold(step.inputs) || !assumptions_.can_hold(step.before)) continue;
        if (!expected.stable) {
            note_unstable(departure, step, expected);
            if (!netlist_.is_clocked()) {
                count(expected);
                continue;
            }
        }
        NetlistOutcome outcome =
            gates_.run(node == nullptr ? nullptr : &node->pair.netlist, left, step, expected);
        if (outcome.kind == NetlistOutcome::Kind::open) {
            PartialInputs& split = outcome.split_before ? step.before : step.inputs;
            for (const Logic value : {Logic::one, Logic::zero}) {
                split[outcome.split] = value;
                remaining.push_back(step);
            }
            continue;
        }
        count(expected);
        if (outcome.kind == NetlistOutcome::Kind::differs) {
            if (show_difference(departure, step)) return;
            is_unexplained_ = true;
            continue;
        }
        // What a clocked netlist does within an instant counts if a run scan by scan can show it.
        if (outcome.kind == NetlistOutcome::Kind::differs_within &&
            show_difference(departure, step)) {
            return;
        }
        if (expected.stable) arrive(departure, step, expected, std::move(outcome.state));
    }
}

void Exploration::arrive(const Departure& departure, const PathStep& step,
                         const ReferenceOutcome& expected, SimulatorState&& netlist_state) {
    PairState next{expected.state, std::move(netlist_state), step.inputs, {}};
    const RunningDelays& before =
        departure.node == nullptr ? no_delays_ : departure.node->pair.delays;
    next.delays = before.after(departure.ending.zone, next.reference, next.netlist,
                               condition_of_timer_, ways_.next());
    if (!seen_.add(next)) return;
    forget_unread_inputs(next);
    if (next.inputs != step.inputs && !seen_.add(next)) return;
    counter_.note(next.reference.situation);
    const std::uint32_t way = ways_.next();
    ways_.add(departure.way(), step);
    waiting_.push_back({std::move(next), way});
}

void Exploration::forget_unread_inputs(PairState& pair) {
    std::vector<std::uint32_t> unread = reference_.unread_inputs(pair.reference, pair.inputs);
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
    const std::vector<PathStep> path = ways_.path(departure.way(), step);
    bool has_moments = false;
    for (const Time gap : gaps_for(path)) {
        const auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap);
        if (!stimuli) continue;
        has_moments = true;
        result_.witness = replay(grafcet_, netlist_, delays_, *stimuli);
        if (result_.witness) {
            done_ = true;
            return true;
        }
    }
    if (!has_moments) give_up();
    return false;
}

/// Ends the exploration without a verdict. That happens where the lengths of delays were ignored
/// and matter.
void Exploration::give_up() {
    done_ = true;
    is_given_up_ = true;
}

void Exploration::note_unstable(const Departure& departure, const PathStep& step,
                                const ReferenceOutcome& expected) {
    if (result_.first_unstable) return;
    const std::vector<PathStep> path = ways_.path(departure.way(), step);
    for (const Time gap : gaps_for(path)) {
        if (auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap)) {
            result_.first_unstable = CheckResult::Unstable{std::move(*stimuli), expected.changing};
            return;
        }
    }
}

}  // namespace

CheckResult check_equivalence(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const CheckOptions& options) {
    Exploration first(grafcet, netlist, delays, options, Lengths::ignored);
    CheckResult result = first.run();
    if (!first.is_given_up()) return result;
    CheckOptions rest = options;
    if (rest.max_cases != 0) {
        rest.max_cases -= std::min(rest.max_cases - 1, result.coverage.cases);
    }
    return Exploration(grafcet, netlist, delays, rest, Lengths::exact).run();
}

}  // namespace grafwire
