// Each excited cell is a seed in turn, until a set holds no other excited cell. A set that has
// become larger than the smallest so far is given up.

#include "settling/stubborn_search.h"

#include <algorithm>

#include "settling/joint_firings.h"

namespace grafwire {

StubbornSearch::StubbornSearch(const Circuit& circuit)
    : circuit_(circuit),
      reach_(circuit),
      is_excited_(circuit.netlist().cells.size()),
      is_in_(circuit.netlist().cells.size()) {}

bool StubbornSearch::add(std::uint32_t cell) {
    if (cell == Circuit::none || is_in_[cell] != 0) return false;
    is_in_[cell] = 1;
    set_.push_back(cell);
    return true;
}

void StubbornSearch::clear() {
    for (const std::uint32_t cell : set_) is_in_[cell] = 0;
    set_.clear();
}

std::size_t StubbornSearch::grow(const CircuitState& state, std::uint32_t seed, std::size_t most) {
    clear();
    add(seed);
    return close(state, most);
}

void StubbornSearch::note_excited(const std::vector<CellAction>& actions) {
    for (const std::uint32_t cell : excited_) is_excited_[cell] = 0;
    excited_.clear();
    for (const CellAction& action : actions) {
        if (is_excited_[action.cell] == 0) excited_.push_back(action.cell);
        is_excited_[action.cell] = 1;
    }
}

void StubbornSearch::make_smallest(const CircuitState& state) {
    std::size_t least = excited_.size();
    std::uint32_t best = excited_[0];
    std::uint32_t at_hand = Circuit::none;
    for (const std::uint32_t seed : excited_) {
        const std::size_t excited = grow(state, seed, least - 1);
        at_hand = seed;
        if (excited >= least) continue;
        least = excited;
        best = seed;
        if (least == 1) break;
    }
    // Where none is smaller than all excited cells, the sets were given up.
    if (at_hand != best || least == excited_.size()) grow(state, best, excited_.size());
}

bool StubbornSearch::choose(const CircuitState& state, std::vector<Firing>& firings) {
    firings.clear();
    clear();
    std::vector<CellAction> actions = circuit_.actions(state);
    if (actions.size() < 2) {
        if (!actions.empty()) firings.push_back(actions);
        append_ending_delays(circuit_, state, firings);
        return true;
    }
    note_excited(actions);
    prepare(state);
    make_smallest(state);
    std::erase_if(actions, [&](const CellAction& action) { return !contains(action.cell); });
    return append_firings(circuit_, state, actions, firings);
}

}  // namespace grafwire
