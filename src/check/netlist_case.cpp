// A netlist in one case after the other.
//
// What a settled netlist remembers is little beside what it has of nets: the outputs of cells with
// a memory, the nets on loops of gates (netlist/loops.h), and the operands of timers, since a delay
// that runs knows where to. Every other net follows from these and the inputs. And of these again
// only those count on which an X or an output can ever depend: a counter that nothing reads is
// simulated with the rest, but two states that differ in nothing else are one.
//
// Inputs that are open are simulated as unknown, which stands for any behaviour of theirs. Where
// something that counts comes out unknown, one of the open inputs it stems from is to be closed.

#include "check/netlist_case.h"

#include <algorithm>

#include "check/beside.h"
#include "check/running_delays.h"
#include "netlist/loops.h"

namespace grafwire {

NetlistCases::NetlistCases(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                           const KeepGoing& keep_going)
    : netlist_(netlist),
      machine_(grafcet, netlist, delays),
      simulator_(machine_.simulator()),
      ports_(machine_.ports()),
      drivers_(drivers_of(netlist)),
      input_of_net_(netlist.net_count(), none) {
    simulator_.ask(keep_going);
    for (std::uint32_t i = 0; i < ports_.inputs.size(); ++i) {
        if (ports_.inputs[i] != no_net) input_of_net_[index_of(ports_.inputs[i])] = i;
    }
    compared_ = ports_.steps;
    compared_.insert(compared_.end(), ports_.outputs.begin(), ports_.outputs.end());
    is_relevant_ = relevant_nets(netlist, compared_);
    find_remembered_nets();
}

void NetlistCases::find_remembered_nets() {
    const std::vector<std::uint8_t> on_loop = cells_on_loops(netlist_);
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        const Cell& cell = netlist_.cells.items()[i];
        if (is_relevant_[index_of(cell.output)] == 0) continue;
        if (on_loop[i] != 0) on_loops_.push_back(cell.output);
        if (on_loop[i] != 0 || row_of(cell.type).has_memory) remembered_.push_back(cell.output);
        if (cell.type == CellType::timer) remembered_.push_back(netlist_.pins_of(cell)[0]);
    }
    std::sort(remembered_.begin(), remembered_.end());
    remembered_.erase(std::unique(remembered_.begin(), remembered_.end()), remembered_.end());
}

std::vector<std::uint32_t> NetlistCases::conditions_of_timers() const {
    std::vector<std::uint32_t> conditions;
    for (const CellId timer : simulator_.timers()) {
        conditions.push_back(netlist_.timings[netlist_.cells[timer].timing].ordinal);
    }
    return conditions;
}

std::vector<std::uint8_t> NetlistCases::relevant_timers() const {
    std::vector<std::uint8_t> relevant;
    for (const CellId timer : simulator_.timers()) {
        relevant.push_back(is_relevant_[index_of(netlist_.cells[timer].output)]);
    }
    return relevant;
}

/// Two bits a value.
void NetlistCases::append_key(std::string& key, const SimulatorState& state) const {
    unsigned packed = 1;
    const auto append = [&](Logic value) {
        packed = packed << 2U | static_cast<unsigned>(value);
        if (packed < 0x100U) return;
        key += static_cast<char>(packed);
        packed = 1;
    };
    for (const NetId net : remembered_) append(state.values[index_of(net)]);
    for (std::size_t timer = 0; timer < state.due.size(); ++timer) {
        if (state.due[timer] != never) append(state.towards[timer]);
    }
    key += static_cast<char>(packed);
}

