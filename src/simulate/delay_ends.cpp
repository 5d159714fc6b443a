// When a delay ends, inputs may change as well. The reference reads the operand
// of the time condition under the new inputs, on the situation as it was, and lets the delay end or
// not; only then does it evolve. Gates have no such order: an input that falls at that time makes
// its way to the timer in a few nanoseconds. So the operand is worked out here, beside the
// simulation: from the inputs as they are now and the memories as they are, through the logic in
// between. A memory is a cell that has one, or a net on a loop of gates (cells_on_loops), which is
// one.
//
// A clocked netlist works the operand out on the situation to come, which the registers take at the
// rise of the clock. At the beginning of an instant that is the situation they hold.
//
// A timer whose operand is read by another's has to come first, as the outer one reads it after its
// delay has ended.

#include "simulate/delay_ends.h"

#include "netlist/netlist.h"
#include "simulate/evaluate_cell.h"

namespace grafwire {

namespace {

constexpr std::uint32_t not_a_timer = 0xffffffffU;

}  // namespace

DelayEnds::DelayEnds(const Netlist& netlist) : netlist_(netlist) {
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        if (is_timer(netlist.cells.items()[i].type)) timers_.push_back(netlist.cells.id_at(i));
    }
    if (timers_.empty()) return;
    drivers_ = drivers_of(netlist);
    is_held_ = cells_on_loops(netlist);
    values_.resize(netlist.net_count(), unread);
    register_of_.resize(netlist.net_count(), no_net);
    if (netlist.is_clocked()) find_registers();
    number_of_timer_.resize(netlist.cells.size(), not_a_timer);
    for (std::uint32_t i = 0; i < timers_.size(); ++i) number_of_timer_[index_of(timers_[i])] = i;
    std::vector<std::uint8_t> seen(netlist.net_count());
    for (const CellId timer : timers_) add_timers_before(netlist.cells[timer].output, seen);
}

void DelayEnds::find_registers() {
    std::vector<std::uint8_t> is_shown(netlist_.net_count());
    for (const Port& port : netlist_.outputs) is_shown[index_of(port.net)] = 1;
    for (const std::vector<Observed>* observed : {&netlist_.vars, &netlist_.counters}) {
        for (const Observed& item : *observed) {
            for (const NetId bit : item.bits) {
                if (bit != no_net) is_shown[index_of(bit)] = 1;
            }
        }
    }
    for (const Cell& cell : netlist_.cells) {
        if (cell.type != CellType::flip_flop || is_shown[index_of(cell.output)] == 0) continue;
        register_of_[index_of(netlist_.pins_of(cell)[0])] = cell.output;
    }
    hold_edges();
}

/// Edges are worked out in the scans of an instant. At its beginning there are none, as in the
/// reference: the logic that compares an operand with its memory is held.
void DelayEnds::hold_edges() {
    const auto is_edge = [&](CellId cell) {
        return netlist_.origin_of(netlist_.cells[cell]).kind == Origin::Kind::edge;
    };
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        if (!is_edge(netlist_.cells.id_at(i))) continue;
        for (const NetId pin : netlist_.pins_of(netlist_.cells.items()[i])) {
            const CellId driver = drivers_[pin];
            if (driver == no_cell || !is_edge(driver)) continue;
            if (netlist_.cells[driver].type == CellType::flip_flop) is_held_[i] = 1;
        }
    }
}

/// Appends to the order the timers that a net depends on without a memory in between, the one that
/// drives it included, those deeper inside first.
void DelayEnds::add_timers_before(NetId net, std::vector<std::uint8_t>& seen) {
    struct Visit {
        NetId net;
        bool left;  ///< what is before the net has been visited
    };
    std::vector<Visit> visits{{net, false}};
    while (!visits.empty()) {
        const Visit visit = visits.back();
        visits.pop_back();
        const CellId driver = drivers_[visit.net];
        if (driver == no_cell) continue;
        const std::uint32_t timer = number_of_timer_[index_of(driver)];
        if (visit.left) {
            order_.push_back(timer);
            continue;
        }
        if (seen[index_of(visit.net)] != 0) continue;
        seen[index_of(visit.net)] = 1;
        const Cell& cell = netlist_.cells[driver];
        if (timer != not_a_timer) {
            visits.push_back({visit.net, true});
            visits.push_back({netlist_.pins_of(cell)[0], false});
            if (cell.type == CellType::scan_timer_next) {
                visits.push_back({netlist_.pins_of(cell)[1], false});
            }
        } else if (!row_of(cell.type).has_memory) {
            for (const NetId pin : netlist_.pins_of(cell)) visits.push_back({pin, false});
        }
    }
}

