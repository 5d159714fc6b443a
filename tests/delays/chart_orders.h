#pragma once

#include <map>
#include <memory>
#include <vector>

#include "delays/delay_cases.h"

namespace grafwire::testing {

/// The chart itself run in every order: from each situation any of the transitions that can be
/// cleared are cleared, one or several, all other rules as in the reference. A netlist without a
/// common clock has nothing to answer for where that makes a difference.
class ChartOrders {
  public:
    explicit ChartOrders(const Grafcet& grafcet);
    ~ChartOrders();

    /// Whether the outcome of a case depends on the order, or a transition that could be cleared no
    /// longer can be before it was its turn.
    bool depends_on_order(const ChartCase& item);

  private:
    struct Subset;
    struct Open;
    const Evolution& with_only(const std::vector<TransitionId>& transitions);
    bool is_withdrawn(const EvolutionState& before, const EvolutionState& after,
                      const InputValues& inputs, TransitionId id, const BitTable& expected) const;
    bool is_passing(const EvolutionState& state, GraphId graph, const BitTable& expected) const;
    bool arrives_where_one_leaves(const EvolutionState& state,
                                  const std::vector<TransitionId>& clearable,
                                  const std::vector<TransitionId>& cleared) const;
    bool is_overruled(const EvolutionState& state, GraphId graph) const;

    const Grafcet& grafcet_;
    Evolution evolution_;
    std::vector<std::vector<ExprId>> products_;  ///< per transition: its receptivity as a sum
    std::map<std::vector<TransitionId>, std::unique_ptr<Subset>> subsets_;
};

}  // namespace grafwire::testing
