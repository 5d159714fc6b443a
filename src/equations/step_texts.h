#pragma once

#include <string>
#include <vector>

#include "equations/equations.h"

namespace grafwire {

/// Writes the equations of steps one after the other, as equation_text writes step_expression, but
/// in a pool of its own that is emptied each time: the equations stay as they are, and the cost of
/// a million steps is that of one, a million times.
class StepTexts {
  public:
    explicit StepTexts(const Equations& equations) : equations_(equations) {}

    /// `X0 = (X2.b + /X1.X0 + Init)./AUdur`; empty where that would take more than `longest`
    /// operands.
    std::string equation(StepId step);

    static constexpr std::size_t longest = 256;

  private:
    /// An expression of the equations in the own pool; no_expr stays so. Counts its operands.
    ExprId copy(ExprId id);

    const Equations& equations_;
    Expressions pool_;
    std::size_t operands_ = 0;
};

}  // namespace grafwire
