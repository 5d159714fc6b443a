#pragma once

#include <array>
#include <cstdint>

#include "s7/check_stack.h"
#include "s7/machine/three_values.h"

namespace grafwire::s7 {

/// The stack of nine bits, the top at 0.
class BitStack {
  public:
    /// All levels 0 but for the top.
    explicit BitStack(bool top = false) { levels_[0] = bit3(top); }

    Bit3 top() const { return levels_[0]; }
    Bit3 level(std::size_t i) const { return levels_[i]; }
    void set_top(Bit3 value) { levels_[0] = value; }

    /// A new top; the lowest level is lost.
    void push(Bit3 value) {
        for (std::size_t i = levels_.size() - 1; i > 0; --i) levels_[i] = levels_[i - 1];
        levels_[0] = value;
    }
    /// The lowest level becomes 0.
    void pop() {
        for (std::size_t i = 0; i + 1 < levels_.size(); ++i) levels_[i] = levels_[i + 1];
        levels_.back() = bit3(false);
    }

  private:
    std::array<Bit3, stack_levels> levels_{};
};

}  // namespace grafwire::s7
