// Equivalence scan by scan, by exploration, breadth first, of the pairs (reference, device).
//
// Reference and device are executed with one period, and a node is what both remember after a scan.
// A case is the next scan under some inputs; if X and outputs agree after it, the pair reached is a
// new node unless it has been seen. Time is real here, not free as in check_equivalence.cpp: what
// remains of a running delay is part of the node, as a time; a device knows no instants between
// its scans at which a delay could end, so with a period there are finitely many. That makes more
// nodes, but every way through them is a run that `run --scan` repeats.
//
// Which inputs are varied: those that the reference looks at, as in reference_case.cpp, and those
// that the device says it needs. All others are left open. Nothing is remembered of an open input
// on either side, so a node holds no inputs: each scan is given its own.

#include "check/scan_check.h"

#include <algorithm>
#include <cassert>
#include <deque>
#include <unordered_set>

#include "check/path.h"
#include "check/reference_case.h"
#include "check/relevance.h"

namespace grafwire {

namespace {

constexpr std::uint32_t no_parent = 0xffffffffU;

/// What both sides remember after a scan.
struct Node {
    EvolutionState reference;
    std::string memory;
    Time now = 0;  ///< the moment of that scan
    std::uint32_t scan = no_parent;
};

std::string key_of(const Node& node, const Relevance& relevance, const ScannedDevice& device) {
    std::string key;
    relevance.append_key(key, node.reference);
    for (std::size_t i = 0; i < node.reference.due.size(); ++i) {
        if (relevance.time_conditions()[i] == 0) continue;
        const Time due = node.reference.due[i];
        const Time remaining = due == never ? never : due - node.now;
        key.append(reinterpret_cast<const char*>(&remaining), sizeof(remaining));
    }
    return key + device.key(node.memory, node.now);
}

class ScanExploration {
  public:
    ScanExploration(const Grafcet& grafcet, const ScannedDevice& device, Time period,
                    const CheckOptions& options)
        : grafcet_(grafcet),
          device_(device),
          period_(period),
          evolution_(grafcet),
          reference_(evolution_, {}),
          relevance_(grafcet),
          assumptions_(grafcet),
          exercised_(grafcet, assumptions_, device.has_modes()),
          counter_(options, result_.coverage) {}

    CheckResult run() {
        explore_scan(nullptr);
        while (!done_ && !waiting_.empty()) {
            const Node node = std::move(waiting_.front());
            waiting_.pop_front();
            explore_scan(&node);
        }
        result_.never = exercised_.never();
        conclude(result_, waiting_.empty() && !done_, waiting_.size());
        return std::move(result_);
    }

  private:
    /// A scan on the way to a node, and the one before.
    struct Scan {
        std::uint32_t before;
        PartialInputs inputs;
    };

    void explore_scan(const Node* node);
    void compare(const Node* node, const ReferenceOutcome& expected);
    void arrive(Node&& next, std::uint32_t before, const PartialInputs& inputs);
    void found_difference(std::uint32_t before, const PartialInputs& inputs);
    Stimuli stimuli_of(std::vector<PartialInputs> scans) const;
    bool agree(const ReferenceOutcome& expected, const ScannedDevice::Outcome& got) const;

