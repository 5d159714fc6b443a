#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "settling/stubborn_search.h"

namespace grafwire {

/// Chooses what to try next where firings have times, so that no rest is missed, nor whether there
/// is an endless run, and so that the times of cells outside of the set need not be compared with
/// those in it (see the source).
class TimedStubbornSets : public StubbornSearch {
  public:
    explicit TimedStubbornSets(const Circuit& circuit)
        : StubbornSearch(circuit), none_(circuit.netlist().cells.size()) {}

  private:
    void prepare(const CircuitState& state) override { reach_.make(state, excited_, none_); }
    std::size_t close(const CircuitState& state, std::size_t most) override;
    void add_moving(std::uint32_t cell);
    void add_driver(NetId net);
    void add_inputs(const CircuitState& state, std::uint32_t cell);
    void add_readers(const CircuitState& state, std::uint32_t cell);
    bool is_fixed(std::uint32_t cell) const;

    const std::vector<std::uint8_t> none_;  ///< per cell: 0, as none holds still
};

}  // namespace grafwire
