// Equivalence by exploration, breadth first, of the pairs (reference, netlist).
//
// A node is a stable state of the reference together with the settled state of the netlist that
// came with it. Leaving it, a case changes any inputs at once (control inputs included) and lets
// any running delays of time conditions end; delays count as free: they can end whenever their
// operand has stayed as it is since, whatever their length. The netlist settles from its own state,
// so that what it remembers beyond the X is explored too. If situation and outputs agree, the pair
// reached is a new node unless it has been seen. If they do not, the way there is turned into
// stimuli with real moments and replayed from power-up; only a difference that shows there is
// reported. A difference that would need delays to end in an order their lengths do not allow is
// counted, its state is not explored further, and the verdict is then not "equivalent" either.
//
// An input that nobody reads in the state reached is forgotten there: it is left open, as it could
// be changed now without any effect. So states that differ only in such inputs are one node. Nobody
// reads it if a further scan of the reference does not consult it, and if the netlist, with the
// input unknown, keeps the value of everything it remembers. Where the way to a difference needs
// the other value after all, the change without effect is put in as an instant of its own.
//
// Breadth first, because the shortest way to a difference is the easiest to read. All nodes are
// compared by their whole state, never by a digest: a collision would be a wrong verdict.
//
// Which inputs are varied, and why that is enough: see reference_case.cpp.

#include "check/check_equivalence.h"

#include <algorithm>
#include <deque>
#include <string>
#include <unordered_set>

#include "check/netlist_case.h"
#include "check/reference_case.h"
#include "evolution/evolution.h"

namespace grafwire {

namespace {

constexpr std::uint32_t no_parent = 0xffffffffU;

struct Node {
    EvolutionState reference;
    SimulatorState netlist;
    PartialInputs inputs;
    std::uint32_t path = no_parent;
};

struct PathNode {
    std::uint32_t parent = no_parent;
    PathStep step;
};

void append_words(std::string& key, const BitTable& bits) {
    const auto& words = bits.words();
    key.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0]));
}

void append_logic(std::string& key, const std::vector<Logic>& values) {
    for (std::size_t i = 0; i < values.size(); i += 4) {
        unsigned packed = 0;
        for (std::size_t j = i; j < std::min(i + 4, values.size()); ++j) {
            packed = packed * 4 + static_cast<unsigned>(values[j]);
        }
        key += static_cast<char>(packed);
    }
}

/// Everything that decides how a node goes on; moments do not, because delays are free.
std::string key_of(const Node& node) {
    std::string key;
    const EvolutionState& state = node.reference;
    for (const BitTable* bits : {&state.situation, &state.may_evolve, &state.stored_outputs,
                                 &state.vars, &state.edge_memory, &state.time_values}) {
        append_words(key, *bits);
    }
    key.append(reinterpret_cast<const char*>(state.counters.data()),
               state.counters.size() * sizeof(std::int64_t));
    for (const Time due : state.due) key += due == never ? '.' : '!';
    for (const Time due : node.netlist.due) key += due == never ? '.' : '!';
    append_logic(key, node.inputs);
    append_logic(key, node.netlist.values);
    return key;
}

class Exploration {
  public:
    Exploration(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                const CheckOptions& options)
        : grafcet_(grafcet),
          netlist_(netlist),
          delays_(delays),
          options_(options),
          evolution_(grafcet),
          reference_(evolution_, netlist.is_clocked()),
          gates_(grafcet, netlist, delays),
          assumptions_(grafcet) {}

    CheckResult run() {
        explore_instant(nullptr, {});
        while (!done_ && !waiting_.empty()) {
            const Node node = std::move(waiting_.front());
            waiting_.pop_front();
            leave(node);
        }
        result_.complete = waiting_.empty() && !done_;
        if (result_.witness) {
            result_.verdict = Verdict::different;
        } else if (result_.complete && result_.impossible_timings == 0) {
            result_.verdict = Verdict::equivalent;
        }
        result_.coverage.waiting = waiting_.size();
        return std::move(result_);
    }

