// A netlist as a machine of gates.
//
// Everything that a cell reads is told by its pins, its output and, for timers and pulse cells, by
// a few bits of their own. So what can be done in a state is a function of the state alone, which
// is what the methods that go through all orders of firings need.
//
// A change of an input of a timer or a pulse cell is noted by the cell at once, and counts as part
// of the change: forks are isochronic. Only what it does about it takes time.

#include "settling/circuit.h"

#include <algorithm>
#include <array>
#include <optional>

namespace grafwire {

namespace {

/// A gate that is a function of how many of its pins are at one value.
struct CountingRule {
    Logic controlling;  ///< a pin with this value decides by itself…
    Logic decided;      ///< … and this is what the gate asks for then, else the inverse
};

std::optional<CountingRule> counting_rule(CellType type) {
    switch (type) {
        case CellType::and_gate:
            return CountingRule{Logic::zero, Logic::zero};
        case CellType::nand_gate:
            return CountingRule{Logic::zero, Logic::one};
        case CellType::buffer:
        case CellType::or_gate:
            return CountingRule{Logic::one, Logic::one};
        case CellType::inverter:
        case CellType::nor_gate:
            return CountingRule{Logic::one, Logic::zero};
        default:
            return std::nullopt;
    }
}

/// Set wins, as in the cell table.
Logic asked_by_latch(Logic set, Logic reset, Logic held) {
    return set | (held & ~reset);
}

Logic asked_by_hold_latch(Logic data, Logic enable, Logic held) {
    return (data & enable) | (held & ~enable) | (data & held);
}

}  // namespace

Circuit::Circuit(const Netlist& netlist, const std::vector<std::uint8_t>& is_relevant)
    : netlist_(netlist),
      drivers_(netlist.net_count(), none),
      first_reader_(netlist.net_count() + 1),
      number_(netlist.cells.size(), none) {
    std::vector<std::vector<std::uint32_t>> readers(netlist.net_count());
    for (std::uint32_t i = 0; i < netlist.cells.size(); ++i) {
        const Cell& cell = netlist.cells.items()[i];
        if (is_timer(cell.type)) {
            number_[i] = static_cast<std::uint32_t>(timers_.size());
            timers_.push_back(i);
        } else if (is_pulse(cell.type)) {
            number_[i] = static_cast<std::uint32_t>(pulses_.size());
            pulses_.push_back(i);
        }
        if (is_relevant[index_of(cell.output)] == 0) continue;
        cells_.push_back(i);
        drivers_[index_of(cell.output)] = i;
        for (const NetId pin : netlist.pins_of(cell)) {
            std::vector<std::uint32_t>& of_pin = readers[index_of(pin)];
            if (of_pin.empty() || of_pin.back() != i) of_pin.push_back(i);
        }
    }
    for (std::size_t net = 0; net < readers.size(); ++net) {
        first_reader_[net] = readers_.size();
        readers_.insert(readers_.end(), readers[net].begin(), readers[net].end());
    }
    first_reader_.back() = readers_.size();
}

std::vector<std::uint8_t> Circuit::edges_between(const std::vector<Logic>& before,
                                                 const std::vector<Logic>& values) const {
    std::vector<std::uint8_t> edges;
    for (const std::uint32_t cell : pulses_) {
        const std::size_t input = index_of(pins(cell)[0]);
        edges.push_back(0);
        see_edge(cell, before[input], values[input], edges.back());
        if (values[index_of(output(cell))] == Logic::unknown) edges.back() = CircuitState::unclear;
    }
    return edges;
}

Logic Circuit::asked_by_timer(const CircuitState& state, std::uint32_t cell) const {
    const TimerState& timer = state.timers[number_[cell]];
    const Logic shown = state.values[index_of(output(cell))];
    if (timer.run == TimerRun::lost) return Logic::unknown;
    return timer.run == TimerRun::idle ? state.values[index_of(pins(cell)[0])] : shown;
}

Logic Circuit::asked(const CircuitState& state, std::uint32_t cell) const {
    const auto value = [&](NetId net) { return state.values[index_of(net)]; };
    const std::span<const NetId> pin = pins(cell);
    if (const auto rule = counting_rule(type(cell))) {
        Logic result = ~rule->decided;
        for (const NetId net : pin) {
            if (value(net) == rule->controlling) return rule->decided;
            if (value(net) == Logic::unknown) result = Logic::unknown;
        }
        return result;
    }
    const Logic shown = value(output(cell));
    switch (type(cell)) {
        case CellType::low:
            return Logic::zero;
        case CellType::high:
            return Logic::one;
        case CellType::xor_gate: {
            Logic parity = Logic::zero;
            for (const NetId net : pin) parity = parity ^ value(net);
            return parity;
        }
        case CellType::latch:
            return asked_by_latch(value(pin[0]), value(pin[1]), shown);
        case CellType::hold_latch:
            return asked_by_hold_latch(value(pin[0]), value(pin[1]), shown);
        case CellType::timer:
            return asked_by_timer(state, cell);
        case CellType::rise_pulse:
        case CellType::fall_pulse: {
            const bool is_unclear = state.unanswered[number_[cell]] == CircuitState::unclear;
            return is_unclear ? Logic::unknown : shown;
        }
        default:
            return shown;  // cells with a clock: their netlists are not for this
    }
}

void Circuit::lose(std::uint32_t cell, CircuitState& state) const {
    if (type(cell) == CellType::timer) {
        state.timers[number_[cell]] = {TimerRun::lost, Logic::unknown};
    } else {
        state.unanswered[number_[cell]] = CircuitState::unclear;
    }
}

void Circuit::finish_pulse(std::uint32_t cell, CircuitState& state) const {
    if (!is_pulse(type(cell)) || state.unanswered[number_[cell]] == CircuitState::unclear) return;
    state.unanswered[number_[cell]] = 0;
    state.values[index_of(output(cell))] = Logic::zero;
}

NetId Circuit::deciding_pin(const CircuitState& state, std::uint32_t cell, NetId except) const {
    const auto rule = counting_rule(type(cell));
    if (!rule) return no_net;
    NetId found = no_net;
    for (const NetId net : pins(cell)) {
        if (net == except || state.values[index_of(net)] != rule->controlling) continue;
        if (driver(net) == none) return net;
        if (found == no_net) found = net;
    }
    return found;
}

void Circuit::append_actions(const CircuitState& state, std::uint32_t cell,
                             std::vector<CellAction>& actions) const {
    const Logic shown = state.values[index_of(output(cell))];
    if (asked(state, cell) != shown) actions.push_back({cell, CellAction::Kind::take});
    if (!is_pulse(type(cell)) || state.unanswered[number_[cell]] == CircuitState::unclear) return;
    if (state.unanswered[number_[cell]] != 0) actions.push_back({cell, CellAction::Kind::answer});
    if (shown == Logic::one) actions.push_back({cell, CellAction::Kind::end_pulse});
}

std::vector<CellAction> Circuit::actions(const CircuitState& state) const {
    std::vector<CellAction> actions;
    for (const std::uint32_t cell : cells_) append_actions(state, cell, actions);
    return actions;
}

std::vector<CellAction> Circuit::ending_delays(const CircuitState& state) const {
    std::vector<CellAction> actions;
    for (const std::uint32_t cell : timers_) {
        const bool ends = state.timers[number_[cell]].run == TimerRun::ends;
        if (ends && driver(output(cell)) == cell) {
            actions.push_back({cell, CellAction::Kind::end_delay});
        }
    }
    return actions;
}

Time Circuit::length_of(std::size_t timer, const CircuitState& state) const {
    const std::uint32_t cell = timers_[timer];
    const Logic shown = state.values[index_of(output(cell))];
    const Logic operand = state.values[index_of(pins(cell)[0])];
    const bool rises = operand == Logic::one || (operand != Logic::zero && shown == Logic::zero);
    const Timing& timing = netlist_.timings[netlist_.cells.items()[cell].timing];
    return rises ? timing.rise : timing.fall;
}

/// What becomes of the delay once the operand or, `by_itself`, the output has changed.
void Circuit::update_timer(std::uint32_t cell, CircuitState& state, bool by_itself) const {
    TimerState& timer = state.timers[number_[cell]];
    const Logic shown = state.values[index_of(output(cell))];
    const Logic operand = state.values[index_of(pins(cell)[0])];
    if (timer.run == TimerRun::lost && !by_itself) return;
    const bool runs = timer.run != TimerRun::idle && timer.run != TimerRun::lost;
    if (operand == shown || length_of(number_[cell], state) == 0) {
        timer = {};
    } else if (!runs) {
        timer = {TimerRun::begun, operand};
    } else if (timer.towards == operand) {
        // It goes on.
    } else if (operand == Logic::unknown && shown != Logic::unknown) {
        timer.towards = operand;
    } else if (timer.towards == Logic::unknown && timer.run != TimerRun::begun) {
        timer = {TimerRun::lost, operand};  // it may have begun now, or before
    } else {
        timer = {TimerRun::begun, operand};
    }
}

void Circuit::see_edge(std::uint32_t cell, Logic from, Logic to, std::uint8_t& unanswered) const {
    if (from == Logic::unknown || to == Logic::unknown) {
        unanswered = CircuitState::unclear;
    } else if (from != to && to == logic_of(type(cell) == CellType::rise_pulse)) {
        unanswered = std::min<std::uint8_t>(CircuitState::unclear, unanswered + 1);
    }
}

void Circuit::set_net(NetId net, Logic value, CircuitState& state) const {
    const Logic from = state.values[index_of(net)];
    if (from == value) return;
    state.values[index_of(net)] = value;
    for (const std::uint32_t reader : readers(net)) {
        if (type(reader) == CellType::timer) update_timer(reader, state, false);
        if (is_pulse(type(reader))) {
            see_edge(reader, from, value, state.unanswered[number_[reader]]);
        }
    }
}

void Circuit::set_output(std::uint32_t cell, Logic value, CircuitState& state) const {
    set_net(output(cell), value, state);
    if (type(cell) == CellType::timer) update_timer(cell, state, true);
}

void Circuit::perform(std::span<const CellAction> actions, CircuitState& state) const {
    std::vector<Logic> values;
    for (const CellAction& action : actions) {
        switch (action.kind) {
            case CellAction::Kind::take:
                values.push_back(asked(state, action.cell));
                break;
            case CellAction::Kind::answer:
                --state.unanswered[number_[action.cell]];
                values.push_back(Logic::one);
                break;
            case CellAction::Kind::end_pulse:
                values.push_back(Logic::zero);
                break;
            case CellAction::Kind::end_delay:
                values.push_back(state.timers[number_[action.cell]].towards);
                break;
        }
    }
    for (std::size_t i = 0; i < actions.size(); ++i) set_output(actions[i].cell, values[i], state);
}

namespace {

/// Numbers of a few bits each, in a text.
class BitWriter {
  public:
    explicit BitWriter(std::string& text) : text_(text) {}
    void add(unsigned number, unsigned bits) {
        buffer_ |= number << used_;
        used_ += bits;
        while (used_ >= 8) flush();
    }
    void finish() {
        if (used_ != 0) flush();
    }

