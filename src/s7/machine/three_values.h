#pragma once

#include <cstdint>

namespace grafwire::s7 {

/// A bit that may not be known, and then an open input it depends on.
struct Bit3 {
    bool value = false;  ///< 0 where not known
    bool known = true;
    std::uint16_t cause = 0;

    bool is(bool wanted) const { return known && value == wanted; }
};

constexpr Bit3 bit3(bool value) {
    return {value, true, 0};
}

constexpr Bit3 not3(Bit3 a) {
    return a.known ? bit3(!a.value) : a;
}

constexpr Bit3 and3(Bit3 a, Bit3 b) {
    if (!a.known) return b.known && !b.value ? bit3(false) : a;
    return a.value ? b : a;
}

constexpr Bit3 or3(Bit3 a, Bit3 b) {
    return not3(and3(not3(a), not3(b)));
}

/// A byte, word or double word, bit by bit.
struct Word3 {
    std::uint32_t value = 0;  ///< 0 where not known
    std::uint32_t known = 0xffffffffU;
};

constexpr Word3 not3(Word3 a) {
    return {~a.value & a.known, a.known};
}

constexpr Word3 and3(Word3 a, Word3 b) {
    return {a.value & b.value, (a.known & b.known) | (a.known & ~a.value) | (b.known & ~b.value)};
}

constexpr Word3 or3(Word3 a, Word3 b) {
    return not3(and3(not3(a), not3(b)));
}

constexpr Word3 xor3(Word3 a, Word3 b) {
    const std::uint32_t known = a.known & b.known;
    return {(a.value ^ b.value) & known, known};
}

}  // namespace grafwire::s7
