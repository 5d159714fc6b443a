#pragma once

#include <cstddef>
#include <cstdint>

#include "settling/stubborn_search.h"

namespace grafwire {

/// Chooses what to try next in any order of firings, so that no rest is missed, nor whether there
/// is an endless run (see the source).
class StubbornSets : public StubbornSearch {
  public:
    explicit StubbornSets(const Circuit& circuit) : StubbornSearch(circuit) {}

  private:
    void prepare(const CircuitState& /*state*/) override {}
    std::size_t close(const CircuitState& state, std::size_t most) override;
    bool add_open_drivers(std::uint32_t cell);
    bool keep_asked(const CircuitState& state, std::uint32_t cell);
    bool add_readers(std::uint32_t cell);
    bool may_be_disturbed(std::uint32_t reader, NetId changing) const;
};

}  // namespace grafwire
