#pragma once

#include <cstdint>
#include <string>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// What keeps the program of an example, or of one of 40 random charts, from being a `start` of the
/// grammar of IEC 61131-3; empty where nothing does.
std::string check_grammar(const PlcLanguage& language, const std::string& start,
                          std::uint64_t first_seed);

}  // namespace grafwire::testing
