#pragma once

#include <string>
#include <string_view>

namespace grafwire {

// Names and words in LaTeX's notation, for pdflatex with the encodings T1 and UTF-8. A run of
// characters that is wide may be broken, at underscores where there are some.

/// Words in text mode, special characters escaped.
std::string latex_words(std::string_view words);

/// A name in mathematical mode: `m`, `\mathrm{dcy}`, `\text{H+}`.
std::string latex_identifier(std::string_view name);

/// `X_{10}`, `X_{\mathrm{start}}`, `\mathit{CAX}_{10}`; a name too wide for an index stands on the
/// line.
std::string latex_indexed(std::string_view symbol, std::string_view name);

/// `\mathit{CAX}`; a single letter needs no more.
std::string latex_symbol(std::string_view symbol);

/// How wide a piece of LaTeX is in print at most, in points, set in 10 points: an estimate that
/// knows the commands that the reports use.
double printed_width(std::string_view latex);

}  // namespace grafwire
