#pragma once

#include <string_view>

namespace grafwire::iec {

/// Whether a word, in lower case, is reserved in IEC 61131-3 (2nd edition, annex C, and what the
/// 3rd adds): keywords, types, operators of both textual languages, standard functions and function
/// blocks, and their parameters.
bool is_keyword(std::string_view word);

}  // namespace grafwire::iec
