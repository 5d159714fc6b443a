#pragma once

#include <set>
#include <utility>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire::sfc {

/// What can be seen not to happen in one scan. Only what is evident from the shape of the chart
/// counts: a "no" means that it was not seen.
class Exclusion {
  public:
    explicit Exclusion(const Grafcet& grafcet);

    /// A sequence has one initial step, transitions with one step before and one after each, and
    /// nothing that forces or encloses it: as an SFC it has exactly one active step at any time.
    bool is_sequence(GraphId graph) const { return sequences_[index_of(graph)]; }
    /// Two stored actions of steps that never act in the same scan.
    bool never_meet(const Action& a, const Action& b) const;
    /// Two transitions of which never both can be cleared: each condition asks for something whose
    /// negation the other asks for, or one is never true.
    bool never_both(const Transition& a, const Transition& b) const;
    /// Whether a transition leads from a step to another, or back to the same.
    bool leads_to(StepId from, StepId to) const { return links_.count({from, to}) > 0; }

  private:
    const Grafcet& grafcet_;
    std::vector<bool> sequences_;  ///< per graph
    std::set<std::pair<StepId, StepId>> links_;
};

}  // namespace grafwire::sfc
