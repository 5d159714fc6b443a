#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

/// How CDX is derived (course "Mise en œuvre du GRAFCET", section 1.2).
enum class CdxForm {
    successor,   ///< OR over the transitions out of the step of (AND of the X that follow): the
                 ///< wiring form
    transition,  ///< OR over the transitions out of the step of (AND of the X that precede) .
                 ///< transition condition
};

struct EquationOptions {
    CdxForm cdx = CdxForm::successor;
    bool modes = true;  ///< with Init, AUdur and AUdoux
};

/// The equation of a step, in parts (step_expression puts them together). Absent parts are no_expr.
/// None is constant unless said so.
///
///   core = CAX + /CDX.X                    (+ Init for an initial step, ./Init for another)
///   X    = (((core . /forced_off) + forced_on) . enclosing + link) . /AUdur
struct StepEquation {
    bool initial = false;  ///< whether Init activates the step
    /// Without Init; the constant 0 where nothing activates the step, 1 where a source transition
    /// with the transition condition 1 leads to it.
    ExprId cax = no_expr;
    ExprId cdx = no_expr;         ///< without Init; the constant 0 where nothing deactivates it
    ExprId forced_off = no_expr;  ///< OR of the X that force the step's graph
    ExprId forced_on = no_expr;   ///< OR of the X whose orders list the step
    ExprId enclosing = no_expr;   ///< X of the step that encloses the graph
    ExprId link = no_expr;  ///< ↑X of that step . /(orders on the graph) [. /Init]: activation link
};

/// A continuous output: OR over the actions of X . condition, [. /AUdoux]. A condition that is 1
/// leaves X alone.
struct OutputEquation {
    OutputId output{};
    ExprId sum = no_expr;  ///< without AUdoux; the constant 0 where nothing drives the output
    ExprId value = no_expr;
};

/// What makes one write happen, and what is written. Writes stand in the order of their execution
/// (deactivation, clearing, activation, event; then file order): the last one that happens wins.
struct StoredWrite {
    enum class Cause { deactivation, clearing, activation, event };
    Cause cause = Cause::activation;
    StepId step{};              ///< of the action (all causes but clearing)
    TransitionId transition{};  ///< of the action on clearing
    ExprId event = no_expr;     ///< cause event: the expression, without its step
    ExprId trigger = no_expr;   ///< ↓X, the clearing condition [. /Init], ↑X, or X . event
    ExprId value = no_expr;     ///< written to an output or var: an expression, perhaps constant
    Sum sum;                    ///< written to a counter; empty for outputs and vars
    Location where;
};

/// A var that steps hold: an internal bit, which AUdoux leaves alone.
struct HeldEquation {
    VarId var{};
    ExprId value = no_expr;
};

/// A stored output, var or counter with all the writes to it (a var may have none).
///
///   set   = OR over the writes of trigger . value  . /(triggers of later writes)
///   reset = OR over the writes of trigger . /value . /(triggers of later writes)
///
/// where later writes of the same constant value are left out: they change nothing. Set and reset
/// are never 1 together; where no write sets (resets), they are the constant 0.
struct StoredEquation {
    Variable target;
    std::vector<StoredWrite> writes;
    ExprId set = no_expr;  ///< no_expr for counters
    ExprId reset = no_expr;
};

/// The equations of a GRAFCET. All expressions live in `expressions`, a pool of its own: an id of
/// the GRAFCET's pool means nothing here, from_grafcet translates it. Names stand in the GRAFCET
/// alone, and an expression is written by write_expression with both.
///
/// Variables of macro-steps and graphs do not occur: they are written out as the OR of their steps.
/// No expression holds a term that is constant; but the operand of a time condition may be 1.
///
/// Every edge and every time condition of the GRAFCET has the same ordinal here, whatever became of
/// its operand (those that turn out to be constantly 0 keep their place, unused). Edges of steps
/// that only triggers and activation links need come after them.
struct Equations {
    EquationOptions options;
    Expressions expressions;
    /// Per expression of the GRAFCET's pool: what it is here, perhaps a constant.
    std::vector<ExprId> from_grafcet;

    /// Per transition: AND of the X that precede . transition condition . /(OR of the X that freeze
    /// the graph), as one flat conjunction; Init is not in it. The constant 0 where the transition
    /// condition is.
    Table<TransitionId, ExprId> clearing;
    /// Per transition: the transition condition alone, gated by the freezing steps; may be
    /// constant.
    Table<TransitionId, ExprId> transition_conditions;
    /// Per graph: OR of the X that freeze it, or no_expr.
    Table<GraphId, ExprId> frozen;
    Table<StepId, StepEquation> steps;
    /// Continuous and undriven outputs, in the order declared.
    std::vector<OutputEquation> outputs;
    /// In the order declared. Whoever reads such a var holds its value in place.
    std::vector<HeldEquation> held;
    /// Stored outputs, then all vars with a memory, then counters that are written.
    std::vector<StoredEquation> stored;
};

/// Derives the equations; every GRAFCET has them. The time is that of reading it: about linear in
/// the size of the text.
Equations equations_from(const Grafcet& grafcet, const EquationOptions& options);

/// CAX and CDX of a step as tabulated: with Init where there are modes.
struct TableConditions {
    ExprId cax = no_expr;
    ExprId cdx = no_expr;
};

// What no field of the equations holds, because it would cost memory for every step, is built on
// request in a pool given: the equations' own or a copy of it that has grown.

/// CAX and CDX of a step as tabulated: `CAX + Init`, `CDX./Init` of an initial one.
TableConditions table_conditions(const Equations& equations, StepId step, Expressions& pool);

/// The whole right-hand side of a step: `(X2.b + /X1.X0 + Init)./AUdur`.
ExprId step_expression(const Equations& equations, StepId step, Expressions& pool);

/// `S + /R.v` of a stored output or var; the constant 0 where nothing writes it. Not for counters.
ExprId stored_expression(const StoredEquation& stored, Expressions& pool);

/// The parts of the equation of a step put together; they live in the pool given.
ExprId combined(Expressions& pool, const StepEquation& parts, StepId step, bool modes);

/// The transitions into and out of every step, in table order.
struct StepTransitions {
    std::vector<std::uint32_t> first_into;  ///< size steps + 1: ranges of `into`
    std::vector<TransitionId> into;
    std::vector<std::uint32_t> first_out_of;  ///< size steps + 1: ranges of `out_of`
    std::vector<TransitionId> out_of;

    std::span<const TransitionId> into_step(StepId step) const;
    std::span<const TransitionId> out_of_step(StepId step) const;
};
StepTransitions transitions_by_step(const Grafcet& grafcet);

}  // namespace grafwire
