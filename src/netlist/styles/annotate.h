#pragma once

#include <string>
#include <vector>

#include "equations/equations.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Writes the equation that a module was made from into its comment: of steps, outputs, stored
/// outputs and vars.
void annotate(Netlist& netlist, const Grafcet& grafcet, const Equations& equations);

/// Writes the equations of steps one after the other, in a pool that is emptied each time: the cost
/// of a million steps is that of one, a million times.
class StepTexts {
  public:
    /// What it refers to must outlive it.
    StepTexts(const Grafcet& grafcet, const Equations& equations, std::size_t most_operands)
        : grafcet_(grafcet), equations_(equations), most_operands_(most_operands) {}

    /// `X0 = (X2.b + /X1.X0 + Init)./AUdur`; empty where that would take more operands.
    std::string equation(StepId step);

  private:
    /// An expression of the equations in the own pool; no_expr stays so. Counts its operands.
    ExprId copy(ExprId id);

    const Grafcet& grafcet_;
    const Equations& equations_;
    std::size_t most_operands_;
    Expressions pool_;
    std::size_t operands_ = 0;
};

}  // namespace grafwire
