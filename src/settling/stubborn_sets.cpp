// Which firings have to be tried in a state: stubborn sets (A. Valmari, "Stubborn sets for reduced
// state space generation", Advances in Petri Nets 1990, LNCS 483).
//
// Gates in different corners of a netlist change in any order, and all orders lead to the same. A
// set of cells is *stubborn* in a state if nothing that cells outside of it do, as long as those of
// the set hold still, can keep its excited cells from firing, change what they fire to, or wake its
// quiet cells, and if no cell outside can fire before and otherwise than it would after an excited
// cell of the set has fired. Then it is enough to try the excited cells of the set: every way to
// rest that begins otherwise can be rearranged so that one of these comes first. So all states of
// rest are found, and an endless run if there is any at all (that paper, on strong stubborn sets).
// What may be lost is whether there is one that is fair, in which no gate is excited for ever;
// any_order.cpp asks again where that matters.
//
// What the cells outside can do is taken from three values (reach.h), which is more than they
// really can: so a set may come out too large, never too small. Beginning with one excited cell,
// what breaks the rule is taken in until nothing does:
//
// - Where the inputs of a cell of the set may come to ask for something else, the drivers of the
// pins
//   that may change. If one pin decides by itself (a 0 at a NAND), its driver is enough.
// - A cell that reads an excited one of the set and may fire before it, unless another pin, which
// stays,
//   decides what it asks for.
//
// A joint firing is tried of the gates in the set. One with gates outside as well is made of gates
// that quieten one another (joint_firings.cpp); by the first rule the gates that quieten a member
// are in the set too, and by the second those that a member quietens.

#include "settling/stubborn_sets.h"

#include <algorithm>

#include "settling/joint_firings.h"

namespace grafwire {

StubbornSets::StubbornSets(const Circuit& circuit)
    : circuit_(circuit),
      reach_(circuit),
      is_excited_(circuit.netlist().cells.size()),
      is_in_(circuit.netlist().cells.size()) {}

bool StubbornSets::add(std::uint32_t cell) {
    if (cell == Circuit::none || is_in_[cell] != 0) return false;
    is_in_[cell] = 1;
    set_.push_back(cell);
    return true;
}

/// Whether any was added.
bool StubbornSets::add_open_drivers(std::uint32_t cell) {
    bool is_added = false;
    for (const NetId pin : circuit_.pins(cell)) {
        if (reach_.is_open(pin)) is_added |= add(circuit_.driver(pin));
    }
    return is_added;
}

/// Takes in what could change what the inputs of a cell ask for; whether there was anything.
bool StubbornSets::keep_asked(const CircuitState& state, std::uint32_t cell) {
    if (reach_.is_unclear(cell)) return add_open_drivers(cell);
    const Logic asked = circuit_.asked(reach_.state(), cell);
    if (asked != Logic::unknown) return false;
    const NetId deciding = circuit_.deciding_pin(state, cell, no_net);
    return deciding == no_net ? add_open_drivers(cell) : add(circuit_.driver(deciding));
}

/// Whether a cell may fire before a net that it reads changes, and otherwise than it would after.
bool StubbornSets::may_be_disturbed(std::uint32_t reader, NetId changing) const {
    if (is_in_[reader] != 0) return false;
    const bool may_fire = is_excited_[reader] != 0 || reach_.is_open(circuit_.output(reader));
    return may_fire && circuit_.deciding_pin(reach_.state(), reader, changing) == no_net;
}

/// Takes in what could fire before a cell, and otherwise; whether there was anything.
bool StubbornSets::add_readers(std::uint32_t cell) {
    bool is_added = false;
    const NetId output = circuit_.output(cell);
    for (const std::uint32_t reader : circuit_.readers(output)) {
        if (may_be_disturbed(reader, output)) is_added |= add(reader);
    }
    return is_added;
}

/// Makes `set_` the stubborn set of a seed; the number of excited cells in it, or as soon as there
/// are more than `least`, some number above that.
std::size_t StubbornSets::close(const CircuitState& state, std::uint32_t seed, std::size_t least) {
    for (const std::uint32_t cell : set_) is_in_[cell] = 0;
    set_.clear();
    add(seed);
    for (;;) {
        reach_.make(state, excited_, is_in_);
        std::size_t excited = 0;
        bool is_added = false;
        for (std::size_t next = 0; next < set_.size(); ++next) {
            const std::uint32_t cell = set_[next];
            is_added |= keep_asked(state, cell);
            if (is_excited_[cell] == 0) continue;
            if (++excited > least) return excited;
            is_added |= add_readers(cell);
        }
        if (!is_added) return excited;
    }
}

bool StubbornSets::choose(const CircuitState& state, std::vector<Firing>& firings) {
    firings.clear();
    std::vector<CellAction> actions = circuit_.actions(state);
    if (actions.size() < 2) {
        if (!actions.empty()) firings.push_back(actions);
        append_ending_delays(circuit_, state, firings);
        return true;
    }
    for (const std::uint32_t cell : excited_) is_excited_[cell] = 0;
    excited_.clear();
    for (const CellAction& action : actions) {
        if (is_excited_[action.cell] == 0) excited_.push_back(action.cell);
        is_excited_[action.cell] = 1;
    }
    std::size_t least = excited_.size();
    std::uint32_t best = excited_[0];
    for (const std::uint32_t cell : excited_) {
        const std::size_t excited = close(state, cell, least - 1);
        if (excited >= least) continue;
        least = excited;
        best = cell;
        if (least == 1) break;
    }
    close(state, best, excited_.size());
    std::erase_if(actions, [&](const CellAction& action) { return is_in_[action.cell] == 0; });
    return append_firings(circuit_, state, actions, firings);
}

}  // namespace grafwire
