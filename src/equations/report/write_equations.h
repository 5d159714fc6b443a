#pragma once

#include <string>
#include <string_view>

#include "equations/equations.h"
#include "text/message.h"

namespace grafwire {

enum class EquationFormat { text, markdown, latex, csv, json };

struct EquationReport {
    EquationFormat format = EquationFormat::text;
    bool karnaugh = false;  ///< per step also truth table, Karnaugh map and minimised form
    Language language = Language::english;  ///< of headings; the machine formats never change
};

/// CAX, CDX, X of every step and the equations of outputs and vars. CSV: header
/// `variable,CAX,CDX,X`, a row per step in table order, then one per output with its right-hand
/// side in the last column. Of the Karnaugh report CSV shows nothing, JSON the minimised forms.
/// LaTeX is a fragment that needs the package amsmath.
std::string write_equations(const Grafcet& grafcet, const Equations& equations,
                            const EquationReport& report);

}  // namespace grafwire
