#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/safe_names.h"

namespace grafwire::iec {

/// Whether a word, in lower case, is reserved in IEC 61131-3 (2nd edition, annex C, and what the
/// 3rd adds): keywords, types, operators of both textual languages, standard functions and function
/// blocks. Not their parameters and the qualifiers of actions: `S1`, `Q`, `N` mean these only where
/// one stands, and are common names of buttons and breakers.
bool is_keyword(std::string_view word);
/// The same of Instruction List, where `S1` is also an operator.
bool is_il_keyword(std::string_view word);

/// Whether a text is an identifier as it stands: ASCII letters, digits and single underscores, none
/// of them at the end, no digit in front, no keyword.
bool is_identifier(std::string_view name);

/// In capitals, as identifiers are compared; the other in small letters, as keywords are listed.
std::string capitals(std::string_view name);
std::string small_letters(std::string_view name);

/// Makes names into identifiers of IEC 61131-3 (section 2.1.2: ASCII letters, digits, single
/// underscores, no case, no keywords), one-to-one and readable: `V+` becomes V_plus, `↑dcy`
/// rise_dcy, `5s/X13` n5s_X13.
class Identifiers {
  public:
    /// The identifiers of a group of names, none of which any group before has taken. Names that
    /// are identifiers keep their spelling before the others get theirs.
    std::vector<std::string> add(const std::vector<std::string>& names);

  private:
    SafeNames names_{false, is_keyword};
};

}  // namespace grafwire::iec
