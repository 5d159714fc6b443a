// X and outputs that change too often: static and dynamic hazards, looked for in every case of an
// exploration.
//
// The verdict asks where a netlist comes to rest. On the way there an X or output may have changed
// more often than it should: what counts its edges, or sets a latch of the plant, goes wrong. The
// reference passes through transient situations at an instant, and changes of its X there, and of
// the outputs that would belong to these situations, are wanted. So the changes of the netlist are
// held against those of the reference from scan to scan: as both begin and end alike, the netlist
// has as many, or two, four and so on too many.
//
// A case of the exploration leaves inputs unassigned, and there are many cases. In this order:
//
// - What may move at all in the case is taken from three values (open_cone.h), where gates of fixed
//   delays are simulated in three values. An X or output that does not move, or not too often, is
//   done with.
// - The inputs are assigned by which it may move, by splitting the case as the exploration does
//   (exploration.cpp). The others then have no part in it, and are given some value.
// - Under fixed delays the netlist is simulated. Under open ones all orders of firings are gone
//   through in the part of the circuit by which the net may move (SettlingModel::pulsing). Many
//   cases have the same such part in the same state, so its answers are kept.
// - What is found is shown: stimuli are made of the path to the case, delays are looked for
//   (racing_witness.h), and a simulation from power-up has to count too many changes in its last
//   instant. Then the net is done with. As the exploration is breadth first, the stimuli are among
//   the shortest.
//
// An unassigned input is one that neither the reference nor a memory of the netlist looks at in the
// state left. The exploration need not change it there; an output may pulse all the same. So where
// the value of one is open in a state, its changes are looked at as well.
//
// Power-up is left out: nets come from unknown values there.

#include "check/pulse_search.h"

#include <algorithm>

#include "check/expansion.h"
#include "check/netlist_witness.h"
#include "check/race_search.h"
#include "check/racing_witness.h"
#include "evolution/run.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

/// With what is not found among so many states a search of this kind is given up.
constexpr std::size_t most_states = 30'000;

/// Into so many parts a case is split.
constexpr std::size_t most_parts = 200;

/// So often something is found for one net and cannot be shown, then it is left open.
constexpr int most_failures = 6;

}  // namespace

PulseSearch::PulseSearch(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& nominal,
                         const CheckOptions& options)
    : NetlistCases(grafcet, netlist, nominal, options.keep_going),
      options_(options),
      assumptions_(grafcet),
      evolution_(grafcet),
      reference_(evolution_, options.keep_going),
      circuit_(netlist, relevant_nets()),
      cone_(circuit_) {
    for (std::size_t i = 0; i < compared_nets().size(); ++i) {
        const std::size_t steps = grafcet.steps.size();
        Watched watched;
        watched.name = i < steps ? "X" + grafcet.steps.items()[i].name
                                 : grafcet.outputs.items()[i - steps].name;
        watched.net = compared_nets()[i];
        watched_.push_back(std::move(watched));
    }
}

/// Nothing is left to be said of it. One that no gate drives changes as an input does.
bool PulseSearch::is_done(const Watched& watched) const {
    return watched.found || watched.net == no_net || circuit_.driver(watched.net) == Circuit::none;
}

void PulseSearch::look_at(const Case& one, const StimuliFor& stimuli_for) {
    ++cases_;
    for (const PathStep& step : changes_in(one)) look_at_change(one, step, stimuli_for);
    for (Watched& watched : watched_) {
        if (watched.is_open) ++watched.open_cases;
        watched.is_open = false;
    }
}

/// The step itself; where no input changes in it, changes of those that are unassigned.
std::vector<PathStep> PulseSearch::changes_in(const Case& one) const {
    const bool is_change = !one.step.ended.none() || one.step.before != one.step.inputs;
    if (is_change || !is_one_at_a_time()) return {one.step};
    const bool may_move =
        std::any_of(watched_.begin(), watched_.end(), [&](const Watched& watched) {
            return !is_done(watched) && one.netlist.values[index_of(watched.net)] == Logic::unknown;
        });
    return may_move ? changes_of_unassigned(one) : std::vector<PathStep>();
}

