// The simulator as its users see it. The kernel behind it (kernel.h) is kept out of their sight:
// its header is all arrays and templates, and numbers nets where users name them by NetId.

#include "simulate/simulator.h"

#include "simulate/kernel.h"

namespace grafwire {

Simulator::Simulator(const Netlist& netlist, const CellDelays& delays,
                     const DelaySchedule& schedule)
    : kernel_(std::make_unique<Kernel>(netlist, delays, schedule)) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;

void Simulator::power_up() {
    kernel_->power_up();
}
void Simulator::begin_instant(Time at) {
    kernel_->begin_instant(at);
}
void Simulator::set_input(NetId input, Logic value) {
    kernel_->set_input(static_cast<std::uint32_t>(input), value);
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

Preparation::Preparation(Simulator& simulator) : kernel_(*simulator.kernel_) {
    kernel_.hold_pulses();
}
Preparation::~Preparation() {
    kernel_.release_all();
    kernel_.release_pulses();
    kernel_.restart_clock();
}
void Preparation::hold(NetId net, Logic value) {
    kernel_.force(static_cast<std::uint32_t>(net), value);
}
void Preparation::release() {
    kernel_.release_all();
}
void Preparation::power_up_again() {
    kernel_.remember_pulse_inputs();
    kernel_.power_up();
}

}  // namespace grafwire
