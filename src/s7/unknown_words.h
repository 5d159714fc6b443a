#pragma once

#include <string>
#include <string_view>

#include "s7/addresses/io_assignment.h"

namespace grafwire::s7 {

/// What to say of a word that is no instruction; `suggests`: with the nearest that is one.
std::string unknown_instruction_message(std::string_view word, bool suggests);

/// What to say of a word that is no operand, where names have addresses in `io` (may be null).
std::string unknown_operand_message(std::string_view word, bool quoted, const IoAssignment* io);

}  // namespace grafwire::s7