    const Grafcet& grafcet_;
    const ScannedDevice& device_;
    Time period_;
    Evolution evolution_;
    ReferenceCases reference_;
    Relevance relevance_;
    Assumptions assumptions_;
    Exercised exercised_;
    std::deque<Node> waiting_;
    std::unordered_set<std::string> seen_;
    std::vector<Scan> scans_;
    CheckResult result_;
    CaseCounter counter_;
    bool done_ = false;
};

/// All cases of the scan after a node, or of the first.
void ScanExploration::explore_scan(const Node* node) {
    const EvolutionState* start = node == nullptr ? nullptr : &node->reference;
    const Time now = node == nullptr ? 0 : node->now + period_;
    for_each_case(
        assumptions_, open_inputs(grafcet_, device_.has_modes()),
        [&](const PartialInputs& inputs) { return reference_.scan(start, inputs, now); },
        [&](const ReferenceOutcome& expected) {
            compare(node, expected);
            return !done_;
        });
}

/// Compares the device in a case of the reference, closing the open inputs it turns out to need.
void ScanExploration::compare(const Node* node, const ReferenceOutcome& expected) {
    const std::string memory = node == nullptr ? device_.start() : node->memory;
    const Time now = node == nullptr ? 0 : node->now + period_;
    const std::uint32_t before = node == nullptr ? no_parent : node->scan;
    std::vector<PartialInputs> remaining{expected.inputs};
    while (!remaining.empty() && !done_) {
        PartialInputs inputs = std::move(remaining.back());
        remaining.pop_back();
        if (!assumptions_.can_hold(inputs)) continue;
        ScannedDevice::Outcome got = device_.scan(memory, inputs, now);
        if (got.needs) {
            assert(inputs[*got.needs] == Logic::unknown);
            for (const Logic value : {Logic::one, Logic::zero}) {
                inputs[*got.needs] = value;
                remaining.push_back(inputs);
            }
            continue;
        }
        if (!counter_.count(true, waiting_.size())) done_ = true;
        exercised_.note(expected, inputs);
        if (agree(expected, got)) {
            arrive({expected.state, std::move(got.memory), now}, before, inputs);
        } else {
            found_difference(before, inputs);
        }
    }
}

bool ScanExploration::agree(const ReferenceOutcome& expected,
                            const ScannedDevice::Outcome& got) const {
    const auto same = [](const BitTable& bits, const std::vector<Logic>& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (values[i] != logic_of(bits.test(i))) return false;
        }
        return true;
    };
    assert(got.steps.size() == grafcet_.steps.size());
    assert(got.outputs.size() == grafcet_.outputs.size());
    return same(expected.state.situation, got.steps) && same(expected.outputs, got.outputs);
}

void ScanExploration::arrive(Node&& next, std::uint32_t before, const PartialInputs& inputs) {
    if (!seen_.insert(key_of(next, relevance_, device_)).second) return;
    counter_.note(next.reference.situation);
    next.scan = static_cast<std::uint32_t>(scans_.size());
    scans_.push_back({before, inputs});
    waiting_.push_back(std::move(next));
}

/// Stimuli with a line for every scan in which inputs change, and one for the first.
Stimuli ScanExploration::stimuli_of(std::vector<PartialInputs> scans) const {
    Stimuli stimuli;
    InputValues previous(grafcet_.all_input_count(), 0);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        stimuli.end = static_cast<Time>(i) * period_;
        const InputValues values = *assumptions_.complete(scans[i], previous);
        Stimuli::Change change{stimuli.end, differences(previous, values), {}};
        previous = values;
        if (i == 0 || !change.assignments.empty()) stimuli.changes.push_back(std::move(change));
    }
    return stimuli;
}

/// Ends the exploration with the witness. A device whose outcome depends on something that it does
/// not tell may fail to show the difference again; then the exploration ends without a verdict.
void ScanExploration::found_difference(std::uint32_t before, const PartialInputs& inputs) {
    std::vector<PartialInputs> path{inputs};
    for (std::uint32_t at = before; at != no_parent; at = scans_[at].before) {
        path.push_back(scans_[at].inputs);
    }
    std::reverse(path.begin(), path.end());
    result_.witness = replay_scans(grafcet_, device_, stimuli_of(std::move(path)), period_);
    done_ = true;
}

}  // namespace

CheckResult check_scans(const Grafcet& grafcet, const ScannedDevice& device, Time period,
                        const CheckOptions& options) {
    assert(period > 0);
    return ScanExploration(grafcet, device, period, options).run();
}

}  // namespace grafwire
