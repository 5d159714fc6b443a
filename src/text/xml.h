#pragma once

#include <string>
#include <string_view>

namespace grafwire {

/// A text as the content of an XML element. Control characters that XML 1.0 has no place for become
/// `?`.
std::string xml_text(std::string_view text);

/// The same as the value of an attribute in double quotes, in which line feeds survive.
std::string xml_attribute(std::string_view text);

}  // namespace grafwire
