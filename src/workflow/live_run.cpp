// The reference leads: the gates are given each of its instants, with the inputs that it has there.
// Between them they have instants of their own, at which a delay of theirs ends; in right wiring
// these are those of the reference.

#include "workflow/live_run.h"

#include <algorithm>
#include <utility>

#include "evolution/run.h"
#include "trace/input_values.h"
#include "workflow/runs.h"

namespace grafwire {

namespace {

/// What one instant tells of; gates that do not settle could go on for long.
constexpr std::size_t most_changes = 100'000;

}  // namespace

LiveRun::LiveRun(Chart chart, std::optional<WiredChart> wiring, std::optional<Time> period)
    : chart_(std::move(chart)), wiring_(std::move(wiring)), reference_(chart_.grafcet, period) {
    if (!wiring_) return;
    const Netlist& netlist = wiring_->netlist;
    machine_.emplace(chart_.grafcet, netlist, cell_delays(netlist, wiring_->delays));
    machine_->simulator().observe([this](Time at, NetId net, Logic value) {
        if (recorded_ == nullptr || recorded_->changes.size() == most_changes) return;
        recorded_->changes.push_back({at - began_, net, value});
    });
}

Logic LiveRun::value(NetId net) const {
    return machine_ && has_started_ ? machine_->simulator().value(net) : Logic::unknown;
}

/// Only once, so that going back to the beginning and on does not tell it again.
void LiveRun::start_gates() {
    has_started_ = true;
    power_up_ = {};
    recorded_ = &power_up_;
    began_ = 0;
    const Settling settling = machine_->start(known_inputs(inputs_));
    power_up_.is_settled = settling.settled;
    power_up_.oscillating = settling.oscillating;
    is_settled_ = settling.settled;
    oscillating_ = settling.oscillating;
    recorded_ = nullptr;
}

std::optional<GateInstant> LiveRun::gates_at(Time at) {
    if (!machine_) return std::nullopt;
    if (!has_started_) start_gates();
    if (!is_settled_) return std::nullopt;
    GateInstant instant;
    instant.at = at;
    recorded_ = &instant;
    began_ = std::max(at, machine_->simulator().now());
    const auto inputs = known_inputs(inputs_);
    const bool is_scan = reference_.period() && wiring_->netlist.is_clocked();
    const Settling settling = is_scan ? machine_->scan(at, inputs) : machine_->instant(at, inputs);
    recorded_ = nullptr;
    is_settled_ = settling.settled;
    oscillating_ = settling.oscillating;
    instant.is_settled = settling.settled;
    instant.oscillating = settling.oscillating;
    return instant;
}

/// Delays of the gates that end before the next instant of the reference.
void LiveRun::gates_until(Time end, std::vector<LiveInstant>& instants) {
    if (!machine_ || !has_started_ || (reference_.period() && wiring_->netlist.is_clocked())) {
        return;
    }
    while (is_settled_ && machine_->simulator().next_due() < end) {
        auto gates = gates_at(machine_->simulator().next_due());
        instants.push_back({std::nullopt, std::move(gates)});
    }
}

void LiveRun::add(InstantStory story, std::vector<LiveInstant>& instants) {
    gates_until(story.at, instants);
    inputs_ = reference_.run().inputs;
    auto gates = gates_at(story.at);
    if (story.is_quiet && (!gates || gates->changes.empty())) return;
    instants.push_back({std::move(story), std::move(gates)});
}

LiveRun::Way LiveRun::advance(Time to, const std::vector<Stimuli::Assignment>& assignments,
                              bool has_instant) {
    GateMoment before;
    if (machine_ && has_started_ && is_settled_) before.state = machine_->simulator().save();
    before.is_settled = is_settled_;
    before.oscillating = oscillating_;
    past_.push_back(std::move(before));
    Way way;
    way.is_done = reference_.advance(to, assignments, has_instant, [&](InstantStory story) {
        add(std::move(story), way.instants);
    });
    if (way.is_done) gates_until(add_times(to, 1), way.instants);
    return way;
}

void LiveRun::go_back() {
    reference_.go_back();
    GateMoment before = std::move(past_.back());
    past_.pop_back();
    if (!machine_) return;
    is_settled_ = before.is_settled;
    oscillating_ = std::move(before.oscillating);
    has_started_ = reference_.has_begun();
    inputs_ = reference_.run().inputs;
    if (before.state) machine_->simulator().restore(*before.state);
}

std::vector<std::string> LiveRun::differences() const {
    std::vector<std::string> names;
    if (!machine_ || !has_started_ || !reference_.last()) return names;
    const Grafcet& grafcet = chart_.grafcet;
    const auto compare = [&](NetId net, bool expected, std::string name) {
        if (net != no_net && value(net) != logic_of(expected)) names.push_back(std::move(name));
    };
    const InstantStory& last = *reference_.last();
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        compare(machine_->ports().steps[i], last.situation.test(i),
                "X" + grafcet.steps[grafcet.steps.id_at(i)].name);
    }
    for (std::size_t i = 0; i < grafcet.outputs.size(); ++i) {
        compare(machine_->ports().outputs[i], last.outputs.test(i),
                grafcet.outputs[grafcet.outputs.id_at(i)].name);
    }
    return names;
}

ToldRun LiveRun::whole() const {
    return tell_reference(chart_, reference_.stimuli(), reference_.period());
}

}  // namespace grafwire
