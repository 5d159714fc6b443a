#pragma once

#include <cstdint>

namespace grafwire {

// Kleene's strong logic of three values (S. C. Kleene, "Introduction to Metamathematics", 1952,
// § 64): a result is known exactly where every choice of 0 or 1 for each unknown operand, taken by
// itself, gives the same.
//
//   a  ~a      a & b  0 1 x      a | b  0 1 x      a ^ b  0 1 x
//   0  1         0    0 0 0        0    0 1 x        0    0 1 x
//   1  0         1    0 1 x        1    1 1 1        1    1 0 x
//   x  x         x    0 x x        x    x 1 x        x    x x x
//
// What "unknown" stands for is up to the user: a net whose value is not known, an input left
// open. The operators are those that IEEE 1666 (SystemC) gives its values of more than two states.

enum class Logic : std::uint8_t { zero, one, unknown };

constexpr Logic logic_of(bool value) {
    return value ? Logic::one : Logic::zero;
}

constexpr Logic operator~(Logic a) {
    if (a == Logic::unknown) return a;
    return a == Logic::one ? Logic::zero : Logic::one;
}

constexpr Logic operator&(Logic a, Logic b) {
    if (a == Logic::zero || b == Logic::zero) return Logic::zero;
    return a == Logic::one && b == Logic::one ? Logic::one : Logic::unknown;
}

constexpr Logic operator|(Logic a, Logic b) {
    return ~(~a & ~b);
}

constexpr Logic operator^(Logic a, Logic b) {
    if (a == Logic::unknown || b == Logic::unknown) return Logic::unknown;
    return logic_of(a != b);
}

/// The value the possibilities agree on.
constexpr Logic agreed(Logic a, Logic b) {
    return a == b ? a : Logic::unknown;
}

/// '0', '1' or 'x'.
char digit_of(Logic value);

/// A value, and where it is unknown one cause of that: a signal that would have to be known. Of two
/// causes the left operand's counts.
template <typename Source>
struct Signal {
    Logic value = Logic::zero;
    Source cause{};  ///< meaningless where the value is known

    static constexpr Signal of(bool known_value) { return {logic_of(known_value), {}}; }

    constexpr bool is_known() const { return value != Logic::unknown; }
    constexpr bool is_one() const { return value == Logic::one; }

    friend constexpr Signal operator~(Signal a) { return {~a.value, a.cause}; }
    friend constexpr Signal operator&(Signal a, Signal b) {
        return {a.value & b.value, a.is_known() ? b.cause : a.cause};
    }
    friend constexpr Signal operator|(Signal a, Signal b) {
        return {a.value | b.value, a.is_known() ? b.cause : a.cause};
    }
};

/// 32 values side by side, combined bit by bit.
struct LogicWord {
    std::uint32_t value = 0;  ///< 0 where not known
    std::uint32_t known = 0xffffffffU;

    friend constexpr LogicWord operator~(LogicWord a) { return {~a.value & a.known, a.known}; }
    friend constexpr LogicWord operator&(LogicWord a, LogicWord b) {
        const std::uint32_t zeros = (a.known & ~a.value) | (b.known & ~b.value);
        return {a.value & b.value, (a.known & b.known) | zeros};
    }
    friend constexpr LogicWord operator|(LogicWord a, LogicWord b) { return ~(~a & ~b); }
    friend constexpr LogicWord operator^(LogicWord a, LogicWord b) {
        const std::uint32_t both = a.known & b.known;
        return {(a.value ^ b.value) & both, both};
    }
};

}  // namespace grafwire