  private:
    void leave(const Node& node);
    void explore_instant(const Node* node, const std::vector<std::uint32_t>& ended);
    void compare(const Node* node, const std::vector<std::uint32_t>& ended,
                 const ReferenceOutcome& expected);
    void arrive(const Node* node, const PathStep& step, const ReferenceOutcome& expected,
                SimulatorState&& netlist_state);
    void forget_unread_inputs(Node& node);
    void found_difference(const Node* node, const PathStep& step);
    void note_unstable(const Node* node, const PathStep& step, const ReferenceOutcome& expected);
    void count_case(bool stable);
    std::vector<PathStep> path_to(const Node* node, const PathStep& last) const;
    PartialInputs all_open() const;

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& delays_;
    const CheckOptions& options_;
    Evolution evolution_;
    ReferenceCases reference_;
    NetlistCases gates_;
    Assumptions assumptions_;
    std::deque<Node> waiting_;
    std::unordered_set<std::string> seen_;
    std::unordered_set<std::string> situations_;
    std::vector<PathNode> paths_;
    CheckResult result_;
    bool done_ = false;
};

PartialInputs Exploration::all_open() const {
    PartialInputs inputs(grafcet_.all_input_count(), Logic::unknown);
    if (!netlist_.has_modes) {
        for (std::size_t i = grafcet_.inputs.size(); i < inputs.size(); ++i) {
            inputs[i] = Logic::zero;
        }
    }
    return inputs;
}

/// Every set of running delays may end at the next instant, the empty set included.
void Exploration::leave(const Node& node) {
    std::vector<std::uint32_t> running;
    for (std::uint32_t i = 0; i < node.reference.due.size(); ++i) {
        if (Evolution::is_running(node.reference, i)) running.push_back(i);
    }
    std::vector<std::uint32_t> ended;
    // The subsets in the order of a binary counter, held as the list of its ones.
    std::vector<bool> chosen(running.size());
    for (;;) {
        ended.clear();
        for (std::size_t i = 0; i < running.size(); ++i) {
            if (chosen[i]) ended.push_back(running[i]);
        }
        explore_instant(&node, ended);
        std::size_t bit = 0;
        while (bit < chosen.size() && chosen[bit]) chosen[bit++] = false;
        if (done_ || bit == chosen.size()) return;
        chosen[bit] = true;
    }
}

/// All cases of one instant: see reference_case.cpp for how the inputs are split.
void Exploration::explore_instant(const Node* node, const std::vector<std::uint32_t>& ended) {
    std::vector<PartialInputs> remaining{all_open()};
    while (!remaining.empty() && !done_) {
        const PartialInputs inputs = std::move(remaining.back());
        remaining.pop_back();
        if (!assumptions_.can_hold(inputs)) continue;
        const ReferenceOutcome outcome =
            reference_.run(node == nullptr ? nullptr : &node->reference, ended, inputs);
        PartialInputs other = inputs;
        for (const std::uint32_t input : outcome.closed) {
            other[input] = Logic::one;
            remaining.push_back(other);
            other[input] = Logic::zero;
        }
        if (assumptions_.can_hold(outcome.inputs)) compare(node, ended, outcome);
    }
}

void Exploration::count_case(bool stable) {
    Coverage& coverage = result_.coverage;
    ++coverage.cases;
    if (!stable) ++coverage.unstable;
    coverage.waiting = waiting_.size();
    if (options_.max_cases != 0 && coverage.cases >= options_.max_cases) done_ = true;
    if (coverage.cases % 256 == 0 && options_.keep_going && !options_.keep_going(coverage)) {
        done_ = true;
    }
}

/// Compares the netlist in a case of the reference, closing the open inputs it turns out to react
/// to.
void Exploration::compare(const Node* node, const std::vector<std::uint32_t>& ended,
                          const ReferenceOutcome& expected) {
    const PartialInputs& left = node == nullptr ? expected.inputs : node->inputs;
    std::vector<PathStep> remaining{{left, expected.inputs, ended}};
    while (!remaining.empty() && !done_) {
        PathStep step = std::move(remaining.back());
        remaining.pop_back();
        if (node == nullptr) step.before = step.inputs;
        if (!assumptions_.can_hold(step.inputs) || !assumptions_.can_hold(step.before)) continue;
        if (!expected.stable) {
            note_unstable(node, step, expected);
            if (!netlist_.is_clocked()) {
                count_case(false);
                continue;
            }
        }
        NetlistOutcome outcome =
            gates_.run(node == nullptr ? nullptr : &node->netlist, left, step, expected);
        if (outcome.kind == NetlistOutcome::Kind::open) {
            PartialInputs& split = outcome.split_before ? step.before : step.inputs;
            for (const Logic value : {Logic::one, Logic::zero}) {
                split[outcome.split] = value;
                remaining.push_back(step);
            }
            continue;
        }
        count_case(expected.stable);
        if (outcome.kind == NetlistOutcome::Kind::differs) {
            found_difference(node, step);
        } else if (expected.stable) {
            arrive(node, step, expected, std::move(outcome.state));
        }
    }
}

