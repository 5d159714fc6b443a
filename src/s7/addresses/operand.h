#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

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

/// An operand as it is written, in either spelling: `E0.4`, `I0.4`, `VB100`, `T37`, `K10`,
/// `KHFFFF`, `16#FFFF`, `2#101`, `-5`. Empty where the text is none of these (a name, perhaps).
/// Constants have Width::bit, whatever they are used for.
std::optional<Operand> parse_operand(std::string_view text);

/// Whether a text looks like an address, if perhaps a wrong one (`V0.9`, `VX3`, `E300`).
bool looks_like_address(std::string_view text);

/// An operand written in a spelling; hexadecimal constants where `in_hex`.
std::string write_operand(const Operand& operand, Mnemonics mnemonics, bool in_hex = false);

}  // namespace grafwire::s7
