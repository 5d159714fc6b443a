#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/file_messages.h"

namespace grafwire {

// SARIF (Static Analysis Results Interchange Format, OASIS, version 2.1.0): what servers and
// editors show beside the lines of a file. A matter of programs: in English, whatever the language.

/// The name of a file as SARIF has it: a reference of a URI, relative to `folder` for what is below
/// it and for what is relative already.
std::string sarif_uri(std::string_view path, std::string_view folder);

/// A log with one run of grafwire. Messages keep their order; one that was there before, with all
/// that it says, is left out. The code of a message is its rule; one without a place is about the
/// first line; one about no text is about `of_no_file`.
std::string write_sarif(std::span<const FileMessages> files, std::string_view folder,
                        std::string_view of_no_file = "grafwire");

}  // namespace grafwire
