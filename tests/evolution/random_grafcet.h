#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace grafwire {

/// Pseudo-random numbers that are the same everywhere for the same seed.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    /// 0 … limit - 1
    std::uint32_t below(std::uint32_t limit) {
        return static_cast<std::uint32_t>(engine_() % limit);
    }
    bool one_in(std::uint32_t n) { return below(n) == 0; }

  private:
    std::mt19937 engine_;
};

/// The text of a small GRAFCET with everything the language has: inputs a, b, c; outputs o, p
/// (continuous) and s (stored); vars v, w; counters k, m; up to four graphs with orders and
/// enclosures that go from an earlier graph to a later one.
std::string random_grafcet(Random& random);

}  // namespace grafwire
