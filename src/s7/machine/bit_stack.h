#pragma once

#include <array>
#include <cstdint>

#include "s7/check_listing.h"
#include "s7/machine/machine.h"

namespace grafwire::s7 {

/// The stack of nine bits, the top at 0.
class BitStack {
  public:
    /// All levels 0 except the top.
    explicit BitStack(bool top = false) { levels_[0] = Signal::of(top); }

    Signal top() const { return levels_[0]; }
    Signal level(std::size_t i) const { return levels_[i]; }
    void set_top(Signal value) { levels_[0] = value; }

    /// A new top; the lowest level is lost.
    void push(Signal value) {
        for (std::size_t i = levels_.size() - 1; i > 0; --i) levels_[i] = levels_[i - 1];
        levels_[0] = value;
    }
    /// The lowest level becomes 0.
    void pop() {
        for (std::size_t i = 0; i + 1 < levels_.size(); ++i) levels_[i] = levels_[i + 1];
        levels_.back() = Signal::of(false);
    }

  private:
    std::array<Signal, stack_levels> levels_{};
};

}  // namespace grafwire::s7
