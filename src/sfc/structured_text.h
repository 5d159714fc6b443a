#pragma once

#include <string>

#include "grafcet/grafcet.h"
#include "iec/operators.h"
#include "sfc/names.h"
#include "sfc/plan.h"

namespace grafwire::sfc {

/// Expressions and writes of a GRAFCET in Structured Text (IEC 61131-3), with the names of its
/// sequential function chart. Plan and names must outlive the writer.
///
/// An edge is written out, `(started AND dcy AND NOT dcy_before)`, and reads everything but inputs
/// as it was when the scan began: so it is the same wherever in the scan it is read.
class StructuredText {
  public:
    StructuredText(const Plan& plan, const Names& names)
        : grafcet_(*plan.grafcet), has_modes_(plan.has_modes), names_(names) {}

    /// With parentheses where another operator may stand beside it, if `as_operand`.
    std::string expression(ExprId id, const Reading& reading = {}, bool as_operand = false) const;
    /// A stored write, as a statement with its semicolon.
    std::string statement(const Write& write, const Reading& reading) const;
    std::string variable(Variable variable, const Reading& reading = {}) const;

  private:
    std::string beside(ExprId id, const Reading& reading, iec::Precedence above) const;
    std::string chain(ExprId id, const Reading& reading) const;
    std::string edge(ExprId id) const;
    std::string comparison(const Comparison& comparison, const Reading& reading) const;
    std::string sum(const Sum& sum, const Reading& reading) const;
    std::string any_step(Range<StepId> steps) const;

    const Grafcet& grafcet_;
    bool has_modes_;
    const Names& names_;
};

}  // namespace grafwire::sfc
