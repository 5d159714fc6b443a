#pragma once

#include <array>
#include <cstdint>

#include "logic/logic.h"
#include "netlist/cell_types.h"

namespace grafwire {

// What cells make of their inputs, in three values: gates first, then cells with a memory. Nothing
// here has a state of its own.

// All that is needed to evaluate a gate, in one word.
//
// Gates are not evaluated from their pins but from two counts kept up to date as the pins change:
// how many are at the controlling value of the gate (0 for AND, 1 for OR), and how many are
// unknown. They say it all, for any number of pins, in Kleene's three values:
//
//   controlling  unknown     AND  OR  NAND  NOR     row of the table
//   0            0            1    0    0    1      0
//   0            1 or more    x    x    x    x      1
//   1 or more    any          0    1    1    0      2
//
// A buffer is an OR of one pin, an inverter a NOR of one, the constants an OR and an AND of none.
// An XOR counts ones as an OR does; its value is their parity.

/// Bits 0-23 unknown pins, 24-47 controlling pins, 48-53 the table, two bits a row, 54-55 the value
/// of the cell, then the flags.
using CellWord = std::uint64_t;

inline constexpr std::uint32_t most_pins = (1U << 24U) - 1;
inline constexpr CellWord unknown_pin = 1;
inline constexpr CellWord controlling_pin = CellWord{1} << 24U;
inline constexpr CellWord unknown_pins = controlling_pin - 1;
inline constexpr CellWord all_pins = (CellWord{1} << 48U) - 1;
inline constexpr unsigned table_at = 48;
inline constexpr unsigned value_at = 54;
inline constexpr CellWord value_bits = CellWord{3} << value_at;
/// Evaluated otherwise than by the table.
inline constexpr CellWord special_flag = CellWord{1} << 56U;
/// In the list of cells to be evaluated at the end of the tick.
inline constexpr CellWord touched_flag = CellWord{1} << 57U;
inline constexpr CellWord forced_flag = CellWord{1} << 58U;
/// An input port.
inline constexpr CellWord undriven_flag = CellWord{1} << 59U;

constexpr unsigned table_row(CellWord word) {
    return static_cast<unsigned>((word & all_pins) != 0) +
           static_cast<unsigned>((word & all_pins) >= controlling_pin);
}
constexpr unsigned look_up(CellWord word) {
    return static_cast<unsigned>(word >> (table_at + 2 * table_row(word))) & 3U;
}
constexpr unsigned value_in(CellWord word) {
    return static_cast<unsigned>(word >> value_at) & 3U;
}
constexpr CellWord with_value(CellWord word, Logic value) {
    return (word & ~value_bits) | static_cast<CellWord>(value) << value_at;
}
constexpr Logic xor_value(CellWord word) {
    if ((word & unknown_pins) != 0) return Logic::unknown;
    return logic_of((word & controlling_pin) != 0);
}

/// What one pin adds to the word of a gate with this controlling value.
constexpr CellWord contribution(Logic controlling_value, Logic pin) {
    if (pin == Logic::unknown) return unknown_pin;
    return pin == controlling_value ? controlling_pin : 0;
}

/// What the change of a pin adds to the words of readers with controlling value 0 and 1.
using Shares = std::array<CellWord, 2>;
/// By old value times 4 plus new value.
constexpr std::array<Shares, 12> make_share_table() {
    std::array<Shares, 12> table{};
    for (unsigned from = 0; from < 3; ++from) {
        for (unsigned to = 0; to < 3; ++to) {
            for (unsigned control = 0; control < 2; ++control) {
                const auto value = static_cast<Logic>(control);
                table[4 * from + to][control] = contribution(value, static_cast<Logic>(to)) -
                                                contribution(value, static_cast<Logic>(from));
            }
        }
    }
    return table;
}
inline constexpr std::array<Shares, 12> share_table = make_share_table();

constexpr bool is_gate(CellType type) {
    return type <= CellType::nor_gate;
}

struct GateRule {
    Logic without = Logic::zero;           ///< the value where no pin is at the controlling value
    Logic controlling_value = Logic::one;  ///< its value else is the inverse of `without`
};
constexpr GateRule gate_rule(CellType type) {
    switch (type) {
        case CellType::high:
        case CellType::and_gate:
            return {Logic::one, Logic::zero};
        case CellType::nand_gate:
            return {Logic::zero, Logic::zero};
        case CellType::inverter:
        case CellType::nor_gate:
            return {Logic::one, Logic::one};
        default:
            return {Logic::zero, Logic::one};
    }
}
constexpr CellWord table_of(CellType type) {
    const auto without = static_cast<CellWord>(gate_rule(type).without);
    return (without | CellWord{2} << 2U | (1 - without) << 4U) << table_at;
}

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