/// Changes of one input that is unassigned in the state left; of two, where the assumptions tie
/// them together.
std::vector<PathStep> PulseSearch::changes_of_unassigned(const Case& one) const {
    std::vector<std::uint32_t> unassigned;
    for (std::uint32_t i = 0; i < one.left.size(); ++i) {
        if (one.left[i] == PartialInput::unassigned) unassigned.push_back(i);
    }
    std::vector<PathStep> steps;
    for (const std::uint32_t input : unassigned) {
        for (const PartialInput value : {PartialInput::one, PartialInput::zero}) {
            PathStep step = one.step;
            if (step.inputs[input] == opposite(value)) continue;
            step.inputs[input] = value;
            step.before = step.inputs;
            step.before[input] = opposite(value);
            for (const std::uint32_t other : unassigned) {
                if (assumptions_.can_hold(step.before)) break;
                if (other == input) continue;
                PathStep both = step;
                both.before[other] = opposite(both.before[other]);
                if (assumptions_.can_hold(both.before)) step = std::move(both);
            }
            steps.push_back(std::move(step));
        }
    }
    return steps;
}

void PulseSearch::look_at_change(const Case& one, const PathStep& step,
                                 const StimuliFor& stimuli_for) {
    Places all;
    for (std::size_t place = 0; place < watched_.size(); ++place) {
        if (!is_done(watched_[place])) all.push_back(place);
    }
    std::vector<Part> remaining{{step, all}};
    for (std::size_t parts = 0; !remaining.empty(); ++parts) {
        const bool goes_on = !options_.keep_going || options_.keep_going();
        Part part = std::move(remaining.back());
        remaining.pop_back();
        const bool can_be =
            assumptions_.can_hold(part.step.inputs) && assumptions_.can_hold(part.step.before);
        if (!can_be) continue;
        if (goes_on && parts < most_parts) {
            look_at_part(one, std::move(part), remaining, stimuli_for);
        } else {
            for (const std::size_t place : part.watched) watched_[place].is_open = true;
        }
    }
}

/// The state in which the gates begin, from the state left.
CircuitState PulseSearch::begin_part(const Case& one, const PathStep& step) {
    begin(&one.netlist, one.left, step, &left_);
    return circuit_state(circuit_, left_, simulator().save(), instant());
}

/// Leaves those that change, or may: under fixed delays as the simulation in three values says.
void PulseSearch::keep_unsteady(Places& places) {
    std::vector<std::uint8_t> changes(netlist().net_count());
    if (options_.delays.is_fixed()) {
        simulator().observe([&](Time, NetId net, Logic) {
            if (changes[index_of(net)] < 2) ++changes[index_of(net)];
        });
        settle();
        simulator().observe({});
    }
    std::erase_if(places, [&](std::size_t place) {
        const NetId net = watched_[place].net;
        if (!cone_.is_open(net)) return true;
        const bool is_known =
            left_[index_of(net)] != Logic::unknown && simulator().value(net) != Logic::unknown;
        // One change between known values is right: the two sides end alike.
        return options_.delays.is_fixed() && is_known && changes[index_of(net)] < 2;
    });
}

/// An unassigned input by which the net may move, if there is one.
std::optional<UnknownCause> PulseSearch::unassigned_behind(std::size_t place,
                                                           const CircuitState& from,
                                                           const PathStep& step) const {
    using Kind = UnknownCause::Kind;
    const auto is_unassigned = [](const PartialInputs& inputs, std::uint32_t input) {
        return input != none && inputs[input] == PartialInput::unassigned;
    };
    std::optional<UnknownCause> before;
    for (const NetId net : cone_.behind(watched_[place].net)) {
        const std::uint32_t input = input_of(net);
        if (is_unassigned(step.inputs, input)) return UnknownCause{Kind::unassigned_input, input};
        const std::uint32_t driver = circuit_.driver(net);
        if (driver == Circuit::none || from.values[index_of(net)] != Logic::unknown) continue;
        for (const NetId pin : circuit_.pins(driver)) {
            if (!is_unassigned(step.before, input_of(pin))) continue;
            before = UnknownCause{Kind::unassigned_before, input_of(pin)};
        }
    }
    return before;
}