std::optional<SimulatorState> NetlistCases::forget(const SimulatorState& state,
                                                   const std::vector<std::uint32_t>& inputs) {
    simulator_.restore(state);
    begin_instant({});
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

/// Power-up, initialisation, and the inputs of the first instant.
Settling NetlistCases::start_up(const PathStep& step) {
    Settling settling = machine_.start(step.inputs);
    begin_instant(step.inputs);
    return settling;
}

/// The state left, with the change of the case.
void NetlistCases::leave(const SimulatorState& start, const PartialInputs& left,
                         const PathStep& step) {
    if (step.ended.timers.empty()) {
        simulator_.restore(start);
    } else {
        SimulatorState with_due = start;
        for (const std::uint32_t timer : step.ended.timers) with_due.due[timer] = 0;
        simulator_.restore(with_due);
    }
    if (step.before != left) machine_.rest_under(step.before);
    begin_instant(step.inputs);
    if (!netlist_.is_clocked()) machine_.end_delays();
}

void NetlistCases::begin_instant(const PartialInputs& inputs) {
    instant_ = simulator_.now();
    machine_.begin_instant(instant_, inputs);
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

bool NetlistCases::same(const BitTable& situation, const OutputValues& outputs) const {
    const std::size_t steps = ports_.steps.size();
    for (std::size_t i = 0; i < compared_.size(); ++i) {
        const bool expected = i < steps ? situation.test(i) : outputs.test(i - steps);
        if ((simulator_.value(compared_[i]) == Logic::one) != expected) return false;
    }
    return true;
}

/// Looks for an open input among what the nets depend on, backwards over all pins.
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

NetlistOutcome NetlistCases::not_settled(const Settling& settling, const PathStep& step) const {
    if (!settling.broken_off) return blame(settling.oscillating, step);
    NetlistOutcome outcome;
    outcome.kind = NetlistOutcome::Kind::broken_off;
    return outcome;
}

/// Compares what the netlist shows, settled, with what it should.
NetlistOutcome NetlistCases::look(const BitTable& situation, const OutputValues& outputs,
                                  const PathStep& step) const {
    NetlistOutcome outcome;
    // A memory that no open input explains has never been given a value. That matters once an X
    // or an output depends on it, and may stay so until then.
    std::vector<NetId> unknown;
    for (const std::vector<NetId>* nets : {&compared_, &remembered_}) {
        for (const NetId net : *nets) {
            if (simulator_.value(net) == Logic::unknown) unknown.push_back(net);
        }
    }
    if (!unknown.empty()) {
        outcome = blame(unknown, step);
        if (outcome.kind == NetlistOutcome::Kind::open) return outcome;
        const bool is_visible =
            std::find(compared_.begin(), compared_.end(), unknown.front()) != compared_.end();
        if (is_visible) return outcome;
        outcome.has_open_memory = true;
    }
    outcome.kind =
        same(situation, outputs) ? NetlistOutcome::Kind::agrees : NetlistOutcome::Kind::differs;
    return outcome;
}

NetlistOutcome NetlistCases::run(const SimulatorState* start, const PartialInputs& left,
                                 const PathStep& step, const ReferenceOutcome& expected) {
    Settling settling;
    if (start == nullptr) {
        settling = start_up(step);
        if (!settling.settled) return not_settled(settling, step);
    } else {
        leave(*start, left, step);
    }
    if (netlist_.is_clocked()) return clock(step, expected);
    settling = machine_.settle();
    if (!settling.settled) return not_settled(settling, step);
    return after_gates(step, expected);
}

/// What is to be compared, and kept, once the gates have come to rest.
NetlistOutcome NetlistCases::after_gates(const PathStep& step, const ReferenceOutcome& expected) {
    NetlistOutcome outcome = look(expected.state.situation, expected.outputs, step);
    if (outcome.kind == NetlistOutcome::Kind::agrees) outcome.state = kept_state();
    return outcome;
}

/// An open input behind a loop of gates that is unknown: in two values it may run round and round.
std::optional<NetlistOutcome> NetlistCases::open_input_of_loops(const PathStep& step) const {
    std::vector<NetId> unknown;
    for (const NetId net : on_loops_) {
        if (simulator_.value(net) == Logic::unknown) unknown.push_back(net);
    }
    if (unknown.empty()) return std::nullopt;
    const NetlistOutcome outcome = blame(unknown, step);
    if (outcome.kind != NetlistOutcome::Kind::open) return std::nullopt;
    return outcome;
}

/// A clock cycle. Loops of gates have to come to rest before each of its edges, which may hide that
/// they did not.
NetlistOutcome NetlistCases::clock(const PathStep& step, const ReferenceOutcome& expected) {
    Settling settling = simulator_.settle();
    if (!settling.settled) return not_settled(settling, step);
    for (const Logic level : {Logic::one, Logic::zero}) {
        if (const auto open = open_input_of_loops(step)) return *open;
        settling = simulator_.set_clock(level);
        if (!settling.settled) return not_settled(settling, step);
    }
    return after_gates(step, expected);
}

}  // namespace grafwire
