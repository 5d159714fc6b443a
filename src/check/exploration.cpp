// Equivalence by exploration, breadth first, of the product of reference and netlist.
//
// A node is a state of the reference together with the settled state of the netlist that came with
// it. An edge from it is an instant or scan at which inputs change (control inputs included) and
// running delays of time conditions end. The netlist goes on from its own state, so that what it
// remembers beyond the X is explored too. It may have several outcomes in a case (where its delays
// are not known exactly); each one is compared, and each one that agrees is a successor. Where
// situation and outputs agree, the product state is a new node unless it has been visited. Where
// they do not, the path there is turned into stimuli with real times and replayed from power-up;
// only a difference that shows there is reported.
//
// Asynchronous netlists go from instant to instant, and are compared in stable situations. With
// Changes::one an instant brings the change of one input or the end of delays (fundamental mode:
// D. A. Huffman, "The synthesis of sequential switching circuits", J. Franklin Inst. 257, 1954;
// S. H. Unger, "Asynchronous Sequential Switching Circuits", 1969), with Changes::many any of both.
// Clocked netlists go from scan to scan, a clock cycle each, and are compared after every scan:
// inputs change between any two, also where the evolution is not stable yet, and all delays that
// have fallen due since the scan before end in one.
//
// At first the lengths of delays are ignored: a running delay can end at any time. That takes the
// fewest nodes, and what agrees then agrees whatever the lengths are. But a difference found that
// way may need delays to end in an order which their real lengths exclude. Then the exploration is
// repeated with the lengths: a node also has a zone, all that can remain of its running delays, and
// those end of which the zone says that they can. A node is new unless it has been visited with a
// zone that includes its own. So every path explored is possible, and every possible one is
// explored (zone.h). For scans that holds as long as the time between them may vary; a difference
// that no constant period shows leaves the check without a verdict for every period, unless another
// shows.
//
// An input that nothing reads in the state reached is abstracted away there: it is left unassigned,
// as it could be changed now without any effect. So states that differ only in such inputs are one
// node. Nothing reads it if a further scan of the reference does not consult it, and if the
// netlist, with the input unknown, keeps the value of everything it remembers. Where the path to a
// difference needs the other value after all, the change without effect is put in as instants of
// its own.
//
// Breadth first, because the shortest path to a difference is the easiest to read.
//
// Several workers can share it where a case takes long. What the netlist does in one needs nothing
// that is known of the others (expansion.cpp); so cases of the nodes that wait longest are gone
// through side by side, while one of the workers takes what they find, case by case in their order.
// Verdict, witness and counts are then those of a worker alone.
//
// Which inputs are varied, and why that is enough: see reference_case.cpp.

#include "check/exploration.h"

#include <algorithm>
#include <deque>

#include "check/coverage.h"
#include "check/expansion.h"
#include "check/partial_inputs.h"
#include "check/pulse_search.h"
#include "check/shared_work.h"
#include "check/state_encoding.h"
#include "check/state_space.h"
#include "evolution/evolution.h"

namespace grafwire {

namespace {

struct Node {
    ProductState state;
    std::uint32_t step = PredecessorTree::root;  ///< that led to it
};

/// A node whose cases are gone through while those of nodes before it may not have had their turn.
struct NodeInHand {
    Node node;
    std::size_t number = 0;   ///< in the order in which they were taken in hand
    bool has_begun = false;   ///< its turn has come
    bool is_covered = false;  ///< by then
};

/// What the reference does in a case, for somebody to run the netlist in.
struct SharedCase {
    std::shared_ptr<NodeInHand> from;  ///< nullptr before power-up
    RunningDelays::Ending ending;
    ReferenceOutcome expected;

