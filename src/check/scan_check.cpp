// Equivalence scan by scan, by exploration, breadth first, of the product of reference and device.
//
// Reference and device are executed with one period, and a node is what both remember after a scan.
// A case is the next scan under some inputs; if X and outputs agree after it, the state reached is
// a new node unless it has been visited. Time is real here, not free as in exploration.cpp: what
// remains of a running delay is part of the node, as a time; a device knows no instants between its
// scans at which a delay could end, so with a period there are finitely many. That makes more
// nodes, but every path through them is a run that `run --scan` repeats.
//
// Which inputs are varied: those that the reference looks at, as in reference_case.cpp, and those
// that the device says it needs. All others stay unassigned. Nothing is remembered of an unassigned
// input on either side, so a node holds no inputs: each scan is given its own.

#include "check/scan_check.h"

#include <algorithm>
#include <cassert>
#include <deque>
#include <numeric>
#include <unordered_set>

#include "check/coverage.h"
#include "check/path.h"
#include "check/reference_case.h"
#include "check/state_encoding.h"
#include "evolution/run.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

using Outcome = ScannedDevice::Outcome;

constexpr std::uint32_t root = 0xffffffffU;  ///< before the first scan

/// A state of the product: what both sides remember after a scan.
struct ScanState {
    EvolutionState reference;
    std::string memory;
    Time now = 0;  ///< the time of that scan
    std::uint32_t scan = root;
};

std::string encoding_of(const ScanState& node, const Relevance& relevance,
                        const ScannedDevice& device) {
    std::string encoding;
    relevance.encode(encoding, node.reference);
    for (std::size_t i = 0; i < node.reference.due.size(); ++i) {
        if (relevance.time_conditions()[i] == 0) continue;
        const Time due = node.reference.due[i];
        const Time remaining = due == never ? never : due - node.now;
        encoding.append(reinterpret_cast<const char*>(&remaining), sizeof(remaining));
    }
    return encoding + device.key(node.memory, node.now);
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
          coverage_(grafcet, assumptions_, device.has_modes(), options, result_.coverage) {}

    CheckResult run() {
        expand(nullptr);
        while (!done_ && !waiting_.empty()) {
            const ScanState node = std::move(waiting_.front());
            waiting_.pop_front();
            expand(&node);
        }
        result_.never = coverage_.never_exercised();
        conclude(result_, waiting_.empty() && !done_, waiting_.size());
        return std::move(result_);
    }

  private:
    /// A scan that led to a node, and its predecessor.
    struct Scan {
        std::uint32_t predecessor;
        PartialInputs inputs;
    };

    void expand(const ScanState* node);
    void compare(const ScanState* node, const ReferenceOutcome& expected);
    void add_successor(ScanState&& next, std::uint32_t predecessor, const PartialInputs& inputs);
    void show_difference(std::uint32_t predecessor, const PartialInputs& inputs);
    Stimuli stimuli_of(std::vector<PartialInputs> scans) const;
    bool agree(const ReferenceOutcome& expected, const Outcome& got) const;

    const Grafcet& grafcet_;
    const ScannedDevice& device_;
    Time period_;
    Evolution evolution_;
    ReferenceCases reference_;
    Relevance relevance_;
    Assumptions assumptions_;
    std::deque<ScanState> waiting_;
    std::unordered_set<std::string> visited_;
    std::vector<Scan> scans_;
    CheckResult result_;
    CoverageRecorder coverage_;
    bool done_ = false;
};

/// All cases of the scan after a node, or of the first.
void ScanExploration::expand(const ScanState* node) {
    const EvolutionState* start = node == nullptr ? nullptr : &node->reference;
    const Time now = node == nullptr ? 0 : node->now + period_;
    for_each_case(
        assumptions_, unassigned_inputs(grafcet_, device_.has_modes()),
        [&](const PartialInputs& inputs) { return reference_.scan(start, inputs, now); },
        [&](const ReferenceOutcome& expected) {
            compare(node, expected);
            return !done_;
        });
}

/// Compares the device in a case of the reference, split by the unassigned inputs that the device
/// turns out to need.
void ScanExploration::compare(const ScanState* node, const ReferenceOutcome& expected) {
    const std::string memory = node == nullptr ? device_.start() : node->memory;
    const Time now = node == nullptr ? 0 : node->now + period_;
    const std::uint32_t predecessor = node == nullptr ? root : node->scan;
    std::vector<PartialInputs> remaining{expected.inputs};
    while (!remaining.empty() && !done_) {
        PartialInputs inputs = std::move(remaining.back());
        remaining.pop_back();
        if (!assumptions_.can_hold(inputs)) continue;
        Outcome got = device_.scan(memory, inputs, now);
        if (got.needs) {
            assert(inputs[*got.needs] == PartialInput::unassigned);
            for (const PartialInput value : {PartialInput::one, PartialInput::zero}) {
                inputs[*got.needs] = value;
                remaining.push_back(inputs);
            }
            continue;
        }
        if (!coverage_.record_case(expected, inputs, waiting_.size())) done_ = true;
        if (agree(expected, got)) {
            add_successor({expected.state, std::move(got.memory), now}, predecessor, inputs);
        } else {
            show_difference(predecessor, inputs);
        }
    }
}

