#pragma once

#include "grafcet/grafcet.h"
#include "logic/logic.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Reports what is worth a warning in a GRAFCET without errors.
void warn_about(const Grafcet& grafcet, Diagnostics& diagnostics);

/// Reports variables that several stored actions may write in the same scan.
void warn_conflicting_writes(const Grafcet& grafcet, Diagnostics& diagnostics);

/// For each expression whether it is 0 whatever its variables are.
class ConstantExpressions {
  public:
    explicit ConstantExpressions(const Grafcet& grafcet);
    bool is_never_true(ExprId id) const;

  private:
    Logic value_of(ExprId id) const;
    Logic value_of_comparison(const Comparison& comparison) const;
    Logic value_of_chain(ExprId id) const;

    const Grafcet& grafcet_;
    std::vector<Logic> values_;
};

}  // namespace grafwire
