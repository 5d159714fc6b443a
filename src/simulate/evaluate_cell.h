#pragma once

#include <cstdint>

#include "netlist/cell_types.h"

namespace grafwire {

// What each type of cell makes of its inputs, in Kleene's three values: a result is known only if
// it is the same whatever the unknown inputs may be.
//
// Gates are not evaluated from their pins but from a sum that is kept up to date as the pins
// change: every pin at the gate's controlling value (0 for AND, 1 for OR) adds 2^32, every unknown
// pin adds 1. The sum then says it all, for any number of pins:
//
//   sum           AND  OR  NAND  NOR      in the gate's table
//   0              1    0    0    1       bits 0-1
//   1 .. 2^32-1    x    x    x    x       bits 2-3
//   2^32 or more   0    1    1    0       bits 4-5
//
// A buffer is an OR of one pin, an inverter a NOR of one, the constants an OR and an AND of none.

using InputSum = std::uint64_t;
inline constexpr InputSum controlling = InputSum{1} << 32;

struct GateRule {
    std::uint8_t table = 0;
    Logic controlling_value = Logic::one;
};

constexpr std::uint8_t gate_table(Logic without, Logic with_controlling) {
    return static_cast<std::uint8_t>(static_cast<unsigned>(without) |
                                     static_cast<unsigned>(Logic::unknown) << 2U |
                                     static_cast<unsigned>(with_controlling) << 4U);
}

/// The value a table gives for a sum of inputs.
constexpr unsigned look_up(std::uint8_t table, InputSum sum) {
    const unsigned row =
        static_cast<unsigned>(sum != 0) + static_cast<unsigned>(sum >= controlling);
    return static_cast<unsigned>(table) >> (2U * row) & 3U;
}

/// What one pin adds to the sum of a gate with this controlling value.
constexpr InputSum contribution(Logic controlling_value, Logic pin) {
    if (pin == Logic::unknown) return 1;
    return pin == controlling_value ? controlling : 0;
}

constexpr bool is_gate(CellType type) { return type <= CellType::nor_gate; }

constexpr GateRule gate_rule(CellType type) {
    switch (type) {
        case CellType::high:
        case CellType::and_gate: return {gate_table(Logic::one, Logic::zero), Logic::zero};
        case CellType::nand_gate: return {gate_table(Logic::zero, Logic::one), Logic::zero};
        case CellType::inverter:
        case CellType::nor_gate: return {gate_table(Logic::one, Logic::zero), Logic::one};
        default: return {gate_table(Logic::zero, Logic::one), Logic::one};
    }
}

/// XOR, from the sum with controlling value 1.
constexpr Logic xor_value(InputSum sum) {
    if (static_cast<std::uint32_t>(sum) != 0) return Logic::unknown;
    return static_cast<Logic>(sum >> 32U & 1U);
}

/// The value the possibilities agree on.
constexpr Logic agreed(Logic a, Logic b) { return a == b ? a : Logic::unknown; }

constexpr Logic inverse(Logic value) {
    if (value == Logic::unknown) return value;
    return value == Logic::one ? Logic::zero : Logic::one;
}

/// Set wins: 1 if set, else 0 if reset, else what was held.
constexpr Logic latch_value(Logic set, Logic reset, Logic held) {
    const Logic if_reset_unknown = agreed(Logic::zero, held);
    const Logic not_set = reset == Logic::one    ? Logic::zero
                          : reset == Logic::zero ? held
                                                 : if_reset_unknown;
    if (set == Logic::one) return Logic::one;
    return set == Logic::zero ? not_set : agreed(Logic::one, not_set);
}

constexpr Logic hold_latch_value(Logic data, Logic enable, Logic held) {
    if (enable == Logic::one) return data;
    return enable == Logic::zero ? held : agreed(data, held);
}

/// Whether a net that went from one value to another has risen.
enum class Edge : std::uint8_t { none, certain, possible };

constexpr Edge rise_between(Logic from, Logic to) {
    if (from == to || from == Logic::one || to == Logic::zero) return Edge::none;
    return from == Logic::zero && to == Logic::one ? Edge::certain : Edge::possible;
}
constexpr Edge fall_between(Logic from, Logic to) {
    return rise_between(inverse(from), inverse(to));
}

}  // namespace grafwire
