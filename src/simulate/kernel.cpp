// A netlist made ready for simulation, and what is done to a simulation from outside: powering up,
// setting and holding nets, moving the clock, saving and restoring.
//
// Of the netlist no more is kept than the simulation touches, by number of the net in arrays of
// their own: a word per node (evaluate_cell.h), and who reads it. Time is counted in ticks of the
// greatest common divisor of all delays. If that is every delay, two lists take the place of the
// timing wheel (run_kernel.cpp).

#include "simulate/kernel.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace grafwire {

Simulator::Kernel::Kernel(const Netlist& netlist, const CellDelays& delays,
                          const DelaySchedule& schedule) {
    const std::size_t count = netlist.net_count();
    assert(count < (std::size_t{1} << 30U));
    assert(delays.rise.size() == netlist.cells.size());
    assert(delays.fall.size() == netlist.cells.size());
    words_.resize(count, undriven_flag);
    readers_.resize(count);
    values_.resize(count, Logic::unknown);
    types_.resize(count, CellType::buffer);
    memory_of_.resize(count, no_memory);
    touched_.items.resize(count + 1);
    choose_tick(netlist, delays, schedule);
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        add_cell(netlist, delays, netlist.cells.id_at(i));
    }
    for (const Netlist::InitialValue& initial : netlist.initial_values) {
        held_at_power_up_.emplace_back(static_cast<std::uint32_t>(initial.net),
                                       logic_of(initial.value));
    }
    if (netlist.is_clocked()) clock_ = static_cast<std::uint32_t>(netlist.clock);
    link_readers(netlist);
    add_schedule(netlist, delays, schedule);
    power_up();
}

void Simulator::Kernel::choose_tick(const Netlist& netlist, const CellDelays& delays,
                                    const DelaySchedule& schedule) {
    Time tick = 0;
    Time longest = 0;
    const auto include = [&](Time delay) {
        assert(delay > 0);
        if (delay != tick) tick = std::gcd(tick, delay);
        longest = std::max(longest, delay);
    };
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        include(delays.rise[i]);
        include(delays.fall[i]);
    }
    for (const DelayChange& change : schedule.changes) {
        include(change.rise);
        include(change.fall);
    }
    const Time longest_gate = longest;
    for (const Cell& cell : netlist.cells) {
        if (grafwire::is_pulse(cell.type) && netlist.timings[cell.timing].fall > 0) {
            include(netlist.timings[cell.timing].fall);
        }
    }
    for (const DelayChange& change : schedule.changes) {
        if (change.width > 0) include(change.width);
    }
    if (tick != 0) tick_length_ = tick;
    uniform_ = longest_gate <= tick_length_ && schedule.changes.empty();
    if (uniform_) {
        current_.items.resize(netlist.net_count() + spare_entries);
        next_.items.resize(netlist.net_count() + spare_entries);
    } else {
        timings_.resize(netlist.net_count());
        wheel_ = EventWheel(longest_gate / tick_length_);
    }
}

void Simulator::Kernel::add_cell(const Netlist& netlist, const CellDelays& delays, CellId id) {
    const Cell& cell = netlist.cells[id];
    const auto net = static_cast<std::uint32_t>(cell.output);
    assert(cell.pin_count <= most_pins);
    types_[net] = cell.type;
    words_[net] = is_gate(cell.type) ? table_of(cell.type) : special_flag;
    if (!uniform_) {
        timings_[net].rise = delays.rise[index_of(id)] / tick_length_;
        timings_[net].fall = delays.fall[index_of(id)] / tick_length_;
    }
    if (!is_gate(cell.type) && cell.type != CellType::xor_gate) add_memory(netlist, delays, id);
    if (row_of(cell.type).has_memory) held_at_power_up_.emplace_back(net, cell.initial);
}

