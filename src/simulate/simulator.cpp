#include "simulate/simulator.h"

#include <algorithm>
#include <cassert>

#include "simulate/kernel.h"

namespace grafwire {

CellDelays unit_delays(const Netlist& netlist) {
    return {std::vector<Time>(netlist.cells.size(), nanosecond),
            std::vector<Time>(netlist.cells.size(), nanosecond)};
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
    look_at_pins();
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
    if (!is_live() && at > now()) origin_ = at - tick_ * slot_;
    for (const std::uint32_t net : look_ahead_nodes_) touch(net);
}

void Simulator::Kernel::restart_clock() {
    assert(!is_live());
    origin_ = -tick_ * slot_;
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
    origin_ = state.now - tick_ * slot_;
    instant_ = state.now;
    pulses_remember_ = false;
    look_at_pins();
}

Simulator::Simulator(const Netlist& netlist, const CellDelays& delays)
    : kernel_(std::make_unique<Kernel>(netlist, delays)) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

void Simulator::power_up() {
    kernel_->power_up();
}
void Simulator::begin_instant(Time at) {
    kernel_->begin_instant(at);
}
void Simulator::restart_clock() {
    kernel_->restart_clock();
}
void Simulator::set_input(NetId input, Logic value) {
    kernel_->set_input(static_cast<std::uint32_t>(input), value);
}
void Simulator::hold_pulses(bool on) {
    kernel_->hold_pulses(on);
}
void Simulator::remember_pulse_inputs() {
    kernel_->remember_pulse_inputs();
}
void Simulator::force(NetId net, Logic value) {
    kernel_->force(static_cast<std::uint32_t>(net), value);
}
void Simulator::release_all() {
    kernel_->release_all();
}
Settling Simulator::settle() {
    return kernel_->settle();
}
Settling Simulator::set_clock(Logic level) {
    return kernel_->set_clock(level);
}
Settling Simulator::clock_cycle() {
    return kernel_->clock_cycle();
}
const std::vector<CellId>& Simulator::timers() const {
    return kernel_->timer_cells();
}
bool Simulator::is_running(std::size_t timer) const {
    return kernel_->is_running(timer);
}
Time Simulator::next_due() const {
    return kernel_->next_due();
}
Time Simulator::due(std::size_t timer) const {
    return kernel_->due(timer);
}
bool Simulator::end_delay(std::size_t timer, Logic operand) {
    return kernel_->end_delay(timer, operand);
}
Logic Simulator::value(NetId net) const {
    return kernel_->value(static_cast<std::uint32_t>(net));
}
Time Simulator::now() const {
    return kernel_->now();
}
SimulatorState Simulator::save() const {
    return kernel_->save();
}
void Simulator::restore(const SimulatorState& state) {
    kernel_->restore(state);
}
void Simulator::ask(KeepGoing keep_going) {
    kernel_->ask(std::move(keep_going));
}
void Simulator::observe(Observer observer) {
    kernel_->observe(std::move(observer));
}

}  // namespace grafwire
