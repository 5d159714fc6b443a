#pragma once

#include <string>
#include <string_view>

#include "equations/equations.h"
#include "text/message.h"

namespace grafwire {

/// `html` is a part of a page, without a title.
enum class EquationFormat { text, markdown, latex, csv, json, html };

struct EquationReport {
    EquationFormat format = EquationFormat::text;
    bool karnaugh = false;  ///< also truth table, Karnaugh map, and minimised forms per step
    Language language = Language::english;  ///< of headings; the machine formats never change
    bool standalone = false;                ///< LaTeX: a whole document
};

/// The transitions, CAX, CDX, X of every step and the equations of outputs and vars. CSV: header
/// `variable,CAX,CDX,X`, a row per step in table order, then one per output with its right-hand
/// side in the last column. Of the Karnaugh report CSV shows nothing, JSON the minimised forms.
/// LaTeX is a document for pdflatex, or a fragment that names the packages it needs.
std::string write_equations(const Grafcet& grafcet, const Equations& equations,
                            const EquationReport& report);

}  // namespace grafwire
