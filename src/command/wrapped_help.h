#pragma once

#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire {

/// The text of --help with its lines broken at blanks, so that none is wider than a terminal of 80
/// columns; one without a blank in the right place stays as it is. What describes an option goes on
/// below its beginning, in the column where CLI11 puts it:
///
///     --karnaugh                  with the truth table, Karnaugh map and minimised
///                                 form of every step
///
/// An example goes on as a shell reads it, behind a backslash.
std::string wrapped_help(std::string_view text, Language language);

}  // namespace grafwire
