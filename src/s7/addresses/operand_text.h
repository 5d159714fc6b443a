#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "s7/addresses/operand.h"

namespace grafwire::s7 {

/// An operand as it is written, in either spelling: `E0.4`, `I0.4`, `VB100`, `T37`, `K10`,
/// `KHFFFF`, `16#FFFF`, `2#101`, `-5`. Empty where the text is none of these (a name, perhaps).
/// Constants have Width::bit, whatever they are used for.
std::optional<Operand> parse_operand(std::string_view text);

/// Whether a text looks like an address, if perhaps a wrong one (`V0.9`, `VX3`, `E300`).
bool looks_like_address(std::string_view text);

/// An operand written in a spelling; hexadecimal constants where `in_hex`.
std::string write_operand(const Operand& operand, Mnemonics mnemonics, bool in_hex = false);

}  // namespace grafwire::s7
