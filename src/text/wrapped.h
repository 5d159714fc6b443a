#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafwire {

/// The lines of a text broken at blanks, so that none has more than `width` characters; one without
/// a blank in the right place stays as it is. What is broken off goes on below, four columns
/// further in than its line begins. No-break blanks are not broken at.
std::string wrapped(std::string_view text, std::size_t width);

/// The same for formulas, such as `X1 = (X0.m + /X2.X1)./Init`: a line ends behind an operator, and
/// behind one that is within as few parentheses as can be; of these behind a `+` before a `.`, and
/// as late as can be.
std::string wrapped_formulas(std::string_view text, std::size_t width);

}  // namespace grafwire
