// A netlist in one case after the other.
//
// What a settled netlist remembers is little beside what it has of nets: the outputs of cells with
// a memory, the nets on loops of gates (cells_on_loops), and the operands of timers, since a delay
// that runs knows where to. Every other net follows from these and the inputs. And of these again
// only those count that are in the cone of influence of an X or an output: a counter that nothing
// reads is simulated with the rest, but two states that differ in nothing else are one.
//
// Unassigned inputs are simulated as unknown, which stands for any behaviour of theirs (ternary
// simulation: E. B. Eichelberger, "Hazard detection in combinational and sequential switching
// circuits", IBM J. Res. Dev. 9, 1965; J. A. Brzozowski, C.-J. H. Seger, "Asynchronous Circuits",
// 1995). Where something that counts comes out unknown, the outcome says why: an unassigned input
// that it stems from, or nothing outside. As every gate here has one delay, gates leave nothing
// open by themselves but memories that were never given a value; so any unassigned input that the
// unknown nets depend on is taken for the cause, and only where there is none it is theirs.

#include "check/netlist_case.h"

#include <algorithm>

#include "check/netlist_witness.h"
#include "check/running_delays.h"
#include "netlist/netlist.h"

namespace grafwire {

namespace {

/// The outcome where something that is compared is unknown.
NetlistOutcome outcome_of_unknown(const UnknownCause& cause) {
    NetlistOutcome outcome;
    outcome.kind =
        cause.is_of_an_input() ? NetlistOutcome::Kind::unassigned : NetlistOutcome::Kind::differs;
    outcome.unknown = cause;
    return outcome;
}

}  // namespace

std::vector<std::uint8_t> cone_of_influence(const Netlist& netlist,
                                            const std::vector<NetId>& roots) {
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    std::vector<std::uint8_t> relevant(netlist.net_count());
    std::vector<NetId> waiting;
    const auto add = [&](NetId net) {
        if (relevant[index_of(net)] != 0) return;
        relevant[index_of(net)] = 1;
        waiting.push_back(net);
    };
    for (const NetId net : roots) add(net);
    while (!waiting.empty()) {
        const CellId driver = drivers[waiting.back()];
        waiting.pop_back();
        if (driver == no_cell) continue;
        for (const NetId pin : netlist.pins_of(netlist.cells[driver])) add(pin);
    }
    return relevant;
}

std::vector<Time> timer_lengths(const Netlist& netlist) {
    std::vector<Time> lengths;
    for (const Cell& cell : netlist.cells) {
        if (!is_timer(cell.type)) continue;
        const auto& timing = netlist.timings[cell.timing];
        lengths.push_back(timing.rise);
        lengths.push_back(timing.fall);
    }
    return lengths;
}

NetlistCases::NetlistCases(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                           const KeepGoing& keep_going)
    : grafcet_(grafcet),
      netlist_(netlist),
      delays_(delays),
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
    is_relevant_ = cone_of_influence(netlist, compared_);
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
void NetlistCases::encode(std::string& encoding, const SimulatorState& state) const {
    unsigned packed = 1;
    const auto append = [&](Logic value) {
        packed = packed << 2U | static_cast<unsigned>(value);
        if (packed < 0x100U) return;
        encoding += static_cast<char>(packed);
        packed = 1;
    };
    for (const NetId net : remembered_) append(state.values[index_of(net)]);
    for (std::size_t timer = 0; timer < state.due.size(); ++timer) {
        if (state.due[timer] != never) append(state.towards[timer]);
    }
    encoding += static_cast<char>(packed);
}

std::optional<SimulatorState> NetlistCases::abstracted(const SimulatorState& state,
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
    SimulatorState abstracted = kept_state();
    if (abstracted.due != state.due) return std::nullopt;
    return abstracted;
}

/// The state left, with the delays that are due, under the inputs before the case.
void NetlistCases::prepare(const SimulatorState& start, const PartialInputs& left,
                           const PathStep& step) {
    if (step.ended.timers.empty()) {
        simulator_.restore(start);
    } else {
        SimulatorState with_due = start;
        for (const std::uint32_t timer : step.ended.timers) with_due.due[timer] = 0;
        simulator_.restore(with_due);
    }
    if (step.before != left) machine_.rest_under(logic_of(step.before));
}

void NetlistCases::begin_instant(const std::vector<Logic>& inputs) {
    instant_ = simulator_.now();
    machine_.begin_instant(instant_, inputs);
}

/// What is to be kept of the present state: the clock goes back to 0, and the ends of delays that
/// began at the instant become their lengths.
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

/// An unassigned input among what the nets depend on, looked for backwards over all pins.
std::optional<std::uint32_t> NetlistCases::unassigned_input_behind(
    const std::vector<NetId>& nets, const PartialInputs& inputs) const {
    std::vector<std::uint8_t> seen(netlist_.net_count());
    std::vector<NetId> waiting = nets;
    for (const NetId net : waiting) seen[index_of(net)] = 1;
    for (std::size_t next = 0; next < waiting.size(); ++next) {
        const NetId net = waiting[next];
        const std::uint32_t carried = input_of_net_[index_of(net)];
        if (carried != none && inputs[carried] == PartialInput::unassigned) return carried;
        if (drivers_[net] == no_cell) continue;
        for (const NetId pin : netlist_.pins_of(netlist_.cells[drivers_[net]])) {
            if (seen[index_of(pin)] == 0) {
                seen[index_of(pin)] = 1;
                waiting.push_back(pin);
            }
        }
    }
    return std::nullopt;
}

/// Why some nets are unknown.
UnknownCause NetlistCases::cause_of(const std::vector<NetId>& nets, const PathStep& step) const {
    if (const auto input = unassigned_input_behind(nets, step.inputs)) {
        return {UnknownCause::Kind::unassigned_input, *input};
    }
    if (const auto input = unassigned_input_behind(nets, step.before)) {
        return {UnknownCause::Kind::unassigned_before, *input};
    }
    return {};
}

NetlistOutcome NetlistCases::undetermined(const std::vector<NetId>& nets,
                                          const PathStep& step) const {
    return outcome_of_unknown(cause_of(nets, step));
}

NetlistOutcome NetlistCases::not_settled(const Settling& settling, const PathStep& step) const {
    if (!settling.broken_off) return undetermined(settling.oscillating, step);
    NetlistOutcome outcome;
    outcome.kind = NetlistOutcome::Kind::broken_off;
    return outcome;
}

/// Compares what the netlist shows, settled, with what it should.
NetlistOutcome NetlistCases::compare(const BitTable& situation, const OutputValues& outputs,
                                     const PathStep& step) const {
    NetlistOutcome outcome;
    // A memory that no unassigned input explains has never been given a value. That matters once an
    // X or an output depends on it, and may stay so until then.
    std::vector<NetId> unknown;
    for (const std::vector<NetId>* nets : {&compared_, &remembered_}) {
        for (const NetId net : *nets) {
            if (simulator_.value(net) == Logic::unknown) unknown.push_back(net);
        }
    }
    if (!unknown.empty()) {
        outcome = outcome_of_unknown(cause_of(unknown, step));
        if (outcome.kind == NetlistOutcome::Kind::unassigned) return outcome;
        const bool is_visible =
            std::find(compared_.begin(), compared_.end(), unknown.front()) != compared_.end();
        if (is_visible) return outcome;
    }
    outcome.kind =
        same(situation, outputs) ? NetlistOutcome::Kind::agrees : NetlistOutcome::Kind::differs;
    return outcome;
}

NetlistOutcomes NetlistCases::run(const SimulatorState* start, const PartialInputs& left,
                                  const PathStep& step, const ReferenceOutcome& expected) {
    NetlistOutcomes outcomes;
    outcomes.push_back(outcome_of(start, left, step, expected));
    return outcomes;
}

NetlistOutcome NetlistCases::outcome_of(const SimulatorState* start, const PartialInputs& left,
                                        const PathStep& step, const ReferenceOutcome& expected) {
    Settling settling = begin(start, left, step);
    if (!settling.settled) return not_settled(settling, step);
    if (netlist_.is_clocked()) return clock(step, expected);
    settling = machine_.settle();
    if (!settling.settled) return not_settled(settling, step);
    return after_gates(step, expected);
}

Settling NetlistCases::begin(const SimulatorState* start, const PartialInputs& left,
                             const PathStep& step, std::vector<Logic>* values_left) {
    const std::vector<Logic> inputs = logic_of(step.inputs);
    Settling settling;
    if (start == nullptr) {
        settling = machine_.start(inputs);
    } else {
        prepare(*start, left, step);
    }
    if (values_left != nullptr) *values_left = simulator_.save().values;
    begin_instant(inputs);
    if (start != nullptr && !netlist_.is_clocked()) machine_.end_delays();
    return settling;
}

std::optional<Witness> NetlistCases::replay(const Stimuli& stimuli, Time period) const {
    return grafwire::replay(grafcet_, netlist_, delays_, stimuli, period);
}

NetlistOutcome NetlistCases::after_gates(const PathStep& step, const ReferenceOutcome& expected) {
    NetlistOutcome outcome = compare(expected.state.situation, expected.outputs, step);
    if (outcome.kind == NetlistOutcome::Kind::agrees) outcome.state = kept_state();
    return outcome;
}

/// An unassigned input behind a loop of gates that is unknown: in two values it may run round and
/// round.
std::optional<NetlistOutcome> NetlistCases::unassigned_input_of_loops(const PathStep& step) const {
    std::vector<NetId> unknown;
    for (const NetId net : on_loops_) {
        if (simulator_.value(net) == Logic::unknown) unknown.push_back(net);
    }
    if (unknown.empty()) return std::nullopt;
    const UnknownCause cause = cause_of(unknown, step);
    if (!cause.is_of_an_input()) return std::nullopt;
    return outcome_of_unknown(cause);
}

/// A clock cycle. Loops of gates have to come to rest before each of its edges, which may hide that
/// they did not.
NetlistOutcome NetlistCases::clock(const PathStep& step, const ReferenceOutcome& expected) {
    Settling settling = simulator_.settle();
    if (!settling.settled) return not_settled(settling, step);
    for (const Logic level : {Logic::one, Logic::zero}) {
        if (const auto unassigned = unassigned_input_of_loops(step)) return *unassigned;
        settling = simulator_.set_clock(level);
        if (!settling.settled) return not_settled(settling, step);
    }
    return after_gates(step, expected);
}

}  // namespace grafwire
