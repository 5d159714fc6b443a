// Stubborn sets (stubborn_sets.cpp) where firings have times: the times of different corners of a
// netlist need not be compared, if the excited cells of a set are compared with one another.
// Whatever depends on a firing of the set is excited in it now, or will be by a later firing of the
// set, and so comes later. (Independent parts of a timed system with clocks of their own: J.
// Bengtsson, B. Jonsson, J. Lilius, W. Yi, "Partial order reductions for timed systems", CONCUR
// 1998, LNCS 1466.)
//
// So a set is closed over what reads and drives what, whenever that may be. What has to be in it,
// beginning with one excited cell:
//
// - For an excited cell, whatever could change what its inputs ask for. If one pin decides by
//   itself (a 0 at a NAND) that is the driver of this pin alone, since nothing else matters while
//   it stays.
// - For an excited cell, the cells that read its output, as they may be changed by its firing. Not
//   those for which another pin decides whose driver is quiet: that driver is taken in instead.
// - For a quiet cell, whatever has to change first to wake it: the driver of a deciding pin, else
//   of any pin.
// - When a gate becomes excited by several inputs, it is so from the last of them on; for the last
//   one tried to be the last in time, cells with a common reader belong together.
//
// Cells that nothing can make fire from this state on (reach.h) are left out: the circuit is the
// same without them, with what they show as constants.

#include "settling/timed_stubborn_sets.h"

namespace grafwire {

/// Whether a cell never fires from the state at hand on.
bool TimedStubbornSets::is_fixed(std::uint32_t cell) const {
    return is_excited_[cell] == 0 && !reach_.is_open(circuit_.output(cell));
}

void TimedStubbornSets::add_moving(std::uint32_t cell) {
    if (cell != Circuit::none && !is_fixed(cell)) add(cell);
}

void TimedStubbornSets::add_driver(NetId net) {
    add_moving(circuit_.driver(net));
}

/// What could change that the cell is excited, or quiet.
void TimedStubbornSets::add_inputs(const CircuitState& state, std::uint32_t cell) {
    if (circuit_.deciding_pin(reach_.state(), cell, no_net) != no_net) return;
    const NetId deciding = circuit_.deciding_pin(state, cell, no_net);
    if (deciding != no_net) {
        add_driver(deciding);
    } else {
        for (const NetId pin : circuit_.pins(cell)) add_driver(pin);
    }
}

/// What the firing of the cell could change.
void TimedStubbornSets::add_readers(const CircuitState& state, std::uint32_t cell) {
    const NetId output = circuit_.output(cell);
    for (const std::uint32_t reader : circuit_.readers(output)) {
        if (is_fixed(reader)) continue;
        if (circuit_.deciding_pin(reach_.state(), reader, output) != no_net) continue;
        const NetId deciding = circuit_.deciding_pin(state, reader, output);
        const std::uint32_t driver = deciding == no_net ? Circuit::none : circuit_.driver(deciding);
        if (deciding == no_net || (driver != Circuit::none && is_excited_[driver] != 0)) {
            add_moving(reader);
            for (const NetId pin : circuit_.pins(reader)) add_driver(pin);
        } else {
            add_moving(driver);
        }
    }
}

std::size_t TimedStubbornSets::close(const CircuitState& state, std::size_t most) {
    std::size_t excited = 0;
    for (std::size_t next = 0; next < set_.size(); ++next) {
        const std::uint32_t cell = set_[next];
        add_inputs(state, cell);
        if (is_excited_[cell] == 0) continue;
        if (++excited > most) return excited;
        add_readers(state, cell);
    }
    return excited;
}

}  // namespace grafwire
