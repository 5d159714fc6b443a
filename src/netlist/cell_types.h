#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "netlist/messages.h"

namespace grafwire {

// All that a netlist can hold, in one table, which writers, readers and the simulator share. What a
// type does in time (delays, three values) is told in src/simulate.

enum class CellType : std::uint8_t {
    low,   ///< constant 0
    high,  ///< constant 1
    buffer,
    inverter,
    and_gate,
    or_gate,
    nand_gate,
    nor_gate,
    xor_gate,    ///< 1 where an odd number of inputs is 1
    latch,       ///< pins: set, reset. Set wins: S = R = 1 gives 1
    hold_latch,  ///< pins: data, enable. Follows data while enable is 1, else holds
    rise_pulse,  ///< 1 for its width after each rise of its input, begun again by a new rise
    fall_pulse,  ///< likewise after each fall
    timer,       ///< a buffer whose rise and fall take the delays of its timing
    flip_flop,   ///< pins: data, clock. Takes data at the rise of the clock
    scan_timer,  ///< pins: operand, clock. A timer that looks at its operand at the rise of the
                 ///< clock
    scan_timer_next,  ///< pins: operand, output of the scan_timer with that operand, clock. What
                      ///< that timer is to show after the next rise of the clock; changes at once
};

/// One row of the cell table.
struct CellTypeRow {
    CellType type;
    std::string_view name;  ///< in netlist texts and file formats: `and`, `nand`, `latch`, …
    Message<> description;  ///< for people: "AND gate", "porte ET"
    std::uint32_t min_pins;
    std::uint32_t max_pins;  ///< any_number: no bound
    bool has_memory;         ///< keeps a value of its own and has an initial value
    bool has_timing;
    bool is_clocked;  ///< its last pin is the clock
};

inline constexpr std::uint32_t any_number = 0xffffffffU;

/// In the order of CellType.
inline constexpr std::array<CellTypeRow, 17> cell_table{{
    {CellType::low, "low", messages::netlist::constant_0, 0, 0, false, false, false},
    {CellType::high, "high", messages::netlist::constant_1, 0, 0, false, false, false},
    {CellType::buffer, "buf", messages::netlist::buffer, 1, 1, false, false, false},
    {CellType::inverter, "not", messages::netlist::not_gate, 1, 1, false, false, false},
    {CellType::and_gate, "and", messages::netlist::and_gate, 1, any_number, false, false, false},
    {CellType::or_gate, "or", messages::netlist::or_gate, 1, any_number, false, false, false},
    {CellType::nand_gate, "nand", messages::netlist::nand_gate, 1, any_number, false, false, false},
    {CellType::nor_gate, "nor", messages::netlist::nor_gate, 1, any_number, false, false, false},
    {CellType::xor_gate, "xor", messages::netlist::xor_gate, 1, any_number, false, false, false},
    {CellType::latch, "latch", messages::netlist::latch, 2, 2, true, false, false},
    {CellType::hold_latch, "hold", messages::netlist::hold_latch, 2, 2, true, false, false},
    {CellType::rise_pulse, "rise_pulse", messages::netlist::rise_pulse, 1, 1, false, true, false},
    {CellType::fall_pulse, "fall_pulse", messages::netlist::fall_pulse, 1, 1, false, true, false},
    {CellType::timer, "timer", messages::netlist::timer, 1, 1, true, true, false},
    {CellType::flip_flop, "dff", messages::netlist::flip_flop, 2, 2, true, false, true},
    {CellType::scan_timer, "scan_timer", messages::netlist::clocked_timer, 2, 2, true, true, true},
    {CellType::scan_timer_next, "scan_timer_next", messages::netlist::clocked_timer_next, 3, 3,
     false, true, true},
}};

constexpr const CellTypeRow& row_of(CellType type) {
    return cell_table[static_cast<std::size_t>(type)];
}

/// Whether the timing of a cell is that of a time condition: a delay for the rise, one for the
/// fall.
constexpr bool is_timer(CellType type) {
    return type == CellType::timer || type == CellType::scan_timer ||
           type == CellType::scan_timer_next;
}

/// Whether it gives a pulse after an edge of its input.
constexpr bool is_pulse(CellType type) {
    return type == CellType::rise_pulse || type == CellType::fall_pulse;
}

/// Whether it counts its delays in clock cycles.
constexpr bool counts_scans(CellType type) {
    return type == CellType::scan_timer || type == CellType::scan_timer_next;
}

/// The type of that name, if there is one.
constexpr std::optional<CellType> cell_type_named(std::string_view name) {
    for (const CellTypeRow& row : cell_table) {
        if (row.name == name) return row.type;
    }
    return std::nullopt;
}

}  // namespace grafwire
