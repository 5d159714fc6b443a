#include "check/netlist_case.h"

#include <algorithm>
#include <boost/graph/strong_components.hpp>

#include "check/running_delays.h"
#include "netlist/boost_graph.h"

namespace grafwire {

namespace {

/// Moments aside.
bool goes_on_alike(const SimulatorState& a, const SimulatorState& b) {
    return a.values == b.values && a.due == b.due && a.towards == b.towards;
}

std::vector<NetId> differing_nets(const SimulatorState& a, const SimulatorState& b) {
    std::vector<NetId> nets;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        if (a.values[i] != b.values[i]) nets.push_back(static_cast<NetId>(i));
    }
    return nets;
}

}  // namespace

NetlistCases::NetlistCases(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays)
    : grafcet_(grafcet),
      netlist_(netlist),
      simulator_(netlist, delays),
      ports_(map_ports(grafcet, netlist)),
      drivers_(drivers_of(netlist)),
      input_of_net_(netlist.net_count(), none) {
    for (std::uint32_t i = 0; i < ports_.inputs.size(); ++i) {
        if (ports_.inputs[i] != no_net) input_of_net_[index_of(ports_.inputs[i])] = i;
    }
    find_watched_nets();
}

void NetlistCases::find_watched_nets() {
    const NetlistGraph graph(netlist_);
    std::vector<std::uint32_t> component(graph.cell_count());
    const auto index = get(boost::vertex_index_t{}, graph);
    const auto count =
        boost::strong_components(graph, boost::make_iterator_property_map(component.begin(), index),
                                 boost::vertex_index_map(index));
    std::vector<std::uint32_t> size(count);
    for (const std::uint32_t c : component) ++size[c];
    for (std::uint32_t i = 0; i < component.size(); ++i) {
        const Cell& cell = netlist_.cells[netlist_.cells.id_at(i)];
        const auto readers = graph.readers(i);
        const bool own_reader = std::find(readers.begin(), readers.end(), i) != readers.end();
        const bool in_loop = size[component[i]] > 1 || own_reader;
        if (in_loop || row_of(cell.type).has_memory) watched_.push_back(cell.output);
        if (is_timer(cell.type)) {
            watched_.push_back(netlist_.pins_of(cell)[0]);
        }
    }
    watched_.insert(watched_.end(), ports_.steps.begin(), ports_.steps.end());
    remembered_ = watched_;
    watched_.insert(watched_.end(), ports_.outputs.begin(), ports_.outputs.end());
    std::sort(watched_.begin(), watched_.end());
    watched_.erase(std::unique(watched_.begin(), watched_.end()), watched_.end());
}

std::optional<SimulatorState> NetlistCases::forget(const SimulatorState& state,
                                                   const std::vector<std::uint32_t>& inputs) {
    simulator_.restore(state);
    begin_instant();
    for (const std::uint32_t input : inputs) {
        if (ports_.inputs[input] == no_net) continue;
        simulator_.set_input(ports_.inputs[input], Logic::unknown);
    }
    if (!simulator_.settle().settled) return std::nullopt;
    for (const NetId net : remembered_) {
        if (simulator_.value(net) != state.values[index_of(net)]) return std::nullopt;
    }
    SimulatorState forgetful = kept_state();
    if (forgetful.due != state.due) return std::nullopt;
    return forgetful;
}

void NetlistCases::set_inputs(const PartialInputs& inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (ports_.inputs[i] != no_net) simulator_.set_input(ports_.inputs[i], inputs[i]);
    }
}

/// Power-up, initialisation, and the inputs of the first instant.
Settling NetlistCases::start_up(const PathStep& step) {
    simulator_.power_up();
    Settling settling = initialise(simulator_, grafcet_, netlist_, ports_, step.inputs);
    begin_instant();
    set_inputs(step.inputs);
    return settling;
}

/// The state left, with the change of the case.
void NetlistCases::leave(const SimulatorState& start, const PartialInputs& left,
                         const PathStep& step) {
    simulator_.restore(start);
    if (step.before != left) {
        simulator_.hold_pulses(true);
        set_inputs(step.before);
        simulator_.settle();
        simulator_.hold_pulses(false);
    }
    begin_instant();
    for (const std::uint32_t timer : step.ended.timers) simulator_.end_delay(timer);
    set_inputs(step.inputs);
}

void NetlistCases::begin_instant() {
    instant_ = simulator_.now();
    simulator_.begin_instant(instant_);
}

/// What is to be kept of the present state: the clock goes back to 0, and the moments of delays
/// that began at the instant become their lengths.
SimulatorState NetlistCases::kept_state() const {
    SimulatorState state = simulator_.save();
    state.now = 0;
    for (Time& due : state.due) {
        if (due != never && due != some_time) due -= instant_;
    }
    return state;
}

std::vector<std::uint32_t> NetlistCases::conditions_of_timers() const {
    std::vector<std::uint32_t> conditions;
    for (const CellId timer : simulator_.timers()) {
        conditions.push_back(netlist_.timings[netlist_.cells[timer].timing].ordinal);
    }
    return conditions;
}

bool NetlistCases::same(const BitTable& situation, const OutputValues& outputs) const {
    for (std::size_t i = 0; i < ports_.steps.size(); ++i) {
        if ((simulator_.value(ports_.steps[i]) == Logic::one) != situation.test(i)) return false;
    }
    for (std::size_t i = 0; i < ports_.outputs.size(); ++i) {
        if ((simulator_.value(ports_.outputs[i]) == Logic::one) != outputs.test(i)) return false;
    }
    return true;
}

