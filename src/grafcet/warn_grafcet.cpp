// A step can be activated if it is initial, if a transition whose preceding steps can all be active
// leads to it, if a forcing order of such a step names it, or if it is an activation link of such a
// step. The set of these steps grows from the initial ones until nothing is added; each transition
// counts down its preceding steps, so every link is looked at once.

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/messages.h"
#include "grafcet/warnings.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

class Reachability {
  public:
    Reachability(const Grafcet& grafcet, const ConstantExpressions& constants)
        : grafcet_(grafcet),
          first_transition_(grafcet.steps.size() + 1, 0),
          missing_(grafcet.transitions.size(), 0),
          reached_(grafcet.steps.size(), false) {
        index_transitions(constants);
        for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
            if (missing_[i] == 0) fire(static_cast<TransitionId>(i));
        }
        follow_open();
        // From each initial step as far as it leads before the next: near steps are met together.
        for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
            if (!grafcet.steps.items()[i].initial) continue;
            reach(static_cast<StepId>(i));
            follow_open();
        }
    }

    bool is_reached(std::size_t step) const { return reached_[step]; }

  private:
    void index_transitions(const ConstantExpressions& constants) {
        for (const Transition& transition : grafcet_.transitions) {
            for (const StepId step : grafcet_.preceding(transition)) {
                ++first_transition_[index_of(step) + 1];
            }
        }
        for (std::size_t i = 1; i < first_transition_.size(); ++i) {
            first_transition_[i] += first_transition_[i - 1];
        }
        transitions_.resize(first_transition_.back());
        std::vector<std::uint32_t> next(first_transition_.begin(), first_transition_.end() - 1);
        for (std::size_t i = 0; i < grafcet_.transitions.size(); ++i) {
            const Transition& transition = grafcet_.transitions.items()[i];
            missing_[i] = transition.preceding.count;
            if (constants.is_never_true(transition.condition)) ++missing_[i];
            for (const StepId step : grafcet_.preceding(transition)) {
                transitions_[next[index_of(step)]++] = static_cast<TransitionId>(i);
            }
        }
    }

    void reach(StepId step) {
        if (reached_[index_of(step)]) return;
        reached_[index_of(step)] = true;
        open_.push_back(step);
    }

    /// All steps before it are reached, and it may be cleared.
    void fire(TransitionId transition) {
        for (const StepId step : grafcet_.following(grafcet_.transitions[transition])) reach(step);
    }

    void follow_open() {
        while (!open_.empty()) {
            const StepId step = open_.back();
            open_.pop_back();
            follow(step);
        }
    }

    /// What an active step can bring about: transitions, activation links, forcing orders.
    void follow(StepId id) {
        for (std::uint32_t i = first_transition_[index_of(id)];
             i < first_transition_[index_of(id) + 1]; ++i) {
            if (--missing_[index_of(transitions_[i])] == 0) fire(transitions_[i]);
        }
        const Step& step = grafcet_.steps[id];
        if (step.enclosure != none) {
            for (const StepId link : grafcet_.enclosures[step.enclosure].links) reach(link);
        }
        for (const Action& action : grafcet_.actions_of(step)) {
            if (action.kind == ActionKind::order) {
                for (const StepId forced : grafcet_.orders[action.order].steps) reach(forced);
            }
        }
    }

    const Grafcet& grafcet_;
    std::vector<std::uint32_t> first_transition_;  ///< of each step in transitions_
    std::vector<TransitionId> transitions_;        ///< those after each step
    std::vector<std::uint32_t>
        missing_;  ///< preceding steps not reached yet, one more if never true
    std::vector<bool> reached_;
    std::vector<StepId> open_;
};

/// The graphs that have nothing to start with: no initial step, no forcing order, no enclosing step
/// and no source transition.
std::vector<bool> graphs_without_start(const Grafcet& grafcet) {
    std::vector<bool> result(grafcet.graphs.size(), true);
    for (const Step& step : grafcet.steps) {
        if (step.initial) result[index_of(step.graph)] = false;
    }
    for (const Order& order : grafcet.orders) {
        if (order.kind != OrderKind::freeze) result[index_of(order.graph)] = false;
    }
    for (const Enclosure& enclosure : grafcet.enclosures) result[index_of(enclosure.graph)] = false;
    for (const Transition& transition : grafcet.transitions) {
        if (transition.preceding.count == 0) result[index_of(transition.graph)] = false;
    }
    return result;
}

