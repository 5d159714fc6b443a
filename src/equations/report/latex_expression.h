#pragma once

#include <string>
#include <string_view>

#include "equations/equations.h"

namespace grafwire {

/// An expression in LaTeX's mathematical mode, with overlines for negations.
std::string latex_expression(const Grafcet& grafcet, const Expressions& expressions, ExprId id);

/// The name of a variable in mathematical mode: `X_{10}`, `m`, `\mathrm{dcy}`, `\text{H+}`.
std::string latex_name(const Grafcet& grafcet, Variable variable);

/// `\mathit{CAX}_{10}`; for X `X_{10}`.
std::string latex_of_step(const Grafcet& grafcet, std::string_view quantity, StepId step);

/// `\mathrm{pieces} + 1`
std::string latex_sum(const Grafcet& grafcet, const Sum& sum);

/// Words for LaTeX's text mode, special characters escaped.
std::string latex_words(std::string_view words);

}  // namespace grafwire
