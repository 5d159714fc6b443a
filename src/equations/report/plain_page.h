#pragma once

#include "equations/report/page.h"

namespace grafwire {

/// A page whose formulas are in the notation of the `.grafcet` language.
class PlainPage : public Page {
  public:
    PlainPage(const Grafcet& grafcet, const Expressions& pool) : grafcet_(grafcet), pool_(pool) {}

    std::string expression(ExprId id) const override;
    std::string name(Variable variable) const override;
    std::string of_step(std::string_view quantity, StepId step) const override;
    std::string held(StepId step) const override;
    std::string write(Variable target, const StoredWrite& write) const override;

  private:
    const Grafcet& grafcet_;
    const Expressions& pool_;
};

}  // namespace grafwire