void Simulator::Kernel::add_memory(const Netlist& netlist, const CellDelays& delays, CellId id) {
    const Cell& cell = netlist.cells[id];
    const auto pins = netlist.pins_of(cell);
    MemoryCell memory;
    memory.node = static_cast<std::uint32_t>(cell.output);
    memory.data = static_cast<std::uint32_t>(pins.front());
    memory.control = static_cast<std::uint32_t>(pins.back());
    const auto number = static_cast<std::uint32_t>(memories_.size());
    if (grafwire::is_pulse(cell.type)) {
        Pulse pulse;
        pulse.memory = number;
        pulse.delay = delays.rise[index_of(id)] / tick_length_;
        pulse.width = netlist.timings[cell.timing].fall / tick_length_;
        memory.detail = static_cast<std::uint32_t>(pulses_.size());
        pulses_.push_back(std::move(pulse));
        held_at_power_up_.emplace_back(memory.node, Logic::zero);
    }
    if (cell.type == CellType::scan_timer_next) {
        memory.held = static_cast<std::uint32_t>(pins[1]);
        look_ahead_nodes_.push_back(memory.node);
    }
    if (is_timer(cell.type)) {
        memory.detail = static_cast<std::uint32_t>(timer_cells_.size());
        timer_cells_.push_back(id);
        timer_nodes_.push_back(memory.node);
        rise_delays_.push_back(netlist.timings[cell.timing].rise);
        fall_delays_.push_back(netlist.timings[cell.timing].fall);
        due_.push_back(never);
        towards_.push_back(Logic::unknown);
    }
    memory_of_[memory.node] = number;
    memories_.push_back(memory);
}

void Simulator::Kernel::add_schedule(const Netlist& netlist, const CellDelays& delays,
                                     const DelaySchedule& schedule) {
    const auto add = [&](Time at, CellId cell, Time rise, Time fall, Time width) {
        schedule_.push_back({at, static_cast<std::uint32_t>(netlist.cells[cell].output),
                             rise / tick_length_, fall / tick_length_, width / tick_length_});
    };
    for (const DelayChange& change : schedule.changes) {
        const Cell& cell = netlist.cells[change.cell];
        const std::size_t index = index_of(change.cell);
        add(0, change.cell, delays.rise[index], delays.fall[index],
            grafwire::is_pulse(cell.type) ? netlist.timings[cell.timing].fall : 0);
    }
    for (const DelayChange& change : schedule.changes) {
        add(std::max<Time>(change.at, 0), change.cell, change.rise, change.fall, change.width);
    }
}