bool ScanExploration::agree(const ReferenceOutcome& expected, const Outcome& got) const {
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

void ScanExploration::add_successor(ScanState&& next, std::uint32_t predecessor,
                                    const PartialInputs& inputs) {
    if (!visited_.insert(encoding_of(next, relevance_, device_)).second) return;
    coverage_.record_situation(next.reference.situation);
    next.scan = static_cast<std::uint32_t>(scans_.size());
    scans_.push_back({predecessor, inputs});
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
void ScanExploration::show_difference(std::uint32_t predecessor, const PartialInputs& inputs) {
    std::vector<PartialInputs> path{inputs};
    for (std::uint32_t at = predecessor; at != root; at = scans_[at].predecessor) {
        path.push_back(scans_[at].inputs);
    }
    std::reverse(path.begin(), path.end());
    result_.witness = replay_scans(grafcet_, device_, stimuli_of(std::move(path)), period_);
    done_ = true;
}

/// A device over stimuli, a scan every period from 0 to the end: `visit` gets the time, the inputs
/// and the outcome of each.
template <class Visit>
void run_scan_by_scan(const Grafcet& grafcet, const ScannedDevice& device, const Stimuli& stimuli,
                      Time period, const Visit& visit) {
    StimuliPlayer player(stimuli, grafcet.all_input_count());
    std::string memory = device.start();
    for (Time now = 0;; now += period) {
        player.advance(now);
        const PartialInputs inputs = assigned_inputs(player.inputs());
        const Outcome outcome = device.scan(memory, inputs, now);
        visit(now, inputs, outcome);
        memory = outcome.memory;
        if (period > stimuli.end - now) return;
    }
}

std::int64_t shown(Logic value) {
    if (value == Logic::unknown) return Trace::unknown;
    return value == Logic::one ? 1 : 0;
}

void add_row(Trace& trace, Time now, const PartialInputs& inputs, const Outcome& outcome) {
    trace.times.push_back(now);
    for (const PartialInput input : inputs) trace.values.push_back(shown(logic_of(input)));
    for (const std::vector<Logic>* values : {&outcome.steps, &outcome.outputs}) {
        for (const Logic value : *values) trace.values.push_back(shown(value));
    }
    trace.values.resize(trace.times.size() * trace.columns.size(), Trace::unknown);
}

}  // namespace

CheckResult check_scans(const Grafcet& grafcet, const ScannedDevice& device, Time period,
                        const CheckOptions& options) {
    assert(period > 0);
    return ScanExploration(grafcet, device, period, options).run();
}

Time natural_period(const Grafcet& grafcet, const ScannedDevice& device) {
    Time divisor = 0;
    for (const Time delay : device.delays()) divisor = std::gcd(divisor, delay);
    const auto conditions = grafcet.expressions.time_conditions();
    for (const ExprId id : conditions) {
        const TimeCondition& condition = grafcet.expressions.time_condition_of(id);
        divisor = std::gcd(divisor, std::gcd(condition.on_delay, condition.off_delay));
    }
    if (divisor == 0) return 10 * millisecond;
    return conditions.size() > 1 && divisor > 1 ? divisor / 2 : divisor;
}

Trace run_device(const Grafcet& grafcet, const ScannedDevice& device, const Stimuli& stimuli,
                 Time period) {
    Trace trace = empty_trace(grafcet);
    run_scan_by_scan(grafcet, device, stimuli, period,
                     [&](Time now, const PartialInputs& inputs, const Outcome& outcome) {
                         add_row(trace, now, inputs, outcome);
                     });
    return trace;
}

Outcome last_scan(const Grafcet& grafcet, const ScannedDevice& device, const Witness& witness) {
    Outcome last;
    run_scan_by_scan(grafcet, device, witness.stimuli, witness.scan_period,
                     [&](Time, const PartialInputs&, const Outcome& outcome) { last = outcome; });
    return last;
}

std::optional<Witness> replay_scans(const Grafcet& grafcet, const ScannedDevice& device,
                                    const Stimuli& stimuli, Time period) {
    auto witness = first_difference(grafcet, stimuli, run_scans(grafcet, stimuli, period),
                                    run_device(grafcet, device, stimuli, period));
    if (witness) witness->scan_period = period;
    return witness;
}

}  // namespace grafwire
