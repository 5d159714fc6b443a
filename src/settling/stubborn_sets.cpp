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

namespace grafwire {

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

std::size_t StubbornSets::close(const CircuitState& state, std::size_t most) {
    for (;;) {
        reach_.make(state, excited_, is_in_);
        std::size_t excited = 0;
        bool is_added = false;
        for (std::size_t next = 0; next < set_.size(); ++next) {
            const std::uint32_t cell = set_[next];
            is_added |= keep_asked(state, cell);
            if (is_excited_[cell] == 0) continue;
            if (++excited > most) return excited;
            is_added |= add_readers(cell);
        }
        if (!is_added) return excited;
    }
}

}  // namespace grafwire
