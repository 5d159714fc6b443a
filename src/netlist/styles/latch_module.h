#pragma once

#include <string>
#include <vector>

#include "netlist/styles/asynchronous.h"

namespace grafwire {

/// The head of a step module whose memory is two cross-coupled gates, X and its other half:
///
///     X  = gate(x terms, other half)
///     X$q = gate(other terms, X)
class LatchModule {
  public:
    LatchModule(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates)
        : build_(build), step_(step), gates_(gates) {}

  protected:
    bool has_modes() const { return step_.init != no_net; }
    std::string set_role(TransitionId into) const {
        return "set" + build_.grafcet.transitions[into].name;
    }

    void cross_couple(CellType type, std::vector<NetId> x_terms, std::vector<NetId> other_terms) {
        const NetId other = gates_.add_net("q");
        x_terms.push_back(other);
        gates_.drive(step_.x, type, x_terms);
        other_terms.push_back(step_.x);
        gates_.drive(other, type, other_terms);
        if (!has_modes()) gates_.builder().set_initial(other, !step_.initial);
    }

    AsynchronousBuild& build_;
    const StepSignals& step_;
    const GateMaker& gates_;
    std::vector<NetId> sets_;
    std::vector<NetId> resets_;
};

}  // namespace grafwire
