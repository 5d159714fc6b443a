// The first pass of ternary simulation (E. B. Eichelberger, "Hazard detection in combinational and
// sequential switching circuits", IBM J. Res. Dev. 9, 1965): every gate that may be excited becomes
// unknown beside what it was, until no more do. Then every value that a net can have on the way, in
// any order of firings, single or joint, is one that the state allows. It takes as many steps as
// there are gates, where going through the orders may take exponentially many.

#include "settling/reach.h"

namespace grafwire {

Reach::Reach(const Circuit& circuit)
    : circuit_(circuit), is_unclear_(circuit.netlist().cells.size()) {}

/// What timers and pulse cells make of a net that can have either value is not known.
void Reach::open(NetId net) {
    state_.values[index_of(net)] = Logic::unknown;
    for (const std::uint32_t reader : circuit_.readers(net)) {
        const CellType type = circuit_.type(reader);
        if ((type == CellType::timer || is_pulse(type)) && is_unclear_[reader] == 0) {
            is_unclear_[reader] = 1;
            unclear_.push_back(reader);
        }
        waiting_.push_back(reader);
    }
}

void Reach::make(const CircuitState& state, std::span<const std::uint32_t> excited,
                 const std::vector<std::uint8_t>& held) {
    state_ = state;
    for (const std::uint32_t cell : unclear_) is_unclear_[cell] = 0;
    unclear_.clear();
    // One that is unknown may become known.
    for (const std::uint32_t cell : circuit_.cells()) {
        if (held[cell] == 0 && is_open(circuit_.output(cell))) open(circuit_.output(cell));
    }
    for (const std::uint32_t cell : excited) {
        const NetId net = circuit_.output(cell);
        if (held[cell] == 0 && !is_open(net)) open(net);
    }
    while (!waiting_.empty()) {
        const std::uint32_t cell = waiting_.back();
        waiting_.pop_back();
        const NetId net = circuit_.output(cell);
        if (held[cell] != 0 || is_open(net)) continue;
        const bool is_excited = circuit_.asked(state_, cell) != state_.values[index_of(net)];
        if (is_excited || is_unclear_[cell] != 0) open(net);
    }
}

}  // namespace grafwire
