// Actions become one equation per output, var or counter: all contributions meet before any gate is
// made, so none can be lost to a later one.
//
// Continuous actions are a sum. Stored actions are a list of writes in the order in which the
// reference evolution executes them, of which the last one that happens wins. For a Boolean target
// that order becomes an RS pair: a write sets (resets) it when its trigger and its value (not its
// value) are 1 and no later write happens. A later write of the same constant value need not be
// excluded, it has the same effect; this keeps the usual case `set(↑X1) reset(↑X3)` free of terms
// that only repeat each other.

#include "equations/derivation.h"

namespace grafwire {

void derive_outputs(const Grafcet& grafcet, Equations& equations) {
    Expressions& pool = equations.expressions;

    Table<OutputId, ExprId> sums(grafcet.outputs.size(), pool.constant(false));
    TermsByKey<OutputId> terms;
    for (const Action& action : grafcet.actions) {
        if (action.kind != ActionKind::continuous) continue;
        ExprId term = step_variable(pool, action.step);
        if (action.expression != no_expr) {
            term = and_of(pool, {term, translated(equations, action.expression)});
        }
        terms.add(action.output, term);
    }
    terms.consume([&](OutputId output, const std::vector<ExprId>& active) {
        sums[output] = or_of(pool, active);
    });

    for (std::size_t i = 0; i < grafcet.outputs.size(); ++i) {
        const OutputId id = grafcet.outputs.id_at(i);
        if (grafcet.outputs[id].stored) continue;
        const ExprId value = and_not_control(equations, sums[id], ControlInput::au_doux);
        equations.outputs.push_back({id, sums[id], value});
    }
    for (std::size_t i = 0; i < grafcet.vars.size(); ++i) {
        const VarId id = grafcet.vars.id_at(i);
        if (!grafcet.vars[id].is_held()) continue;
        equations.held.push_back({id, translated(equations, grafcet.vars[id].held)});
    }
}

namespace {

/// Where the writes to a variable are collected: outputs, then vars, then counters.
class Targets {
  public:
    explicit Targets(const Grafcet& grafcet)
        : first_var_(grafcet.outputs.size()),
          first_counter_(first_var_ + grafcet.vars.size()),
          writes_(first_counter_ + grafcet.counters.size()) {}

    std::vector<StoredWrite>& operator[](Variable target) {
        const std::size_t first = target.kind == VariableKind::output ? 0
                                  : target.kind == VariableKind::var  ? first_var_
                                                                      : first_counter_;
        return writes_[first + target.index];
    }

  private:
    std::size_t first_var_;
    std::size_t first_counter_;
    std::vector<std::vector<StoredWrite>> writes_;
};

/// What is written: `value` or `sum` of the write.
void add_written(const Grafcet& grafcet, const Equations& equations, const Write& write,
                 ExprId zero, ExprId one, StoredWrite& result) {
    if (write.sum != none) {
        result.sum = grafcet.sums[write.sum];
    } else if (write.operation == WriteOperation::assign) {
        result.value = translated(equations, write.value);
    } else {
        result.value = write.operation == WriteOperation::set ? one : zero;
    }
}

StoredWrite::Cause cause_of(Trigger trigger) {
    switch (trigger) {
        case Trigger::activation:
            return StoredWrite::Cause::activation;
        case Trigger::deactivation:
            return StoredWrite::Cause::deactivation;
        case Trigger::event:
            break;
    }
    return StoredWrite::Cause::event;
}

StoredWrite step_write(const Grafcet& grafcet, Equations& equations, const Action& action) {
    Expressions& pool = equations.expressions;
    StoredWrite write;
    write.cause = cause_of(action.trigger);
    write.step = action.step;
    write.where = action.where;
    const ExprId x = step_variable(pool, action.step);
    if (write.cause == StoredWrite::Cause::activation) {
        write.trigger = pool.rise(x);
    } else if (write.cause == StoredWrite::Cause::deactivation) {
        write.trigger = pool.fall(x);
    } else {
        write.event = translated(equations, action.expression);
        write.trigger = and_of(pool, {x, write.event});
    }
    add_written(grafcet, equations, action.write, pool.constant(false), pool.constant(true), write);
    return write;
}

/// Init keeps transitions from being cleared, and their actions from being run.
StoredWrite clearing_write(const Grafcet& grafcet, Equations& equations,
                           const ClearingAction& action) {
    Expressions& pool = equations.expressions;
    StoredWrite write;
    write.cause = StoredWrite::Cause::clearing;
    write.transition = action.transition;
    write.where = action.where;
    write.trigger =
        and_not_control(equations, equations.clearing[action.transition], ControlInput::init);
    add_written(grafcet, equations, action.write, pool.constant(false), pool.constant(true), write);
    return write;
}

/// In the order of execution: deactivation, clearing, activation, event.
Targets writes_by_target(const Grafcet& grafcet, Equations& equations) {
    Targets targets(grafcet);
    const auto add_of_steps = [&](Trigger trigger) {
        for (const Action& action : grafcet.actions) {
            if (action.kind != ActionKind::stored || action.trigger != trigger) continue;
            targets[action.write.target].push_back(step_write(grafcet, equations, action));
        }
    };
    add_of_steps(Trigger::deactivation);
    for (const ClearingAction& action : grafcet.clearing_actions) {
        targets[action.write.target].push_back(clearing_write(grafcet, equations, action));
    }
    add_of_steps(Trigger::activation);
    add_of_steps(Trigger::event);
    return targets;
}

/// The condition under which the variable ends up with `value`.
ExprId written_when(Expressions& pool, const std::vector<StoredWrite>& writes, bool value) {
    std::vector<ExprId> terms;
    ExprId later = pool.constant(false);  // triggers of later writes that may write the other value
    for (auto write = writes.rbegin(); write != writes.rend(); ++write) {
        const ExprId agrees = value ? write->value : not_of(pool, write->value);
        terms.push_back(and_of(pool, {write->trigger, agrees, not_of(pool, later)}));
        if (!is_constant(pool, agrees, true)) later = or_of(pool, {write->trigger, later});
    }
    std::reverse(terms.begin(), terms.end());
    return or_of(pool, terms);
}

}  // namespace

void derive_stored(const Grafcet& grafcet, Equations& equations) {
    Expressions& pool = equations.expressions;
    Targets targets = writes_by_target(grafcet, equations);
    const auto add = [&](VariableKind kind, std::size_t index) {
        StoredEquation equation;
        equation.target = {kind, static_cast<std::uint32_t>(index)};
        equation.writes = std::move(targets[equation.target]);
        if (kind == VariableKind::counter && equation.writes.empty()) return;
        if (kind != VariableKind::counter) {
            equation.set = written_when(pool, equation.writes, true);
            equation.reset = written_when(pool, equation.writes, false);
        }
        equations.stored.push_back(std::move(equation));
    };
    for (std::size_t i = 0; i < grafcet.outputs.size(); ++i) {
        if (grafcet.outputs[grafcet.outputs.id_at(i)].stored) add(VariableKind::output, i);
    }
    for (std::size_t i = 0; i < grafcet.vars.size(); ++i) {
        if (!grafcet.vars[grafcet.vars.id_at(i)].is_held()) add(VariableKind::var, i);
    }
    for (std::size_t i = 0; i < grafcet.counters.size(); ++i) add(VariableKind::counter, i);
}

}  // namespace grafwire
