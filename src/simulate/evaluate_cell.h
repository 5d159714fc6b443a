#pragma once

#include <cstdint>

#include "logic/logic.h"

namespace grafwire {

// What the cells with a memory make of their inputs, in three values: a result is known only if it
// is the same whatever the unknown inputs may be.

/// A value in three as the least and the greatest that it can be in two, and back.
constexpr bool least(Logic value) {
    return value == Logic::one;
}
constexpr bool greatest(Logic value) {
    return value != Logic::zero;
}
constexpr Logic between(bool low, bool high) {
    if (low) return Logic::one;
    return high ? Logic::unknown : Logic::zero;
}

/// Set wins: 1 if set, else 0 if reset, else what was held.
constexpr Logic latch_value(Logic set, Logic reset, Logic held) {
    if (set == Logic::one) return Logic::one;
    Logic not_set = held;
    if (reset == Logic::one) not_set = Logic::zero;
    if (reset == Logic::unknown) not_set = agreed(Logic::zero, held);
    return set == Logic::zero ? not_set : agreed(Logic::one, not_set);
}

constexpr Logic hold_latch_value(Logic data, Logic enable, Logic held) {
    if (enable == Logic::one) return data;
    return enable == Logic::zero ? held : agreed(data, held);
}

/// Whether a net that went from one value to another has risen.
enum class Edge : std::uint8_t { absent, certain, possible };

constexpr Edge rise_between(Logic from, Logic to) {
    if (from == to || from == Logic::one || to == Logic::zero) return Edge::absent;
    return from == Logic::zero && to == Logic::one ? Edge::certain : Edge::possible;
}
constexpr Edge fall_between(Logic from, Logic to) {
    return rise_between(~from, ~to);
}

}  // namespace grafwire