void PulseSearch::look_at_part(const Case& one, Part part, std::vector<Part>& remaining,
                               const StimuliFor& stimuli_for) {
    std::erase_if(part.watched, [&](std::size_t place) { return is_done(watched_[place]); });
    const CircuitState from = begin_part(one, part.step);
    cone_.make(from);
    keep_unsteady(part.watched);
    if (part.watched.empty()) return;
    // Those behind which all inputs are assigned are looked at; for the others it is split.
    Places ready;
    std::optional<UnknownCause> cause;
    std::erase_if(part.watched, [&](std::size_t place) {
        const auto unassigned = unassigned_behind(place, from, part.step);
        if (unassigned && !cause) cause = unassigned;
        if (!unassigned) ready.push_back(place);
        return !unassigned;
    });
    if (!ready.empty()) look_closely(one, part.step, ready, stimuli_for);
    if (!cause) return;
    for (PathStep& half : halves_of(assumptions_, part.step, *cause, is_one_at_a_time())) {
        remaining.push_back({std::move(half), part.watched});
    }
}

/// The step with all inputs assigned: those that it leaves open do not change in it.
std::optional<PathStep> PulseSearch::completed(const PathStep& step) const {
    const auto inputs = assumptions_.complete(step.inputs, InputValues(step.inputs.size(), 0));
    if (!inputs) return std::nullopt;
    const auto before = assumptions_.complete(step.before, *inputs);
    if (!before) return std::nullopt;
    PathStep complete = step;
    complete.inputs = assigned_inputs(*inputs);
    complete.before = assigned_inputs(*before);
    return complete;
}

/// Nets whose moves in a part are decided by inputs that are assigned in it.
void PulseSearch::look_closely(const Case& one, const PathStep& step, const Places& places,
                               const StimuliFor& stimuli_for) {
    const auto complete = completed(step);
    if (!complete) return;
    const CircuitState from = begin_part(one, *complete);
    std::vector<Logic> before;
    for (const NetId net : compared_nets()) before.push_back(left_[index_of(net)]);
    const ReferenceCases::Changes expected =
        reference_.changes(one.reference, complete->ended.conditions, complete->inputs, before);
    std::vector<std::uint8_t> got(netlist().net_count());
    if (options_.delays.is_fixed()) {
        simulator().observe([&](Time, NetId net, Logic) {
            if (got[index_of(net)] <= ReferenceCases::most_changes) ++got[index_of(net)];
        });
        settle();
        simulator().observe({});
    } else {
        cone_.make(from);
    }
    for (const std::size_t place : places) {
        Watched& watched = watched_[place];
        const WatchedNet net{watched.net, expected.counts[place]};
        Pulsing::Answer answer_of_net = Pulsing::Answer::never;
        if (!options_.delays.is_fixed()) {
            answer_of_net = answer(net, from);
        } else if (got[index_of(net.net)] > net.most) {
            answer_of_net = Pulsing::Answer::shown;
        }
        if (answer_of_net == Pulsing::Answer::never) continue;
        const bool is_shown = answer_of_net == Pulsing::Answer::shown &&
                              watched.failures < most_failures &&
                              show(watched, net.most, stimuli_for(*complete));
        if (!is_shown) watched.is_open = true;
    }
}

