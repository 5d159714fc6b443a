// What the sequential function chart needs besides steps and transitions.
//
// Every action first gets the plainest form that is exact, in every reading of the standard that we
// met: qualifiers for what they say, statements on a pulse for the rest. Two cautions:
// - S and R act as long as their step is active, a stored action of GRAFCET only on activation. The
//   two are the same where all that writes the variable are S and R of one sequence.
// - The time of D and L may restart when a step is left and entered in one scan, or may not; a
//   step of a sequence that does not lead back to itself leaves no doubt.
// Then all expressions are walked through, to find which edges, time conditions and copies they
// ask for; copies serve where a variable is read that may have been written earlier in the scan.

#include "sfc/plan.h"

#include <algorithm>
#include <map>
#include <utility>

namespace grafwire::sfc {

namespace {

class Planner {
  public:
    Planner(const Grafcet& grafcet, bool has_modes)
        : grafcet_(grafcet), plan_(grafcet, has_modes) {}

    Plan make() {
        for (std::size_t a = 0; a < grafcet_.actions.size(); ++a) {
            const Action& action = grafcet_.actions[a];
            if (action.kind == ActionKind::continuous) drivers_[action.output].push_back(a);
            if (action.kind == ActionKind::held) {
                plan_.forms[a] = Form::observed;
                plan_.has_held_vars = true;
            }
            if (action.kind == ActionKind::stored) writers_[action.write.target].push_back(a);
        }
        for (const auto& [output, actions] : drivers_) choose_continuous(output, actions);
        choose_stored();
        find_meetings();
        defer_readers_of_steps();
        walk_all();
        return std::move(plan_);
    }

  private:
    void choose_continuous(OutputId output, const std::vector<std::size_t>& actions);
    Form continuous_form(const Action& action) const;
    void choose_stored();
    bool has_latch_form(const std::vector<std::size_t>& writers) const;
    void find_meetings();
    void defer_readers_of_steps();
    bool meets_any(std::size_t action, const std::vector<std::size_t>& others) const;
    std::set<Variable> reads_of(const Action& action) const;
    void collect_reads(ExprId id, std::set<Variable>& reads) const;
    void collect_reads(const Sum& sum, std::set<Variable>& reads) const;

    void walk_all();
    void walk_stored(std::size_t action);
    void walk(ExprId id, const Reading& reading);
    void walk(const Sum& sum, const Reading& reading);
    void walk(Variable variable, const Reading& reading) {
        const bool is_control = variable.kind == VariableKind::control;
        if (is_control && plan_.has_modes) plan_.controls.insert(variable.index);
        if (reading.is_copy(variable)) plan_.copies.insert(variable);
    }

