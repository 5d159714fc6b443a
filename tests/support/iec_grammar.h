#pragma once

#include <string>

namespace grafwire::testing {

/// What keeps a text from being a `start` of the grammar of IEC 61131-3 (iec_61131_3.ebnf):
/// `st_block`, `il_block` or `sfc_program`. Empty where nothing does. Knows the form of a text
/// alone, no types and no declarations; shares nothing with the interpreters.
std::string misfit_in_iec(const std::string& text, const std::string& start);

}  // namespace grafwire::testing
