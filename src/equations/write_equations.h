#pragma once

#include <string>
#include <string_view>

#include "equations/equations.h"
#include "grafcet/describe_grafcet.h"

namespace grafwire {

enum class EquationFormat { text, markdown, latex, csv, json };

struct EquationReport {
    EquationFormat format = EquationFormat::text;
    bool karnaugh = false;  ///< per step also truth table, Karnaugh map and minimised form
    Language language = Language::english;  ///< of headings; the machine formats never change
};

/// CAX, CDX, X of every step and the equations of outputs and vars. CSV: header
/// `variable,CAX,CDX,X`, a row per step in table order, then one per output.
std::string write_equations(const Equations& equations, const EquationReport& report);

/// One expression of the equations in the notation of the course: `(X7.e + X9.f)./Init`.
std::string equation_text(const Equations& equations, ExprId id);

/// A smallest sum of products equal to the expression, found by Quine–McCluskey over its variables,
/// edges, time conditions and comparisons taken as atoms; no_expr where they are more than 10.
ExprId minimised(Expressions& pool, ExprId id);

}  // namespace grafwire