  private:
    void flush() {
        text_ += static_cast<char>(buffer_ & 0xffU);
        buffer_ >>= 8U;
        used_ = used_ > 8 ? used_ - 8 : 0;
    }
    std::string& text_;
    unsigned buffer_ = 0;
    unsigned used_ = 0;
};

class BitReader {
  public:
    explicit BitReader(std::string_view text) : text_(text) {}
    unsigned next(unsigned bits) {
        while (held_ < bits) {
            buffer_ |= static_cast<unsigned>(static_cast<unsigned char>(text_[at_++])) << held_;
            held_ += 8;
        }
        const unsigned number = buffer_ & ((1U << bits) - 1U);
        buffer_ >>= bits;
        held_ -= bits;
        return number;
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    unsigned buffer_ = 0;
    unsigned held_ = 0;
};

}  // namespace

std::string Circuit::encoded(const CircuitState& state) const {
    std::string text;
    text.reserve((2 * cells_.size() + 5 * timers_.size() + 3 * pulses_.size()) / 8 + 1);
    BitWriter writer(text);
    for (const std::uint32_t cell : cells_) {
        writer.add(static_cast<unsigned>(state.values[index_of(output(cell))]), 2);
    }
    for (const TimerState& timer : state.timers) {
        writer.add(static_cast<unsigned>(timer.run), 3);
        writer.add(static_cast<unsigned>(timer.towards), 2);
    }
    for (const std::uint8_t unanswered : state.unanswered) writer.add(unanswered, 3);
    writer.finish();
    return text;
}

void Circuit::decode(std::string_view encoding, CircuitState& like) const {
    BitReader reader(encoding);
    for (const std::uint32_t cell : cells_) {
        like.values[index_of(output(cell))] = static_cast<Logic>(reader.next(2));
    }
    for (TimerState& timer : like.timers) {
        timer.run = static_cast<TimerRun>(reader.next(3));
        timer.towards = static_cast<Logic>(reader.next(2));
    }
    for (std::uint8_t& unanswered : like.unanswered) {
        unanswered = static_cast<std::uint8_t>(reader.next(3));
    }
}

}  // namespace grafwire