bool DelayEnds::keeps_value(CellId cell) const {
    const CellType type = netlist_.cells[cell].type;
    const bool is_logic = is_gate(type) || type == CellType::xor_gate;
    return !is_logic || is_held_[index_of(cell)] != 0;
}

/// Of a gate all of whose pins have been worked out.
Logic DelayEnds::gate_output(const Cell& cell) const {
    CellWord word = cell.type == CellType::xor_gate ? 0 : table_of(cell.type);
    const Logic controlling = gate_rule(cell.type).controlling_value;
    for (const NetId pin : netlist_.pins_of(cell)) {
        word += contribution(controlling, static_cast<Logic>(values_[index_of(pin)]));
    }
    return cell.type == CellType::xor_gate ? xor_value(word) : static_cast<Logic>(look_up(word));
}

/// The net that holds what a memory has: of a look-ahead, which has none of its own, its timer's.
NetId DelayEnds::shown_by(NetId net) const {
    const CellId driver = drivers_[net];
    if (driver == no_cell || netlist_.cells[driver].type != CellType::scan_timer_next) return net;
    return netlist_.pins_of(netlist_.cells[driver])[1];
}

/// The value that a net is about to have while every memory holds what it has.
Logic DelayEnds::read(const Simulator& simulator, NetId net) {
    waiting_.assign(1, net);
    while (!waiting_.empty()) {
        const NetId next = waiting_.back();
        std::uint8_t& value = values_[index_of(next)];
        const CellId driver = drivers_[next];
        if (value == unread && register_of_[index_of(next)] != no_net && driver != no_cell) {
            value = static_cast<std::uint8_t>(simulator.value(register_of_[index_of(next)]));
            worked_out_.push_back(next);
        } else if (value == unread && driver != no_cell && !keeps_value(driver)) {
            const std::size_t before = waiting_.size();
            for (const NetId pin : netlist_.pins_of(netlist_.cells[driver])) {
                if (values_[index_of(pin)] == unread) waiting_.push_back(pin);
            }
            if (waiting_.size() > before) continue;
            value = static_cast<std::uint8_t>(gate_output(netlist_.cells[driver]));
            worked_out_.push_back(next);
        } else if (value == unread) {
            value = static_cast<std::uint8_t>(simulator.value(shown_by(next)));
            worked_out_.push_back(next);
        }
        waiting_.pop_back();
    }
    const auto value = static_cast<Logic>(values_[index_of(net)]);
    for (const NetId worked : worked_out_) values_[index_of(worked)] = unread;
    worked_out_.clear();
    return value;
}

bool DelayEnds::take_effect(Simulator& simulator, Time now) {
    bool any = false;
    if (simulator.next_due() > now) return any;
    for (const std::uint32_t timer : order_) {
        if (simulator.due(timer) > now) continue;
        const Cell& cell = netlist_.cells[timers_[timer]];
        const auto pins = netlist_.pins_of(cell);
        const Logic operand = read(simulator, pins[0]);
        // A look-ahead knows what its timer has taken.
        const bool looks_ahead = cell.type == CellType::scan_timer_next;
        const Logic taken = simulator.value(looks_ahead ? pins[1] : cell.output);
        if (operand == taken && operand != Logic::unknown) continue;
        const bool is_open = looks_ahead && taken == Logic::unknown;
        any = simulator.end_delay(timer, is_open ? Logic::unknown : operand) || any;
    }
    return any;
}

Settling DelayEnds::settle(Simulator& simulator, Time now) {
    Settling sum = simulator.settle();
    while (sum.settled && take_effect(simulator, now)) {
        Settling more = simulator.settle();
        more.events += sum.events;
        sum = std::move(more);
    }
    return sum;
}

}  // namespace grafwire
