// Which firings have to be tried in a state: stubborn sets (A. Valmari, "Stubborn sets for reduced
// state space generation", Advances in Petri Nets 1990, LNCS 483).
//
// Gates in different corners of a netlist change in any order, and all orders lead to the same. A
// set of cells is *stubborn* in a state if nothing that cells outside of it do can keep its excited
// cells from firing, change what they fire to, or wake its quiet cells. Then it is enough to try
// the excited cells of the set: every way to rest that begins otherwise can be rearranged so that
// one of these comes first. So all states of rest are found, and an endless run if there is any at
// all (that paper, on strong stubborn sets). What may be lost is whether there is one that is fair,
// in which no gate is excited for ever; any_order.cpp asks again where that matters.
//
// What has to be in the set, beginning with one excited cell:
//
// - For an excited cell, whatever could change what its inputs ask for. If one pin decides by
// itself
//   (a 0 at a NAND) that is the driver of this pin alone, since nothing else matters while it
//   stays.
// - For an excited cell, the cells that read its output, as they may be changed by its firing. Not
//   those for which another pin decides whose driver is quiet: that driver is taken in instead.
// - For a quiet cell, whatever has to change first to wake it: the driver of a deciding pin, else
//   of any pin.
//
// Several gates may change at the very same moment (the general multiple-winner model: J. A.
// Brzozowski, C.-J. H. Seger, "Asynchronous Circuits", 1995, chapter 6). That leads elsewhere than
// one after the other only if each of them would keep one of the others from firing: where a gate
// of a joint firing is still excited after all others have fired, it can as well be the last. So
// joint firings are tried of those sets of gates alone in which every gate is quietened by the
// others. In such a set each gate reads another one of it, which leaves the two halves of a latch,
// and little else. By the first rule the quietening gates of a member are in the stubborn set too.
//
// Where firings have times (timed_order.cpp), the times of different corners need not be compared,
// if the excited cells of a set are compared with one another: whatever depends on a firing of the
// set is excited in it now, or will be by a later firing of the set, and so comes later. One more
// thing has to be in the set then. When a gate becomes excited by several inputs, it is so from the
// last of them on; for the last one tried to be the last in time, cells with a common reader belong
// together. (Independent parts of a timed system with clocks of their own: J. Bengtsson, B.
// Jonsson, J. Lilius, W. Yi, "Partial order reductions for timed systems", CONCUR 1998, LNCS 1466.)

#include "settling/stubborn_sets.h"

#include <algorithm>

