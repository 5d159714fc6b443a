// The orders of firings behind a difference.
//
// The exploration of a check forgets how a state came about, and its inputs are partly unassigned.
// So once it has stimuli for a difference, the way there is looked for again, with all inputs
// known: instant by instant, every rest that can come about is followed, until one differs. States
// that have been reached at the same instant before are left out.

#include "check/race_search.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <unordered_set>

#include "simulate/netlist_machine.h"
#include "trace/input_values.h"

namespace grafwire {

CircuitState circuit_state(const Circuit& circuit, const std::vector<Logic>& before,
                           const SimulatorState& prepared, Time instant) {
    CircuitState state;
    state.values = prepared.values;
    state.unanswered = circuit.edges_between(before, prepared.values);
    for (std::size_t i = 0; i < prepared.due.size(); ++i) {
        TimerRun run = TimerRun::goes_on;
        if (prepared.due[i] == never) {
            run = TimerRun::idle;
        } else if (prepared.due[i] <= instant) {
            run = TimerRun::ends;
        }
        state.timers.push_back({run, prepared.towards[i]});
    }
    return state;
}

SimulatorState simulator_state(const Circuit& circuit, const SimulatorState& before,
                               const CircuitState& rest, Time instant) {
    SimulatorState state = before;
    state.values = rest.values;
    for (std::size_t i = 0; i < rest.timers.size(); ++i) {
        state.towards[i] = rest.timers[i].towards;
        if (rest.timers[i].run == TimerRun::idle) state.due[i] = never;
        if (rest.timers[i].run == TimerRun::begun) {
            state.due[i] = add_times(instant, circuit.length_of(i, rest));
        }
    }
    return state;
}

namespace {

constexpr std::size_t most_branches = 20'000;

/// A way through the instants so far.
struct Branch {
    SimulatorState state;
    std::size_t parent = 0;
    RacedInstant last;
};

class RaceSearch {
  public:
    explicit RaceSearch(const RaceQuestion& question)
        : grafcet_(question.grafcet),
          circuit_(question.circuit),
          stimuli_(question.stimuli),
          expected_(question.expected),
          keep_going_(question.keep_going),
          watched_(question.watched),
          machine_(question.grafcet, question.netlist, question.nominal),
          orders_(make_settling_model(question.model, question.circuit, question.keep_going)) {}

    std::optional<std::vector<RacedInstant>> find() {
        const StimuliPlayer player = inputs_at(0);
        if (!machine_.start(known_inputs(player.inputs())).settled) return std::nullopt;
        branches_.push_back({machine_.simulator().save(), 0, {}});
        if (instant(0, 0)) return path();
        for (std::size_t next = 1; next < branches_.size(); ++next) {
            if (branches_.size() > most_branches || (keep_going_ && !keep_going_())) break;
            const Time at = instant_after(branches_[next]);
            if (at != never && instant(next, at)) return path();
        }
        return std::nullopt;
    }

  private:
    StimuliPlayer inputs_at(Time at) const {
        StimuliPlayer player(stimuli_, grafcet_.all_input_count());
        player.advance(at);
        return player;
    }

    /// The instant after the last of a branch, as far as the reference goes; else `never`.
    Time instant_after(const Branch& branch) const {
        const Time at = branch.last.at;
        if (at >= stimuli_.end) return never;
        Time next = std::min(stimuli_.end, inputs_at(at).next_change());
        for (const Time due : branch.state.due) next = std::min(next, due);
        return next < expected_.unstable_at.value_or(never) ? next : never;
    }

    /// What the reference shows at a moment: a row of its trace.
    std::size_t row_at(Time at) const {
        const auto& times = expected_.trace.times;
        const auto after = std::upper_bound(times.begin(), times.end(), at);
        return static_cast<std::size_t>(after - times.begin()) - 1;
    }

    bool is_as_expected(const CircuitState& state, Time at) const {
        const Trace& trace = expected_.trace;
        const std::int64_t* row = trace.values.data() + row_at(at) * trace.columns.size();
        row += grafcet_.all_input_count();
        const auto is_shown = [&](NetId net) {
            return state.values[index_of(net)] == logic_of(*row++ != 0);
        };
        const PortMap& ports = machine_.ports();
        return std::all_of(ports.steps.begin(), ports.steps.end(), is_shown) &&
               std::all_of(ports.outputs.begin(), ports.outputs.end(), is_shown);
    }

    /// Follows a branch through an instant. True where a rest differs, or the net that is watched
    /// changes too often in the last one; it is the last branch then.
    bool instant(std::size_t from, Time at) {
        Simulator& simulator = machine_.simulator();
        if (at > 0) simulator.restore(branches_[from].state);
        const std::vector<Logic> left = simulator.save().values;
        machine_.begin_instant(at, known_inputs(inputs_at(at).inputs()));
        if (at > 0) machine_.end_delays();
        const SimulatorState before = simulator.save();
        const CircuitState begin = circuit_state(circuit_, left, before, at);
        if (watched_ != nullptr && at == stimuli_.end) {
            Pulsing found = orders_->pulsing(begin, *watched_, SettlingModel::usual_states);
            if (found.answer != Pulsing::Answer::shown) return false;
            branches_.push_back(
                {before, from, {at, before.now, begin, std::move(found.firings), {}}});
            return true;
        }
        for (Rest& rest : orders_->settle(begin, true, SettlingModel::usual_states).rests) {
            SimulatorState state = simulator_state(circuit_, before, rest.state, at);
            state.now = before.now + static_cast<Time>(rest.firings.size()) * time_of_firing;
            const bool differs =
                rest.kind == Rest::Kind::oscillates || !is_as_expected(rest.state, at);
            if (differs ? watched_ != nullptr : !is_new(at, rest.state, state)) continue;
            branches_.push_back(
                {std::move(state),
                 from,
                 {at, before.now, begin, std::move(rest.firings), std::move(rest.turn)}});
            if (differs) return true;
        }
        return false;
    }

    bool is_new(Time at, const CircuitState& rest, const SimulatorState& state) {
        std::string key = std::to_string(at);
        for (const Time due : state.due) key += ' ' + std::to_string(due);
        return seen_.insert(key + ':' + circuit_.encoded(rest)).second;
    }

    std::vector<RacedInstant> path() {
        std::vector<RacedInstant> path;
        for (std::size_t i = branches_.size() - 1; i != 0; i = branches_[i].parent) {
            path.push_back(std::move(branches_[i].last));
        }
        std::reverse(path.begin(), path.end());
        return path;
    }

    const Grafcet& grafcet_;
    const Circuit& circuit_;
    const Stimuli& stimuli_;
    const RunResult& expected_;
    const KeepGoing& keep_going_;
    const WatchedNet* const watched_;
    NetlistMachine machine_;
    const std::unique_ptr<SettlingModel> orders_;
    std::deque<Branch> branches_;
    std::unordered_set<std::string> seen_;
};

}  // namespace

std::optional<std::vector<RacedInstant>> find_race(const RaceQuestion& question) {
    return RaceSearch(question).find();
}

}  // namespace grafwire