/// Steps that can never be active. In a graph without a start all are, which is said once.
void warn_steps(const Grafcet& grafcet, const ConstantExpressions& constants,
                Diagnostics& diagnostics) {
    const std::vector<bool> without_start = graphs_without_start(grafcet);
    for (std::size_t i = 0; i < grafcet.graphs.size(); ++i) {
        if (!without_start[i]) continue;
        const Graph& graph = grafcet.graphs.items()[i];
        diagnostics.warning(code::graph_without_start, grafcet.blocks[graph.block].where,
                            say::graph_without_start(quoted(graph.name)));
    }
    const Reachability reachability(grafcet, constants);
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const Step& step = grafcet.steps.items()[i];
        if (reachability.is_reached(i) || without_start[index_of(step.graph)]) continue;
        diagnostics.warning(code::unreachable_step, step.where,
                            say::unreachable_step(quoted(step.name)));
    }
}

/// Transitions that can never be cleared.
void warn_conditions(const Grafcet& grafcet, const ConstantExpressions& constants,
                     Diagnostics& diagnostics) {
    for (const Transition& transition : grafcet.transitions) {
        if (constants.is_never_true(transition.condition)) {
            diagnostics.warning(code::constant_receptivity, transition.where,
                                say::constant_receptivity(quoted(transition.name)));
        }
    }
}

/// For each expression whether it has an edge outside of time conditions.
std::vector<bool> expressions_with_edges(const Expressions& expressions) {
    std::vector<bool> result(expressions.size(), false);
    for (std::size_t i = 0; i < expressions.size(); ++i) {
        const auto id = static_cast<ExprId>(i);
        const ExprKind kind = expressions.kind(id);
        result[i] = kind == ExprKind::rise || kind == ExprKind::fall;
        for (const ExprId operand : expressions.operands(id)) {
            result[i] = result[i] || result[index_of(operand)];
        }
    }
    return result;
}

/// An event without an edge happens in every scan in which its expression is 1.
void warn_events(const Grafcet& grafcet, Diagnostics& diagnostics) {
    const std::vector<bool> has_edge = expressions_with_edges(grafcet.expressions);
    for (const Action& action : grafcet.actions) {
        if (action.kind != ActionKind::stored || action.trigger != Trigger::event) continue;
        if (has_edge[index_of(action.expression)]) continue;
        diagnostics.warning(code::event_without_edge, action.where, say::event_without_edge());
    }
}

/// Declared and neither read nor written.
void warn_unused_names(const Grafcet& grafcet, Diagnostics& diagnostics) {
    std::vector<bool> used[5] = {std::vector<bool>(grafcet.inputs.size()),
                                 {},
                                 std::vector<bool>(grafcet.outputs.size()),
                                 std::vector<bool>(grafcet.vars.size()),
                                 std::vector<bool>(grafcet.counters.size())};
    const auto use = [&used](Variable variable) {
        if (variable.kind != VariableKind::control && variable.kind <= VariableKind::counter) {
            used[static_cast<std::size_t>(variable.kind)][variable.index] = true;
        }
    };
    const auto use_sum = [&use](const Sum& sum) {
        for (const SumTerm& term : sum) {
            if (term.counter != SumTerm::no_counter) use({VariableKind::counter, term.counter});
        }
    };
    for (std::size_t i = 0; i < grafcet.expressions.size(); ++i) {
        const auto id = static_cast<ExprId>(i);
        if (grafcet.expressions.kind(id) == ExprKind::variable) {
            use(grafcet.expressions.variable_of(id));
        }
        if (grafcet.expressions.kind(id) != ExprKind::comparison) continue;
        use_sum(grafcet.expressions.comparison_of(id).left);
        use_sum(grafcet.expressions.comparison_of(id).right);
    }
    for (const Sum& sum : grafcet.sums) use_sum(sum);
    for (const Action& action : grafcet.actions) {
        if (action.kind == ActionKind::continuous) {
            use({VariableKind::output, static_cast<std::uint32_t>(action.output)});
        }
        if (action.kind == ActionKind::held)
            use({VariableKind::var, static_cast<std::uint32_t>(action.var)});
        if (action.kind == ActionKind::stored) use(action.write.target);
    }
    for (const ClearingAction& action : grafcet.clearing_actions) use(action.write.target);

    const auto warn = [&](const Message<Localized>& message, const auto& items, VariableKind kind) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (!used[static_cast<std::size_t>(kind)][i]) {
                diagnostics.warning(code::unused_name, items.items()[i].where,
                                    message(quoted(items.items()[i].name)));
            }
        }
    };
    warn(say::input_unused, grafcet.inputs, VariableKind::input);
    warn(say::output_unused, grafcet.outputs, VariableKind::output);
    warn(say::var_unused, grafcet.vars, VariableKind::var);
    warn(say::counter_unused, grafcet.counters, VariableKind::counter);
}

}  // namespace

void warn_about(const Grafcet& grafcet, Diagnostics& diagnostics) {
    const ConstantExpressions constants(grafcet);
    warn_steps(grafcet, constants, diagnostics);
    warn_conditions(grafcet, constants, diagnostics);
    warn_events(grafcet, diagnostics);
    warn_unused_names(grafcet, diagnostics);
    warn_conflicting_writes(grafcet, diagnostics);
}

}  // namespace grafwire
