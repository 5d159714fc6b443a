#pragma once

#include <cstdint>
#include <vector>

#include "settling/circuit.h"
#include "settling/reach.h"
#include "settling/settling_model.h"

namespace grafwire {

/// Chooses what to try next in a state, of all that could happen: of the sets that grow from one
/// excited cell each, the firings in the one with the fewest excited cells. How a set grows is what
/// the kinds of stubborn sets differ in.
class StubbornSearch {
  public:
    /// The firings to try in a state; empty where it is at rest. False where there are too many.
    bool choose(const CircuitState& state, std::vector<Firing>& firings);
    /// Whether a cell is in the set that was chosen.
    bool contains(std::uint32_t cell) const { return is_in_[cell] != 0; }

  protected:
    explicit StubbornSearch(const Circuit& circuit);
    virtual ~StubbornSearch() = default;

    /// Called for each state before its sets grow.
    virtual void prepare(const CircuitState& state) = 0;
    /// Lets `set_`, which holds a seed, grow until it is closed; the number of excited cells in it,
    /// or as soon as there are more than `most`, some number above that.
    virtual std::size_t close(const CircuitState& state, std::size_t most) = 0;
    /// Whether the cell was not yet in the set.
    bool add(std::uint32_t cell);

    const Circuit& circuit_;
    Reach reach_;
    std::vector<std::uint32_t> excited_;    ///< cells, in the state at hand
    std::vector<std::uint8_t> is_excited_;  ///< per cell, likewise
    std::vector<std::uint8_t> is_in_;       ///< per cell, whether in the set
    std::vector<std::uint32_t> set_;        ///< in the order of arrival

  private:
    void clear();
    std::size_t grow(const CircuitState& state, std::uint32_t seed, std::size_t most);
    void note_excited(const std::vector<CellAction>& actions);
    void make_smallest(const CircuitState& state);
};

}  // namespace grafwire