void Simulator::Kernel::link_readers(const Netlist& netlist) {
    std::vector<std::uint32_t> first(netlist.net_count() + 1, 0);
    for (const Cell& cell : netlist.cells) {
        for (const NetId pin : netlist.pins_of(cell)) ++first[index_of(pin) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> readers(first.back());
    std::vector<std::uint32_t> filled(first.begin(), first.end() - 1);
    for (const Cell& cell : netlist.cells) {
        const std::uint32_t entry =
            2 * static_cast<std::uint32_t>(cell.output) +
            static_cast<std::uint32_t>(gate_rule(cell.type).controlling_value);
        for (const NetId pin : netlist.pins_of(cell)) readers[filled[index_of(pin)]++] = entry;
    }
    for (std::size_t net = 0; net < readers_.size(); ++net) {
        Readers& own = readers_[net];
        const auto begin = readers.begin() + first[net];
        own.count = first[net + 1] - first[net];
        if (own.count <= own.readers.size()) {
            std::copy_n(begin, own.count, own.readers.begin());
        } else {
            own.readers[0] = static_cast<std::uint32_t>(more_readers_.size());
            more_readers_.insert(more_readers_.end(), begin, begin + own.count);
            own.readers[1] = static_cast<std::uint32_t>(more_readers_.size());
        }
    }
}

void Simulator::Kernel::power_up() {
    drop_all_pending();
    for (const std::uint32_t net : forced_) release(net);
    forced_.clear();
    tick_ = 0;
    origin_ = 0;
    instant_ = 0;
    std::fill(values_.begin(), values_.end(), Logic::unknown);
    for (const auto& [net, value] : held_at_power_up_) values_[net] = value;
    for (CellWord& word : words_) word &= ~all_pins;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        const auto net = static_cast<std::uint32_t>(i);
        words_[net] = with_value(words_[net], values_[net]);
        for_each_reader(net, [&](std::uint32_t reader) {
            words_[reader >> 1U] += contribution(static_cast<Logic>(reader & 1U), values_[net]);
        });
        if ((words_[net] & undriven_flag) == 0) touch(net);
    }
    std::fill(due_.begin(), due_.end(), never);
    std::fill(towards_.begin(), towards_.end(), Logic::zero);
    begin_schedule(0);
    look_at_pins();
}

/// The delays are those of that moment.
void Simulator::Kernel::begin_schedule(Time until) {
    next_delays_ = 0;
    take_delays(until);
}

void Simulator::Kernel::take_delays(Time until) {
    while (next_delays_ < schedule_.size() && schedule_[next_delays_].at <= until) {
        const NodeDelays& delays = schedule_[next_delays_];
        timings_[delays.node].rise = delays.rise;
        timings_[delays.node].fall = delays.fall;
        if (is_pulse(delays.node)) {
            Pulse& pulse = pulse_of(delays.node);
            pulse.delay = delays.rise;
            if (delays.width > 0) pulse.width = delays.width;
        }
        ++next_delays_;
    }
    next_delays_at_ = next_delays_ < schedule_.size() ? schedule_[next_delays_].at : never;
}

/// Cells with pins of meaning take what they see for what has always been, and no pulse is running
/// but those of which nothing is known.
void Simulator::Kernel::look_at_pins() {
    for (MemoryCell& cell : memories_) {
        if (!(pulses_held_ && pulses_remember_)) cell.data_seen = values_[cell.data];
        cell.control_seen = values_[cell.control];
        cell.held_seen = values_[cell.held];
    }
    for (Pulse& pulse : pulses_) look_at_pulse_input(pulse);
}

void Simulator::Kernel::begin_instant(Time at) {
    instant_ = at;
    if (!is_live() && at > now()) origin_ = at - tick_ * tick_length_;
    for (const std::uint32_t net : look_ahead_nodes_) touch(net);
}

void Simulator::Kernel::restart_clock() {
    if (is_live()) return;
    origin_ = -tick_ * tick_length_;
    instant_ = 0;
}

void Simulator::Kernel::set_input(std::uint32_t net, Logic value) {
    change_now(net, value);
}

void Simulator::Kernel::force(std::uint32_t net, Logic value) {
    drop_pending(net);
    change_now(net, value);
    if ((words_[net] & forced_flag) == 0) forced_.push_back(net);
    words_[net] |= forced_flag | special_flag;
}

void Simulator::Kernel::release(std::uint32_t net) {
    words_[net] &= ~forced_flag;
    const bool is_driven = (words_[net] & undriven_flag) == 0;
    if (is_driven && is_gate(types_[net])) words_[net] &= ~special_flag;
}

void Simulator::Kernel::release_all() {
    for (const std::uint32_t net : forced_) {
        release(net);
        if ((words_[net] & undriven_flag) == 0) touch(net);
    }
    forced_.clear();
}

Settling Simulator::Kernel::set_clock(Logic level) {
    Settling before = settle();
    if (!before.settled || clock_ == no_memory) return before;
    ++tick_;
    set_input(clock_, level);
    Settling after = settle();
    after.events += before.events;
    return after;
}

Settling Simulator::Kernel::clock_cycle() {
    Settling rise = set_clock(Logic::one);
    if (!rise.settled) return rise;
    Settling fall = set_clock(Logic::zero);
    fall.events += rise.events;
    return fall;
}

Time Simulator::Kernel::next_due() const {
    const auto first = std::min_element(due_.begin(), due_.end());
    return first == due_.end() ? never : *first;
}

bool Simulator::Kernel::end_delay(std::size_t timer, Logic operand) {
    const bool ran_for_another = operand != Logic::unknown && operand == ~towards_[timer];
    if (!is_running(timer) || ran_for_another) return false;
    const std::uint32_t net = timer_nodes_[timer];
    const Logic taken = agreed(towards_[timer], operand);
    due_[timer] = never;
    touch(net);
    if (types_[net] == CellType::scan_timer_next) {
        towards_[timer] = taken;  // shows what its timer does; unknown: the delay is lost
        return true;
    }
    drop_pending(net);
    change_now(net, taken);
    return true;
}

void Simulator::Kernel::restore(const SimulatorState& state) {
    assert(state.values.size() == values_.size());
    for (std::size_t net = 0; net < values_.size(); ++net) {
        if (values_[net] == state.values[net]) continue;
        change_unseen(static_cast<std::uint32_t>(net), state.values[net]);
    }
    drop_all_pending();
    due_ = state.due;
    towards_ = state.towards;
    origin_ = state.now - tick_ * tick_length_;
    instant_ = state.now;
    pulses_remember_ = false;
    begin_schedule(state.now);
    look_at_pins();
}

}  // namespace grafwire
