#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafwire {

/// The lines of a text broken at blanks, so that none has more than `width` characters; one without
/// a blank in the right place stays as it is. What is broken off goes on below, four columns
/// further in than its line begins. No-break blanks are not broken at.
std::string wrapped(std::string_view text, std::size_t width);

}  // namespace grafwire