    const Grafcet& grafcet_;
    Plan plan_;
    std::map<OutputId, std::vector<std::size_t>> drivers_;  ///< its continuous actions
    std::map<Variable, std::vector<std::size_t>> writers_;
};

/// The time condition of a delayed or time-limited action of its own step.
Form Planner::continuous_form(const Action& action) const {
    const Expressions& pool = grafcet_.expressions;
    ExprId id = action.expression;
    if (id == no_expr) return Form::non_stored;
    const bool negated = pool.kind(id) == ExprKind::negation;
    if (negated) id = pool.operands(id).front();
    if (pool.kind(id) != ExprKind::time_condition) return Form::observed;
    const TimeCondition& condition = pool.time_condition_of(id);
    const bool is_own_step =
        condition.off_delay == 0 && pool.kind(condition.operand) == ExprKind::variable &&
        pool.variable_of(condition.operand) ==
            Variable{VariableKind::step, static_cast<std::uint32_t>(action.step)};
    if (!is_own_step || !plan_.exclusion.is_sequence(grafcet_.steps[action.step].graph) ||
        plan_.exclusion.leads_to(action.step, action.step)) {
        return Form::observed;
    }
    return negated ? Form::limited : Form::delayed;
}

/// Several delays of one output would need several timers in one control of an action: an error
/// (IEC 61131-3, 2.6.4.5).
void Planner::choose_continuous(OutputId output, const std::vector<std::size_t>& actions) {
    std::size_t timed = 0;
    bool is_observed = false;
    for (const std::size_t a : actions) {
        plan_.forms[a] = continuous_form(grafcet_.actions[a]);
        if (plan_.forms[a] == Form::observed) is_observed = true;
        if (plan_.forms[a] != Form::non_stored) ++timed;
    }
    if (!is_observed && timed <= 1) return;
    plan_.observed_outputs.insert(output);
    for (const std::size_t a : actions) plan_.forms[a] = Form::observed;
}

/// Whether the writes of a variable are all S and R of one sequence, none of them at the start.
bool Planner::has_latch_form(const std::vector<std::size_t>& writers) const {
    const Action& first = grafcet_.actions[writers.front()];
    const GraphId graph = grafcet_.steps[first.step].graph;
    if (!plan_.exclusion.is_sequence(graph)) return false;
    std::set<StepId> steps;
    for (const std::size_t a : writers) {
        const Action& action = grafcet_.actions[a];
        const Step& step = grafcet_.steps[action.step];
        if (action.trigger != Trigger::activation || step.initial || step.graph != graph ||
            action.write.operation == WriteOperation::assign || !steps.insert(action.step).second) {
            return false;
        }
    }
    return std::none_of(grafcet_.clearing_actions.begin(), grafcet_.clearing_actions.end(),
                        [&](const ClearingAction& clearing) {
                            return clearing.write.target == first.write.target;
                        });
}

void Planner::choose_stored() {
    for (std::size_t a = 0; a < grafcet_.actions.size(); ++a) {
        const Action& action = grafcet_.actions[a];
        if (action.kind != ActionKind::stored) continue;
        plan_.forms[a] = action.trigger == Trigger::activation     ? Form::activation
                         : action.trigger == Trigger::deactivation ? Form::deactivation
                                                                   : Form::event;
    }
    for (const auto& [target, actions] : writers_) {
        if (!has_latch_form(actions)) continue;
        for (const std::size_t a : actions) {
            const bool sets = grafcet_.actions[a].write.operation == WriteOperation::set;
            plan_.forms[a] = sets ? Form::set : Form::reset;
        }
    }
}

void Planner::collect_reads(const Sum& sum, std::set<Variable>& reads) const {
    for (const SumTerm& term : sum) {
        if (term.counter != SumTerm::no_counter)
            reads.insert({VariableKind::counter, term.counter});
    }
}

/// What is read as it is now: edges and time conditions are not.
void Planner::collect_reads(ExprId id, std::set<Variable>& reads) const {
    const Expressions& pool = grafcet_.expressions;
    switch (pool.kind(id)) {
        case ExprKind::variable:
            reads.insert(pool.variable_of(id));
            return;
        case ExprKind::comparison:
            collect_reads(pool.comparison_of(id).left, reads);
            collect_reads(pool.comparison_of(id).right, reads);
            return;
        case ExprKind::rise:
        case ExprKind::fall:
        case ExprKind::time_condition:
            return;
        default:
            for (const ExprId operand : pool.operands(id)) collect_reads(operand, reads);
    }
}

std::set<Variable> Planner::reads_of(const Action& action) const {
    std::set<Variable> reads;
    if (action.trigger == Trigger::event) collect_reads(action.expression, reads);
    if (action.write.operation != WriteOperation::assign) return reads;
    if (action.write.target.kind == VariableKind::counter) {
        collect_reads(grafcet_.sums[action.write.sum], reads);
    } else {
        collect_reads(action.write.value, reads);
    }
    return reads;
}

void Planner::find_meetings() {
    std::map<Variable, std::set<std::size_t>> meetings;
    for (std::size_t a = 0; a < grafcet_.actions.size(); ++a) {
        const Action& action = grafcet_.actions[a];
        if (action.kind != ActionKind::stored) continue;
        for (const Variable variable : reads_of(action)) {
            const auto written = writers_.find(variable);
            if (written != writers_.end() && meets_any(a, written->second)) {
                plan_.copied_reads[a].insert(variable);
            }
        }
        for (const std::size_t b : writers_[action.write.target]) {
            const Action& other = grafcet_.actions[b];
            // Writes of one step on one event are statements one below the other.
            const bool are_one = action.step == other.step && plan_.forms[a] == plan_.forms[b];
            if (!are_one && !plan_.exclusion.never_meet(action, other)) {
                meetings[action.write.target].insert({a, b});
            }
        }
    }
    for (const auto& [target, actions] : meetings) plan_.meetings.push_back({target, actions});
}

/// All actions of a step on one event are executed together.
void Planner::defer_readers_of_steps() {
    std::set<std::pair<StepId, Trigger>> readers;
    for (const Action& action : grafcet_.actions) {
        if (action.kind != ActionKind::stored) continue;
        const Variable own{VariableKind::step, static_cast<std::uint32_t>(action.step)};
        for (const Variable variable : reads_of(action)) {
            if (!Reading::is_activity(variable.kind) || variable == own) continue;
            readers.emplace(action.step, action.trigger);
        }
    }
    for (std::size_t a = 0; a < grafcet_.actions.size(); ++a) {
        const Action& action = grafcet_.actions[a];
        const Form form = plan_.forms[a];
        if (form != Form::activation && form != Form::deactivation && form != Form::event) continue;
        if (readers.count({action.step, action.trigger}) == 0) continue;
        plan_.deferred[a] = true;
        plan_.has_deferred = true;
        if (form == Form::event) continue;
        plan_.copies.insert({VariableKind::step, static_cast<std::uint32_t>(action.step)});
    }
}

/// Whether an action can meet another one of a list in one scan.
bool Planner::meets_any(std::size_t action, const std::vector<std::size_t>& others) const {
    return std::any_of(others.begin(), others.end(), [&](std::size_t other) {
        return other != action &&
               !plan_.exclusion.never_meet(grafcet_.actions[action], grafcet_.actions[other]);
    });
}

void Planner::walk(const Sum& sum, const Reading& reading) {
    for (const SumTerm& term : sum) {
        if (term.counter == SumTerm::no_counter) continue;
        walk(Variable{VariableKind::counter, term.counter}, reading);
    }
}

void Planner::walk(ExprId id, const Reading& reading) {
    const Expressions& pool = grafcet_.expressions;
    switch (pool.kind(id)) {
        case ExprKind::variable:
            return walk(pool.variable_of(id), reading);
        case ExprKind::comparison:
            walk(pool.comparison_of(id).left, reading);
            return walk(pool.comparison_of(id).right, reading);
        case ExprKind::rise:
        case ExprKind::fall: {
            plan_.has_start_bit = true;
            if (plan_.edges[pool.ordinal(id)]) return;
            plan_.edges[pool.ordinal(id)] = true;
            return walk(pool.operands(id).front(), reading_at_start);
        }
        case ExprKind::time_condition: {
            const std::size_t ordinal = pool.ordinal(id);
            if (reading.at_start) plan_.time_copies.insert(ordinal);
            if (plan_.times[ordinal]) return;
            plan_.times[ordinal] = true;
            return walk(pool.time_condition_of(id).operand, Reading());
        }
        default:
            for (const ExprId operand : pool.operands(id)) walk(operand, reading);
    }
}

void Planner::walk_stored(std::size_t a) {
    const Action& action = grafcet_.actions[a];
    const Reading reading = plan_.reading_of(a);
    if (action.trigger == Trigger::event) walk(action.expression, reading);
    const bool is_initial = grafcet_.steps[action.step].initial;
    const bool is_pulse = action.trigger == Trigger::activation && !plan_.deferred[a];
    if (is_pulse && is_initial) plan_.has_start_bit = true;
    if (action.write.operation != WriteOperation::assign) return;
    if (action.write.target.kind == VariableKind::counter) {
        walk(grafcet_.sums[action.write.sum], reading);
    } else {
        walk(action.write.value, reading);
    }
}

void Planner::walk_all() {
    for (const Transition& transition : grafcet_.transitions) {
        walk(transition.condition, reading_before_evolution);
    }
    for (std::size_t a = 0; a < grafcet_.actions.size(); ++a) {
        const Action& action = grafcet_.actions[a];
        if (action.kind == ActionKind::stored) walk_stored(a);
        if (plan_.forms[a] == Form::observed && action.expression != no_expr) {
            walk(action.expression, Reading());
        }
    }
}

}  // namespace

bool Plan::has_observer() const {
    return has_start_bit || has_deferred || has_held_vars || !observed_outputs.empty() ||
           !copies.empty() || std::find(times.begin(), times.end(), true) != times.end();
}

Plan plan_of(const Grafcet& grafcet, bool has_modes) {
    return Planner(grafcet, has_modes).make();
}

}  // namespace grafwire::sfc
