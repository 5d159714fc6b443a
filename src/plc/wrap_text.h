#pragma once

#include <string>
#include <string_view>

namespace grafwire {

/// A line, indented by so many steps of four blanks, broken at blanks where it is longer than
/// `width` characters; what goes on is indented by one step more. Ends with a line end.
std::string wrap_text(std::string_view line, std::size_t indent, std::size_t width);

}  // namespace grafwire