void Exploration::arrive(const Node* node, const PathStep& step, const ReferenceOutcome& expected,
                         SimulatorState&& netlist_state) {
    Node next{expected.state, std::move(netlist_state), step.inputs, 0};
    if (!seen_.insert(key_of(next)).second) return;
    forget_unread_inputs(next);
    if (next.inputs != step.inputs && !seen_.insert(key_of(next)).second) return;
    std::string situation;
    append_words(situation, next.reference.situation);
    if (situations_.insert(std::move(situation)).second) ++result_.coverage.situations;
    paths_.push_back({node == nullptr ? no_parent : node->path, step});
    next.path = static_cast<std::uint32_t>(paths_.size() - 1);
    waiting_.push_back(std::move(next));
}

void Exploration::forget_unread_inputs(Node& node) {
    std::vector<std::uint32_t> unread = reference_.unread_inputs(node.reference, node.inputs);
    if (unread.empty()) return;
    auto forgotten = gates_.forget(node.netlist, unread);
    if (!forgotten) {
        // Together they matter to the netlist; some of them may not.
        std::vector<std::uint32_t> rest;
        for (const std::uint32_t input : unread) {
            rest.push_back(input);
            if (auto more = gates_.forget(node.netlist, rest)) {
                forgotten = std::move(more);
            } else {
                rest.pop_back();
            }
        }
        unread = std::move(rest);
    }
    if (!forgotten) return;
    for (const std::uint32_t input : unread) node.inputs[input] = Logic::unknown;
    node.netlist = std::move(*forgotten);
}

/// The first inputs where they say something, else the second.
PartialInputs merged(PartialInputs first, const PartialInputs& second) {
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] == Logic::unknown) first[i] = second[i];
    }
    return first;
}

std::vector<PathStep> Exploration::path_to(const Node* node, const PathStep& last) const {
    std::vector<PathStep> path{last};
    for (std::uint32_t at = node == nullptr ? no_parent : node->path; at != no_parent;
         at = paths_[at].parent) {
        // What a later step closes in the state it leaves was open there; so it is closed in the
        // step that led there, or changes without effect in between.
        PathStep step = paths_[at].step;
        const PartialInputs wanted = merged(path.back().before, step.inputs);
        const PartialInputs reached = merged(step.inputs, path.back().before);
        if (wanted != reached) path.push_back({reached, wanted, {}});
        step.inputs = reached;
        if (paths_[at].parent == no_parent) step.before = step.inputs;
        path.push_back(std::move(step));
    }
    std::reverse(path.begin(), path.end());
    return path;
}

void Exploration::found_difference(const Node* node, const PathStep& step) {
    const std::vector<PathStep> path = path_to(node, step);
    for (const Time gap : {100 * millisecond, millisecond, 10 * microsecond, microsecond}) {
        const auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap);
        if (!stimuli) continue;
        result_.witness = replay(grafcet_, netlist_, delays_, *stimuli);
        if (result_.witness) {
            done_ = true;
            return;
        }
    }
    ++result_.impossible_timings;
}

void Exploration::note_unstable(const Node* node, const PathStep& step,
                                const ReferenceOutcome& expected) {
    if (result_.first_unstable) return;
    const std::vector<PathStep> path = path_to(node, step);
    for (const Time gap : {100 * millisecond, millisecond, 10 * microsecond, microsecond}) {
        if (auto stimuli = stimuli_for(grafcet_, assumptions_, path, gap)) {
            result_.first_unstable = CheckResult::Unstable{std::move(*stimuli), expected.changing};
            return;
        }
    }
}

}  // namespace

CheckResult check_equivalence(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const CheckOptions& options) {
    return Exploration(grafcet, netlist, delays, options).run();
}

}  // namespace grafwire
