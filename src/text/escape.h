#pragma once

#include <string>
#include <string_view>

namespace grafwire {

// Texts of any content as parts of files in which some characters have a meaning of their own.

/// Appends a field of a CSV row (RFC 4180): quoted only where it has to be. `a,b` becomes `"a,b"`,
/// and `a"b` becomes `"a""b"`.
void append_csv_field(std::string& out, std::string_view field);

/// A text as the content of an XML element. Control characters that XML 1.0 has no place for become
/// `?`.
std::string xml_text(std::string_view text);

/// The same as the value of an attribute in double quotes, in which line feeds survive.
std::string xml_attribute(std::string_view text);

}  // namespace grafwire
