// A netlist whose gates take times that are not known, in one case after the other.
//
// The simulator, with nominal delays, does what does not depend on delays: power-up (Init works its
// way through three values, of which none ever changes back), and unassigned inputs that are known
// to matter to no memory. Between the change of the inputs and rest the delay model takes over: it
// gives every state of rest that can come about, each of which is compared, and followed where it
// agrees.
//
// That a model never misses a rest is what a verdict "equivalent" stands on. Where it has to give
// up (too many orders), the case is left open, and so is the verdict.

#include "check/racing_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/race_search.h"
#include "check/racing_witness.h"

namespace grafwire {

namespace {

constexpr std::size_t states_before_split = 50;

/// All orders of firings are gone through for so many differences that no delays show.
constexpr std::size_t most_thorough_searches = 16;

}  // namespace

RacingCases::RacingCases(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& nominal,
                         const DelayModel& model, const KeepGoing& keep_going,
                         std::size_t most_states)
    : NetlistCases(grafcet, netlist, nominal, keep_going),
      delay_model_(model),
      most_states_(most_states),
      keep_going_(keep_going),
      circuit_(netlist, relevant_nets()),
      model_(make_settling_model(model, circuit_, keep_going)) {}

NetlistOutcomes RacingCases::run(const SimulatorState* start, const PartialInputs& left,
                                 const PathStep& step, const ReferenceOutcome& expected) {
    NetlistOutcomes outcomes;
    std::vector<Logic> values_left;
    const Settling settling = begin(start, left, step, &values_left);
    if (!settling.settled) {
        outcomes.push_back(not_settled(settling, step));
        return outcomes;
    }
    if (start == nullptr && starts_by_init() && settling.events != 0) {
        // Memories held at their initial values have moved once they were let go: where to may
        // depend on delays, and only the nominal ones were tried.
        outcomes.emplace_back().kind = NetlistOutcome::Kind::not_explored;
        return outcomes;
    }
    const SimulatorState before = simulator().save();
    const CircuitState from = circuit_state(circuit_, values_left, before, instant());
    // Unassigned inputs can make much of little: if the case is not soon done, it is split first.
    Rests rests = model_->settle(from, false, states_before_split);
    std::uint64_t gate_states = rests.states;
    if (rests.is_too_large) {
        NetlistOutcome open = undetermined(remembered_nets(), step);
        if (open.kind == NetlistOutcome::Kind::unassigned) {
            outcomes.push_back(std::move(open));
            return outcomes;
        }
        rests = model_->settle(from, false, std::min(model_->most_states(), most_states_));
        gate_states += rests.states;
    }
    if (rests.broken_off || rests.is_too_large) {
        NetlistOutcome open;
        open.kind = rests.broken_off ? NetlistOutcome::Kind::broken_off
                                     : NetlistOutcome::Kind::not_explored;
        outcomes.push_back(open);
    }
    for (const Rest& rest : rests.rests) {
        outcomes.push_back(outcome_of(rest, before, step, expected));
    }
    outcomes.front().gate_states = gate_states;
    return outcomes;
}

/// Whether Init alone brings about the state in which the first instant begins.
bool RacingCases::starts_by_init() const {
    const auto init = grafcet().inputs.size() + static_cast<std::size_t>(ControlInput::init);
    return netlist().has_modes && ports().inputs[init] != no_net;
}

/// What is remembered and not known at rest.
std::vector<NetId> RacingCases::unknown_memory(const CircuitState& state) const {
    std::vector<NetId> unknown;
    for (const NetId net : remembered_nets()) {
        if (state.values[index_of(net)] == Logic::unknown) unknown.push_back(net);
    }
    return unknown;
}

NetlistOutcome RacingCases::outcome_of(const Rest& rest, const SimulatorState& before,
                                       const PathStep& step, const ReferenceOutcome& expected) {
    if (rest.kind == Rest::Kind::oscillates) return undetermined(rest.changing, step);
    const std::vector<NetId> unknown = unknown_memory(rest.state);
    if (!unknown.empty()) return undetermined(unknown, step);
    simulator().restore(simulator_state(circuit_, before, rest.state, instant()));
    return after_gates(step, expected);
}

/// What tells stimuli apart: when inputs change matters only where delays run.
std::string RacingCases::key_of(const Stimuli& stimuli) const {
    const bool has_times = !delays().empty();
    std::string key;
    for (const Stimuli::Change& change : stimuli.changes) {
        key += has_times ? fmt::format("{}:", change.at) : ":";
        for (const Stimuli::Assignment& set : change.assignments) {
            key += fmt::format("{}={} ", set.input, set.value);
        }
    }
    return has_times ? key + std::to_string(stimuli.end) : key;
}

std::optional<Witness> RacingCases::replay(const Stimuli& stimuli, Time /*period*/) const {
    const std::string key = key_of(stimuli);
    if (without_difference_.count(key) != 0) return std::nullopt;
    const auto search = without_difference_.size() < most_thorough_searches
                            ? WitnessSearch::thorough
                            : WitnessSearch::by_trial;
    auto witness = racing_witness(grafcet(), netlist(), delays_of_gates(), circuit_, delay_model_,
                                  stimuli, search, keep_going_);
    if (!witness) without_difference_.insert(key);
    return witness;
}

}  // namespace grafwire