std::vector<NetId> NetlistCases::unknown_nets() const {
    std::vector<NetId> unknown;
    for (const NetId net : watched_) {
        if (simulator_.value(net) == Logic::unknown) unknown.push_back(net);
    }
    return unknown;
}

bool NetlistCases::is_compared(NetId net) const {
    return std::find(ports_.steps.begin(), ports_.steps.end(), net) != ports_.steps.end() ||
           std::find(ports_.outputs.begin(), ports_.outputs.end(), net) != ports_.outputs.end();
}

/// Looks for an open input among what the nets depend on, backwards over pins whose value is not
/// known.
bool NetlistCases::open_input_behind(const std::vector<NetId>& nets, const PartialInputs& inputs,
                                     std::uint32_t& input) const {
    std::vector<std::uint8_t> seen(netlist_.net_count());
    std::vector<NetId> waiting = nets;
    for (const NetId net : waiting) seen[index_of(net)] = 1;
    for (std::size_t next = 0; next < waiting.size(); ++next) {
        const NetId net = waiting[next];
        const std::uint32_t carried = input_of_net_[index_of(net)];
        if (carried != none && inputs[carried] == Logic::unknown) {
            input = carried;
            return true;
        }
        if (drivers_[net] == no_cell) continue;
        for (const NetId pin : netlist_.pins_of(netlist_.cells[drivers_[net]])) {
            if (seen[index_of(pin)] == 0) {
                seen[index_of(pin)] = 1;
                waiting.push_back(pin);
            }
        }
    }
    return false;
}

NetlistOutcome NetlistCases::blame(const std::vector<NetId>& nets, const PathStep& step) const {
    NetlistOutcome outcome;
    outcome.kind = NetlistOutcome::Kind::open;
    if (open_input_behind(nets, step.inputs, outcome.split)) return outcome;
    outcome.split_before = true;
    if (open_input_behind(nets, step.before, outcome.split)) return outcome;
    outcome.kind = NetlistOutcome::Kind::differs;
    return outcome;
}

/// Compares what the netlist shows, settled, with what it should.
NetlistOutcome NetlistCases::look(const BitTable& situation, const OutputValues& outputs,
                                  const PathStep& step) const {
    NetlistOutcome outcome;
    // A memory that no open input explains has never been given a value. That matters once an X
    // or an output depends on it, and may stay so until then.
    if (const std::vector<NetId> unknown = unknown_nets(); !unknown.empty()) {
        outcome = blame(unknown, step);
        if (outcome.kind == NetlistOutcome::Kind::open) return outcome;
        const bool visible = std::any_of(unknown.begin(), unknown.end(),
                                         [&](NetId net) { return is_compared(net); });
        if (visible) return outcome;
    }
    outcome.kind =
        same(situation, outputs) ? NetlistOutcome::Kind::agrees : NetlistOutcome::Kind::differs;
    return outcome;
}

NetlistOutcome NetlistCases::run(const SimulatorState* start, const PartialInputs& left,
                                 const PathStep& step, const ReferenceOutcome& expected) {
    if (start == nullptr) {
        const Settling settling = start_up(step);
        if (!settling.settled) return blame(settling.oscillating, step);
    } else {
        leave(*start, left, step);
    }
    if (netlist_.is_clocked()) return run_cycles(step, expected);
    const Settling settling = simulator_.settle();
    if (!settling.settled) return blame(settling.oscillating, step);
    NetlistOutcome outcome = look(expected.state.situation, expected.outputs, step);
    if (outcome.kind == NetlistOutcome::Kind::agrees) outcome.state = kept_state();
    return outcome;
}

/// A clock cycle for every scan of the reference, and more until the netlist is at rest as well. If
/// it comes back to a state instead (found by Brent's scheme), it does not settle.
NetlistOutcome NetlistCases::run_cycles(const PathStep& step, const ReferenceOutcome& expected) {
    NetlistOutcome outcome;
    SimulatorState landmark;
    std::size_t next_landmark = expected.scans.size();
    for (std::size_t cycle = 1; expected.stable || cycle <= expected.scans.size(); ++cycle) {
        const bool reference_rests = expected.stable && cycle >= expected.scans.size();
        const SimulatorState before = reference_rests ? simulator_.save() : SimulatorState();
        const Settling settling = simulator_.clock_cycle();
        if (!settling.settled) return blame(settling.oscillating, step);
        const auto& scan = expected.scans[std::min(cycle, expected.scans.size()) - 1];
        const NetlistOutcome now = look(scan.situation, scan.outputs, step);
        if (now.kind == NetlistOutcome::Kind::open) return now;
        if (now.kind == NetlistOutcome::Kind::differs) {
            outcome.kind = NetlistOutcome::Kind::differs_within;
        }
        if (!reference_rests) continue;
        const SimulatorState after = simulator_.save();
        if (goes_on_alike(before, after)) {
            if (now.kind == NetlistOutcome::Kind::differs) return now;
            break;
        }
        if (goes_on_alike(landmark, after)) return blame(differing_nets(before, after), step);
        if (cycle == next_landmark) {
            landmark = after;
            next_landmark *= 2;
        }
    }
    outcome.state = kept_state();
    return outcome;
}

}  // namespace grafwire
