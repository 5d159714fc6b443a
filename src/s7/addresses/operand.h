#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace grafwire::s7 {

// The addresses of a SIMATIC controller, apart from the instructions that use them: what listings,
// tables of assignment and programs for STEP 7 have in common.

/// The spelling of instructions and areas: SIMATIC (`U E0.4`, `K1`), as Cordier prints them, or
/// international (`A I0.4`, `1`).
enum class Mnemonics { simatic, international };

/// Where an operand lives. Letters: SIMATIC (German, French), then international.
enum class Area : std::uint8_t {
    input,     ///< E, I: the process image of the inputs
    output,    ///< A, Q
    variable,  ///< V
    memento,   ///< M
    special,   ///< SM
    timer,     ///< T: its bit, or its current value where a word is read
    counter,   ///< Z, C
    constant,  ///< K1, KHFFFF; 1, 16#FFFF
    symbol,    ///< a name that an I/O assignment gives an address
    text,      ///< the whole operand could not be understood (only in listings with errors)
};

enum class Width : std::uint8_t { bit, byte, word, dword };

/// `V20.1`, `VB100`, `VW20`, `VD2`, `T37`, `K10`, `SM0.1`, `E0.4`.
struct Operand {
    Area area = Area::variable;
    Width width = Width::bit;
    /// The byte number; of a timer or counter its number; of a constant its value.
    std::int32_t address = 0;
    std::uint8_t bit = 0;  ///< 0 … 7, of a bit operand
    std::string symbol;    ///< area symbol only
    auto operator<=>(const Operand&) const = default;
};

}  // namespace grafwire::s7
