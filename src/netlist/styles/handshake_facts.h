#pragma once

#include <map>
#include <optional>
#include <vector>

#include "equations/concurrent_steps.h"
#include "equations/equations.h"
#include "netlist/styles/handshake_writes.h"
#include "netlist/styles/receptivity.h"
#include "text/diagnostics.h"

namespace grafwire {

/// An edge of an input before a transition.
struct InputEdge {
    ExprId atom = no_expr;
    Literal level;  ///< what is 1 after it
};

/// What the handshake style knows of a chart before it wires it. The GRAFCET and the equations must
/// outlive it.
class HandshakeFacts {
  public:
    HandshakeFacts(const Grafcet& chart, const Equations& equations_of);

    const Grafcet& grafcet;
    const Equations& equations;
    const Expressions& pool;
    const StepTransitions transitions;
    const ConcurrentSteps concurrent;
    std::vector<ExprId> assumptions;
    /// Per transition its receptivity as a sum of products, in which edges are atoms; what is the
    /// same whenever the transition is enabled is left out.
    std::vector<std::vector<Product>> receptivities;
    std::map<StepId, InputEdge> edge_of;  ///< of the steps that are left on an edge
    Table<TransitionId, std::map<std::uint32_t, bool>> writes;

    const Transition& item(TransitionId id) const { return grafcet.transitions[id]; }
    ExprId translated(ExprId id) const {
        return equations.from_grafcet[static_cast<std::size_t>(id)];
    }
    /// Whether a forcing order activates the step.
    bool is_forced_on(const Order& order, StepId step) const;
    /// The edge, if the expression is one of an input.
    std::optional<InputEdge> edge_in(ExprId atom) const;
    /// The steps whose X occurs in the expression.
    std::vector<StepId> steps_in(ExprId id) const;
    /// Whether every product of the transition holds a time condition on the activity of the step:
    /// it becomes 1 by itself, when no other way out is open.
    bool waits_for(TransitionId id, StepId step) const;
    /// Whether the step may be entered while it is active, or be active together with a neighbour.
    bool needs_merge(StepId step) const;
    /// Whether a stored action writes the variable.
    bool is_written(Variable variable) const;
    /// Whether a step can come and go, or go and come back, within one evolution.
    bool may_pass(StepId step) const;
    /// Whether a token can come back to a step within one evolution, and stay there.
    bool can_return_to(StepId step) const;
    /// The products without the literals whose value is known whenever the transition is enabled.
    std::vector<Product> folded(TransitionId id, const std::vector<Product>& products) const;

  private:
    bool may_end(const Product& product) const;
    Product of_inputs(const Product& product) const;
    struct Search;
    bool can_return(Search& search, StepId from, const Product& so_far) const;
    std::optional<bool> constant_for(TransitionId id, StepId read) const;
};

/// Reads the chart. What receptivities and stored actions cannot have is reported.
HandshakeFacts read_for_handshake(const Grafcet& grafcet, const Equations& equations,
                                  Diagnostics& diagnostics);

}  // namespace grafwire