namespace grafwire {

namespace {

constexpr std::size_t most_gates_of_joint_firing = 12;

}  // namespace

StubbornSets::StubbornSets(const Circuit& circuit, bool in_time)
    : circuit_(circuit),
      in_time_(in_time),
      is_excited_(circuit.netlist().cells.size()),
      is_in_(circuit.netlist().cells.size()) {}

void StubbornSets::add(std::uint32_t cell) {
    if (cell == Circuit::none || is_in_[cell] != 0) return;
    is_in_[cell] = 1;
    set_.push_back(cell);
}

void StubbornSets::add_driver(NetId net) {
    add(circuit_.driver(net));
}

/// What could change that the cell is excited, or quiet.
void StubbornSets::add_inputs(const CircuitState& state, std::uint32_t cell) {
    const NetId deciding = circuit_.deciding_pin(state, cell, no_net);
    if (deciding != no_net) {
        add_driver(deciding);
    } else {
        for (const NetId pin : circuit_.pins(cell)) add_driver(pin);
    }
}

/// What the firing of the cell could change.
void StubbornSets::add_readers(const CircuitState& state, std::uint32_t cell) {
    for (const std::uint32_t reader : circuit_.readers(circuit_.output(cell))) {
        const NetId deciding = circuit_.deciding_pin(state, reader, circuit_.output(cell));
        const std::uint32_t driver = deciding == no_net ? Circuit::none : circuit_.driver(deciding);
        if (deciding == no_net || (driver != Circuit::none && is_excited_[driver] != 0)) {
            add(reader);
            if (!in_time_) continue;
            for (const NetId pin : circuit_.pins(reader)) add_driver(pin);
        } else {
            add(driver);
        }
    }
}

/// Makes `set_` the stubborn set of a seed; the number of excited cells in it, or as soon as there
/// are more than `least`, some number above that.
std::size_t StubbornSets::close(const CircuitState& state, std::uint32_t seed, std::size_t least) {
    for (const std::uint32_t cell : set_) is_in_[cell] = 0;
    set_.clear();
    add(seed);
    std::size_t excited = 0;
    for (std::size_t next = 0; next < set_.size(); ++next) {
        const std::uint32_t cell = set_[next];
        add_inputs(state, cell);
        if (is_excited_[cell] == 0) continue;
        if (++excited > least) return excited;
        add_readers(state, cell);
    }
    return excited;
}

/// The joint firings of gates out of those given that differ from all orders of single ones.
bool StubbornSets::append_joint(const CircuitState& state, const std::vector<std::uint32_t>& gates,
                                std::vector<Firing>& firings) const {
    // Only gates that read one another can quieten one another.
    std::vector<std::uint32_t> core = gates;
    const auto reads_one = [&](std::uint32_t cell) {
        const auto pins = circuit_.pins(cell);
        return std::any_of(pins.begin(), pins.end(), [&](NetId pin) {
            const std::uint32_t driver = circuit_.driver(pin);
            return driver != cell && std::find(core.begin(), core.end(), driver) != core.end();
        });
    };
    for (bool shrinks = true; shrinks;) {
        const auto kept = std::partition(core.begin(), core.end(), reads_one);
        shrinks = kept != core.end();
        core.erase(kept, core.end());
    }
    if (core.size() > most_gates_of_joint_firing) return false;
    std::sort(core.begin(), core.end());
    for (std::uint32_t chosen = 1; chosen < 1U << core.size(); ++chosen) {
        if ((chosen & (chosen - 1)) == 0) continue;
        Firing firing;
        for (std::size_t i = 0; i < core.size(); ++i) {
            if ((chosen >> i & 1U) != 0) firing.push_back({core[i], CellAction::Kind::take});
        }
        const auto is_quietened = [&](const CellAction& action) {
            Firing others;
            std::copy_if(firing.begin(), firing.end(), std::back_inserter(others),
                         [&](const CellAction& other) { return other != action; });
            CircuitState after = state;
            circuit_.perform(others, after);
            return circuit_.asked(after, action.cell) ==
                   after.values[index_of(circuit_.output(action.cell))];
        };
        if (std::all_of(firing.begin(), firing.end(), is_quietened)) firings.push_back(firing);
    }
    return true;
}

bool StubbornSets::all(const CircuitState& state, std::vector<Firing>& firings) const {
    firings.clear();
    std::vector<std::uint32_t> gates;
    for (const CellAction& action : circuit_.actions(state)) {
        firings.push_back({action});
        if (action.kind == CellAction::Kind::take) gates.push_back(action.cell);
    }
    append_ends(state, firings);
    return append_joint(state, gates, firings);
}

/// Where nothing else happens, the delays that are due end.
void StubbornSets::append_ends(const CircuitState& state, std::vector<Firing>& firings) const {
    if (!firings.empty()) return;
    Firing ends = circuit_.ending_delays(state);
    if (!ends.empty()) firings.push_back(std::move(ends));
}

bool StubbornSets::choose(const CircuitState& state, std::vector<Firing>& firings) {
    firings.clear();
    const std::vector<CellAction> actions = circuit_.actions(state);
    std::fill(is_in_.begin(), is_in_.end(), 0);
    set_.clear();
    if (actions.size() < 2) {
        if (!actions.empty()) firings.push_back(actions);
        append_ends(state, firings);
        return true;
    }
    std::fill(is_excited_.begin(), is_excited_.end(), 0);
    for (const CellAction& action : actions) is_excited_[action.cell] = 1;
    std::size_t least = actions.size();
    std::uint32_t best = actions[0].cell;
    for (const CellAction& action : actions) {
        const std::size_t excited = close(state, action.cell, least - 1);
        if (excited >= least) continue;
        least = excited;
        best = action.cell;
        if (least == 1) break;
    }
    close(state, best, actions.size());
    std::vector<std::uint32_t> gates;
    for (const CellAction& action : actions) {
        if (is_in_[action.cell] == 0) continue;
        firings.push_back({action});
        if (action.kind == CellAction::Kind::take) gates.push_back(action.cell);
    }
    return append_joint(state, gates, firings);
}

}  // namespace grafwire