    const Node* node() const { return from == nullptr ? nullptr : &from->node; }
};

/// What the netlist does in it, as far as it is split.
struct SharedOutcome {
    PathStep step;
    NetlistOutcomes outcomes;
};

/// So many cases a worker has before it at a time.
constexpr std::size_t cases_of_a_worker = 64;

class Exploration {
  public:
    Exploration(const Grafcet& grafcet, const ExploredNetlistMaker& make_netlist,
                const CheckOptions& options, const ExplorationPlan& plan, PulseSearch* pulses)
        : grafcet_(grafcet),
          netlist_(make_netlist(options.keep_going)),
          together_(options.workers),
          plan_(plan),
          pulses_(pulses),
          evolution_(grafcet),
          reference_(evolution_, {}),
          relevance_(grafcet),
          assumptions_(grafcet),
          coverage_(grafcet, assumptions_, netlist_->has_modes(), options,
                    explored_.result.coverage),
          predecessors_(assumptions_, !is_one_at_a_time()) {
        facts_.passing = plan.passing;
        facts_.period = plan.period;
        facts_.quantum = common_quantum(grafcet, netlist_->delays(), plan.period);
        facts_.condition_of_timer = netlist_->conditions_of_timers();
        facts_.is_relevant_condition = relevance_.time_conditions();
        facts_.is_relevant_timer = netlist_->relevant_timers();
        if (together_.count() == 1 || !netlist_->is_worth_sharing()) {
            expanders_.push_back(std::make_unique<Expander>(
                grafcet, netlist_, plan, [this] { return coverage_.goes_on(); }));
            return;
        }
        const auto add_expander = [&](const KeepGoing& keep_going) {
            expanders_.push_back(
                std::make_unique<Expander>(grafcet, make_netlist(keep_going), plan, keep_going));
        };
        add_expander([this] {
            together_.take_turns();  // what others have found may end it
            return !together_.is_over() && coverage_.goes_on();
        });
        const KeepGoing keep_going = [this, ask = options.keep_going] {
            return !together_.is_over() && (!ask || ask());
        };
        while (expanders_.size() < together_.count()) add_expander(keep_going);
        // It runs no netlist.
        lister_ = std::make_unique<Expander>(grafcet, netlist_, plan, keep_going);
    }

    ExplorationResult run() {
        if (lister_ == nullptr) {
            explore_alone();
        } else {
            explore_together();
        }
        CheckResult& result = explored_.result;
        result.never = coverage_.never_exercised();
        result.depends_on_period = no_period_shows_it_ && !result.witness;
        const bool is_complete = waiting_.empty() && !together_.is_over() &&
                                 !result.is_unexplained && !result.has_unexplored_orders &&
                                 !no_period_shows_it_ && !has_left_out_;
        conclude(result, is_complete, waiting());
        return std::move(explored_);
    }

  private:
    bool is_one_at_a_time() const {
        return !netlist_->is_clocked() && plan_.changes == Changes::one;
    }

    bool is_covered(const Node& node) const {
        return visited_.is_covered(node.state.encoding, node.state.delays.zone());
    }
    void explore_alone();
    void expand(const Node* node);
    void explore_together();
    void list_cases(const std::shared_ptr<NodeInHand>& from);
    bool is_left_out(const SharedCase& item);
    void share_cases();
    /// The nodes that have not had their turn.
    std::size_t waiting() const { return waiting_.size() + ahead_; }
    void take(const Node* node, const RunningDelays::Ending& ending,
              const ReferenceOutcome& expected, const PathStep& step, NetlistOutcomes& outcomes);
    bool follow(const Node* node, const RunningDelays::Ending& ending, const PathStep& step,
                const ReferenceOutcome& expected, NetlistOutcomes& outcomes);
    void look_for_pulses(const Node* node, const PathStep& step);
    std::vector<Stimuli> stimuli_of(const Node* node, const PathStep& step) const;
    void add_successor(const Node* node, const RunningDelays::Ending& ending, const PathStep& step,
                       const ReferenceOutcome& expected, SimulatorState&& netlist_state);
    void abstract_unread_inputs(ProductState& state);
    void encode(ProductState& state) const;
    bool show_difference(const Node* node, const PathStep& step);
    std::vector<PathStep> path_of_instants(const Node* node, const PathStep& step) const;
    bool show_after_instants(const std::vector<PathStep>& path);
    bool show_after_scans(const std::vector<PathStep>& path);
    void record_case(const ReferenceOutcome& expected, const PathStep& step);
    void note_unstable(const Node* node, const PathStep& step, const ReferenceOutcome& expected);

