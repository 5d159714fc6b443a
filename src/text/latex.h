#pragma once

#include <string>
#include <string_view>

namespace grafwire {

/// A character in LaTeX's text mode, for pdflatex with the encodings T1 and UTF-8; `bytes` is the
/// same in UTF-8. One that pdflatex does not know becomes its number, `U+65E5`.
std::string latex_character(char32_t c, std::string_view bytes);

/// Whether TeX makes one sign of two characters, as of `--`; an empty group between them prevents
/// it.
bool is_latex_ligature(std::string_view first, std::string_view second);

}  // namespace grafwire