/// Everything that decides what a net does: its part of the circuit, and the values in it.
std::string PulseSearch::key_of(const WatchedNet& watched, const std::vector<NetId>& cone,
                                const CircuitState& from) const {
    std::string key = std::to_string(index_of(watched.net)) + '<' + std::to_string(watched.most);
    bool has_timing = false;
    const auto add = [&](NetId net) {
        key += static_cast<char>('0' + static_cast<int>(from.values[index_of(net)]));
    };
    for (const NetId net : cone) {
        key += ' ' + std::to_string(index_of(net));
        add(net);
        const std::uint32_t driver = circuit_.driver(net);
        if (driver == Circuit::none) continue;
        for (const NetId pin : circuit_.pins(driver)) add(pin);
        has_timing =
            has_timing || is_timer(circuit_.type(driver)) || is_pulse(circuit_.type(driver));
    }
    if (!has_timing) return key;
    for (const TimerState& timer : from.timers) {
        key += static_cast<char>('a' + static_cast<int>(timer.run));
        key += static_cast<char>('0' + static_cast<int>(timer.towards));
    }
    for (const std::uint8_t edges : from.unanswered) key += static_cast<char>('0' + edges);
    return key;
}

/// Under open delays, from a state of which everything is known.
Pulsing::Answer PulseSearch::answer(const WatchedNet& watched, const CircuitState& from) {
    if (!cone_.is_open(watched.net)) return Pulsing::Answer::never;
    const std::vector<NetId> cone = cone_.behind(watched.net);
    std::vector<std::uint8_t> is_in_cone(netlist().net_count());
    for (const NetId net : cone) {
        if (from.values[index_of(net)] == Logic::unknown) return Pulsing::Answer::open;
        is_in_cone[index_of(net)] = 1;
    }
    const auto [place, is_new] =
        answers_.emplace(key_of(watched, cone, from), Pulsing::Answer::open);
    if (!is_new) return place->second;
    const Circuit part(netlist(), is_in_cone);
    const auto model = make_settling_model(options_.delays, part, options_.keep_going);
    place->second = model->pulsing(from, watched, most_states).answer;
    return place->second;
}

bool PulseSearch::show(Watched& watched, std::uint8_t expected,
                       const std::vector<Stimuli>& stimuli) {
    for (const Stimuli& some : stimuli) {
        watched.found = pulse_over(watched, expected, some);
        if (watched.found) return true;
    }
    ++watched.failures;
    return false;
}

/// A run that shows it.
std::optional<Pulse> PulseSearch::pulse_over(const Watched& watched, std::uint8_t expected,
                                             const Stimuli& stimuli) const {
    Pulse pulse{watched.name, watched.net, stimuli, expected, 0, {}};
    const Grafcet& chart = grafcet();
    const CellDelays& delays = delays_of_gates();
    if (!options_.delays.is_fixed()) {
        auto found = racing_pulse(chart, netlist(), delays, circuit_, options_.delays, stimuli,
                                  {watched.net, expected}, options_.keep_going);
        if (!found) return std::nullopt;
        pulse.delays = std::move(*found);
    }
    pulse.got = changes_at_end(chart, netlist(), delays, stimuli, run_until_stable(chart, stimuli),
                               pulse.delays, watched.net);
    if (pulse.got <= expected) return std::nullopt;
    return pulse;
}

bool PulseSearch::has_open() const {
    return std::any_of(watched_.begin(), watched_.end(), [](const Watched& watched) {
        return !watched.found && watched.open_cases != 0;
    });
}

void PulseSearch::begin_again() {
    cases_ = 0;
    for (Watched& watched : watched_) {
        watched.open_cases = 0;
        watched.failures = 0;
    }
}

Pulses PulseSearch::take() {
    Pulses pulses;
    pulses.cases = cases_;
    for (Watched& watched : watched_) {
        if (watched.found) {
            pulses.found.push_back(std::move(*watched.found));
        } else if (watched.open_cases != 0) {
            pulses.open.push_back({watched.name, watched.open_cases});
        }
    }
    return pulses;
}

}  // namespace grafwire