    const Grafcet& grafcet_;
    std::shared_ptr<ExploredNetlist> netlist_;
    SharedWork<SharedCase, SharedOutcome> together_;
    ExplorationPlan plan_;
    PulseSearch* pulses_;
    ExplorationResult explored_;
    Evolution evolution_;
    ReferenceCases reference_;
    Relevance relevance_;
    DelayFacts facts_;
    Assumptions assumptions_;
    CoverageRecorder coverage_;
    std::vector<std::unique_ptr<Expander>> expanders_;  ///< one a worker
    std::unique_ptr<Expander> lister_;  ///< of cases that are shared; nullptr where none are
    std::deque<Node> waiting_;
    std::deque<SharedCase> cases_;  ///< listed, and to be shared
    std::size_t in_hand_ = 0;       ///< so many nodes have been taken in hand
    std::size_t ahead_ = 0;         ///< those of them after the one whose turn it is
    VisitedStates visited_;
    PredecessorTree predecessors_;
    bool no_period_shows_it_ = false;
    bool has_left_out_ = false;  ///< where there are pulses to look for: a difference
};

/// The number of the step that led to a node; the root before power-up.
std::uint32_t step_of(const Node* node) {
    return node == nullptr ? PredecessorTree::root : node->step;
}

/// All cases that leave a node, one after the other.
void Exploration::expand(const Node* node) {
    const auto visit = [&](ExpandedCase&& found) {
        take(node, found.ending, found.expected, found.step, found.outcomes);
        return !together_.is_over();
    };
    if (!expanders_.front()->expand(node == nullptr ? nullptr : &node->state, visit))
        together_.end();
}

void Exploration::explore_alone() {
    expand(nullptr);
    while (!together_.is_over() && !waiting_.empty()) {
        const Node node = std::move(waiting_.front());
        waiting_.pop_front();
        if (!is_covered(node)) expand(&node);
    }
}

/// The cases of the nodes that wait longest are listed and shared among the workers. What they find
/// is taken in the order of the cases.
void Exploration::explore_together() {
    list_cases(nullptr);
    while (!together_.is_over() && !(waiting_.empty() && cases_.empty())) {
        while (!waiting_.empty() && cases_.size() < cases_of_a_worker * expanders_.size()) {
            auto from = std::make_shared<NodeInHand>();
            from->node = std::move(waiting_.front());
            from->number = ++in_hand_;
            waiting_.pop_front();
            if (!is_covered(from->node)) list_cases(from);
            if (together_.is_over()) return;
        }
        share_cases();
    }
}

/// Lists all cases that leave a node; those that are too many at once are shared on the way.
void Exploration::list_cases(const std::shared_ptr<NodeInHand>& from) {
    const auto add = [&](const RunningDelays::Ending& ending, const ReferenceOutcome& expected) {
        cases_.push_back({from, ending, expected});
        if (cases_.size() >= cases_of_a_worker * expanders_.size()) share_cases();
        return !together_.is_over();
    };
    const ProductState* state = from == nullptr ? nullptr : &from->node.state;
    if (lister_->for_each_expected(state, add) || together_.is_over()) return;
    share_cases();
    together_.end();
}

/// Asked of the cases in their order, and of none twice.
bool Exploration::is_left_out(const SharedCase& item) {
    if (item.from == nullptr) return false;
    ahead_ = in_hand_ - item.from->number;
    if (!item.from->has_begun) item.from->is_covered = is_covered(item.from->node);
    item.from->has_begun = true;
    return item.from->is_covered;
}

void Exploration::share_cases() {
    const SharedSteps<SharedCase, SharedOutcome> steps{
        [this](const SharedCase& item) { return is_left_out(item); },
        [this](const SharedCase& item, std::size_t worker,
               const std::function<bool(SharedOutcome &&)>& hand_over) {
            const ProductState* state = item.from == nullptr ? nullptr : &item.from->node.state;
            return expanders_[worker]->compare(
                state, item.ending, item.expected, [&](ExpandedCase&& found) {
                    return hand_over({std::move(found.step), std::move(found.outcomes)});
                });
        },
        [this](const SharedCase& item, SharedOutcome& found) {
            take(item.node(), item.ending, item.expected, found.step, found.outcomes);
        }};
    together_.run(cases_, steps);
    if (!together_.is_over()) ahead_ = 0;
}

void Exploration::record_case(const ReferenceOutcome& expected, const PathStep& step) {
    if (!coverage_.record_case(expected, step.inputs, waiting())) together_.end();
}

/// Counts a case, and follows what the netlist does in it.
void Exploration::take(const Node* node, const RunningDelays::Ending& ending,
                       const ReferenceOutcome& expected, const PathStep& step,
                       NetlistOutcomes& outcomes) {
    if (!expected.stable) note_unstable(node, step, expected);
    record_case(expected, step);
    if (!outcomes.empty()) explored_.result.coverage.gate_states += outcomes.front().gate_states;
    const bool agrees = follow(node, ending, step, expected, outcomes);
    if (pulses_ != nullptr && node != nullptr && expected.stable && agrees) {
        look_for_pulses(node, step);
    }
}

void Exploration::look_for_pulses(const Node* node, const PathStep& step) {
    pulses_->look_at({node->state.reference, node->state.netlist, node->state.inputs, step},
                     [&](const PathStep& last) { return stimuli_of(node, last); });
}

/// Stimuli that end with the step, with several gaps between their instants.
std::vector<Stimuli> Exploration::stimuli_of(const Node* node, const PathStep& step) const {
    const std::vector<PathStep> path = path_of_instants(node, step);
    std::vector<Stimuli> all;
    for (const Time gap : gaps_for(path)) {
        if (auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap)) {
            all.push_back(std::move(*stimuli));
        }
    }
    return all;
}

/// Every outcome of a case: on to a successor, or to a witness. Whether all agree.
bool Exploration::follow(const Node* node, const RunningDelays::Ending& ending,
                         const PathStep& step, const ReferenceOutcome& expected,
                         NetlistOutcomes& outcomes) {
    bool agrees = true;
    for (NetlistOutcome& outcome : outcomes) {
        if (outcome.kind == NetlistOutcome::Kind::not_explored) {
            explored_.result.has_unexplored_orders = true;
            agrees = false;
            continue;
        }
        if (outcome.kind == NetlistOutcome::Kind::differs) {
            agrees = false;
            has_left_out_ = has_left_out_ || pulses_ != nullptr;
            if (pulses_ == nullptr && show_difference(node, step)) return false;
            continue;
        }
        if (outcome.unknown) explored_.result.has_uninitialised_memory = true;
        add_successor(node, ending, step, expected, std::move(outcome.state));
    }
    return agrees;
}

void Exploration::encode(ProductState& state) const {
    state.encoding.clear();
    relevance_.encode(state.encoding, state.reference);
    state.delays.encode(state.encoding);
    for (const PartialInput value : state.inputs) state.encoding += static_cast<char>(value);
    netlist_->encode(state.encoding, state.netlist);
}

void Exploration::add_successor(const Node* node, const RunningDelays::Ending& ending,
                                const PathStep& step, const ReferenceOutcome& expected,
                                SimulatorState&& netlist_state) {
    ProductState next{expected.state, std::move(netlist_state), step.inputs, {}, {}};
    const RunningDelays& before = node == nullptr ? RunningDelays(facts_) : node->state.delays;
    next.delays = before.after(facts_, ending.zone, next.reference.due, next.netlist.due,
                               predecessors_.next());
    encode(next);
    if (!visited_.add(next.encoding, next.delays.zone())) return;
    abstract_unread_inputs(next);
    if (next.inputs != step.inputs) {
        encode(next);
        if (!visited_.add(next.encoding, next.delays.zone())) return;
    }
    coverage_.record_situation(next.reference.situation);
    const std::uint32_t number = predecessors_.next();
    predecessors_.add(step_of(node), step);
    waiting_.push_back({std::move(next), number});
}

void Exploration::abstract_unread_inputs(ProductState& state) {
    std::vector<std::uint32_t> unread;
    // Without modes Init, AUdur and AUdoux are always 0.
    const std::size_t changing =
        netlist_->has_modes() ? state.inputs.size() : grafcet_.inputs.size();
    if (netlist_->is_clocked()) {
        // Between two scans the reference reads no input.
        for (std::uint32_t i = 0; i < changing; ++i) {
            if (state.inputs[i] != PartialInput::unassigned) unread.push_back(i);
        }
    } else {
        unread = reference_.unread_inputs(state.reference, state.inputs);
        std::erase_if(unread, [&](std::uint32_t input) { return input >= changing; });
    }
    if (unread.empty()) return;
    auto abstracted = netlist_->abstracted(state.netlist, unread);
    if (!abstracted) {
        // Together they matter to the netlist; some of them may not.
        std::vector<std::uint32_t> rest;
        for (const std::uint32_t input : unread) {
            rest.push_back(input);
            if (auto more = netlist_->abstracted(state.netlist, rest)) {
                abstracted = std::move(more);
            } else {
                rest.pop_back();
            }
        }
        unread = std::move(rest);
    }
    if (!abstracted) return;
    for (const std::uint32_t input : unread) state.inputs[input] = PartialInput::unassigned;
    state.netlist = std::move(*abstracted);
}

/// Turns a difference into the witness, which ends the exploration; false where no run with real
/// times shows it.
bool Exploration::show_difference(const Node* node, const PathStep& step) {
    if (netlist_->is_clocked() ? show_after_scans(predecessors_.path(step_of(node), step))
                               : show_after_instants(path_of_instants(node, step))) {
        together_.end();
        return true;
    }
    return false;
}

/// The path to a step of an asynchronous netlist, with no more changes at an instant than the plan
/// has.
std::vector<PathStep> Exploration::path_of_instants(const Node* node, const PathStep& step) const {
    std::vector<PathStep> path = predecessors_.path(step_of(node), step);
    if (!is_one_at_a_time()) return path;
    auto single = one_by_one(assumptions_, path, grafcet_.all_input_count());
    return single ? std::move(*single) : path;
}

bool Exploration::show_after_instants(const std::vector<PathStep>& path) {
    bool has_times = false;
    for (const Time gap : gaps_for(path)) {
        const auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap);
        if (!stimuli) continue;
        has_times = true;
        explored_.result.witness = netlist_->replay(*stimuli, 0);
        if (explored_.result.witness) return true;
    }
    if (!has_times && plan_.passing == Passing::free) {
        explored_.needs_lengths = true;
        together_.end();
    } else {
        explored_.result.is_unexplained = true;
    }
    return false;
}

bool Exploration::show_after_scans(const std::vector<PathStep>& path) {
    const auto scans = scans_for(grafcet_, assumptions_, path, plan_.period);
    if (scans) {
        explored_.result.witness = netlist_->replay(scans->stimuli, scans->period);
        if (explored_.result.witness) return true;
        explored_.result.is_unexplained = true;
    } else if (plan_.passing == Passing::free) {
        explored_.needs_lengths = true;
        together_.end();
    } else {
        no_period_shows_it_ = true;
    }
    return false;
}

void Exploration::note_unstable(const Node* node, const PathStep& step,
                                const ReferenceOutcome& expected) {
    if (explored_.result.first_unstable) return;
    auto stimuli = first_stimuli_for(grafcet_, assumptions_, path_of_instants(node, step));
    if (!stimuli) return;
    explored_.result.first_unstable = CheckResult::Unstable{std::move(*stimuli), expected.changing};
}

}  // namespace

ExplorationResult explore(const Grafcet& grafcet, const ExploredNetlistMaker& make_netlist,
                          const CheckOptions& options, const ExplorationPlan& plan,
                          PulseSearch* pulses) {
    return Exploration(grafcet, make_netlist, options, plan, pulses).run();
}

}  // namespace grafwire
