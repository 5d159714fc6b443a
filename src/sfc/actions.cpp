// Actions of a GRAFCET as action blocks of SFC (IEC 61131-3, section 2.6.4). Continuous ones are N,
// D or L; stored ones S or R, or statements on the pulse P1 of activation or P0 of deactivation, or
// on an event under N. The statements are right whether or not an action is executed once more
// after its step (the standard's final scan), and whether or not the P1 of an initial step is
// executed in the first scan, which a GRAFCET does not do.
//
// The end of a scan in the sequential function chart, in the order of the table method: time
// conditions (SBR 6), outputs with conditions (SBR 8); then what the next scan compares with. The
// operands of edges are kept from the outside inwards, since an outer one reads the edges within it
// as they were in this scan, and the copies after all of them.
//
// With two delays a TON runs while the operand and the value differ, one for either change: a
// return of the operand before the end stops it, as it must.

#include "sfc/actions.h"

#include <fmt/format.h>

#include <map>

#include "iec/literals.h"
#include "sfc/messages.h"

namespace grafwire::sfc {

namespace {

namespace say = messages::sfc;

std::string between(const std::string& condition, const std::string& statements) {
    std::string text = fmt::format("IF {} THEN\n", condition);
    for (std::size_t at = 0; at < statements.size();) {
        const std::size_t end = statements.find('\n', at) + 1;
        text += "  " + statements.substr(at, end - at);
        at = end;
    }
    return text + "END_IF;\n";
}

class ActionsOfStep {
  public:
    ActionsOfStep(const Plan& plan, const Names& names, StepId step)
        : plan_(plan), grafcet_(*plan.grafcet), names_(names), text_(plan, names), step_(step) {}

    std::vector<ActionBlockEntry> make() {
        const Step& step = grafcet_.steps[step_];
        for (const Action& action : grafcet_.actions_of(step)) add(action);
        if (!activation_.empty() && step.initial)
            activation_ = between(names_.started, activation_);
        if (!event_.empty()) event_ = between(names_.steps[index_of(step_)] + ".X", event_);
        // In the order in which a GRAFCET executes them.
        add_statements("P0", deactivation_);
        add_statements("P1", activation_);
        add_statements("N", event_);
        return std::move(actions_);
    }

  private:
    void add(const Action& action);
    void add_continuous(const Action& action, Form form);
    void add_statements(const char* qualifier, const std::string& statements) {
        if (!statements.empty()) actions_.push_back({qualifier, "", "", statements});
    }

    const Plan& plan_;
    const Grafcet& grafcet_;
    const Names& names_;
    StructuredText text_;
    StepId step_;
    std::vector<ActionBlockEntry> actions_;
    // Statements, each with its line end.
    std::string deactivation_;
    std::string activation_;
    std::string event_;
};

void ActionsOfStep::add_continuous(const Action& action, Form form) {
    const std::string& output = action.kind == ActionKind::held
                                    ? names_.vars[index_of(action.var)]
                                    : names_.outputs[index_of(action.output)];
    if (form == Form::non_stored) {
        actions_.push_back({"N", "", output, ""});
        return;
    }
    const Expressions& pool = grafcet_.expressions;
    const bool is_limited = form == Form::limited;
    const ExprId id = is_limited ? pool.operands(action.expression).front() : action.expression;
    actions_.push_back({is_limited ? "L" : "D",
                        iec::time_literal(pool.time_condition_of(id).on_delay), output, ""});
}

void ActionsOfStep::add(const Action& action) {
    const std::size_t index = plan_.index_of_action(action);
    const Form form = plan_.forms[index];
    if (form == Form::beyond || form == Form::observed || plan_.deferred[index]) return;
    if (action.kind == ActionKind::continuous || action.kind == ActionKind::held) {
        return add_continuous(action, form);
    }
    if (form == Form::set || form == Form::reset) {
        const char* qualifier = form == Form::set ? "S" : "R";
        actions_.push_back({qualifier, "", text_.variable(action.write.target), ""});
        return;
    }
    const Reading reading = plan_.reading_of(index);
    const std::string statement = text_.statement(action.write, reading);
    if (form == Form::deactivation) deactivation_ += statement + "\n";
    if (form == Form::activation) activation_ += statement + "\n";
    if (form != Form::event) return;
    event_ += fmt::format("IF {} THEN {} END_IF;\n", text_.expression(action.expression, reading),
                          statement);
}

class Observer {
  public:
    Observer(const Plan& plan, const Names& names, Language language)
        : plan_(plan),
          grafcet_(*plan.grafcet),
          names_(names),
          text_(plan, names),
          language_(language) {}

    std::string make() {
        begin(say::deferred_actions);
        for (const Trigger trigger : {Trigger::deactivation, Trigger::activation, Trigger::event}) {
            execute_deferred(trigger);
        }
        begin(say::times_for_next_scan);
        for (std::size_t i = 0; i < plan_.times.size(); ++i) {
            if (plan_.times[i]) time_condition(i);
        }
        begin(say::outputs_with_conditions);
        assign_outputs();
        begin(say::compared_next);
        for (auto item = names_.before.rbegin(); item != names_.before.rend(); ++item) {
            assign(item->second, text_.expression(item->first, reading_at_start));
        }
        for (const auto& [variable, name] : names_.copies) assign(name, text_.variable(variable));
        for (const auto& [i, name] : names_.time_copies) assign(name, names_.times[i]);
        if (plan_.has_start_bit) assign(names_.started, "TRUE");
        return std::move(text_so_far_);
    }

  private:
    /// A heading, where anything follows under it.
    void begin(const Message<>& heading) { heading_ = heading.in(language_); }
    void add(const std::string& line) {
        if (!heading_.empty()) text_so_far_ += "(* " + heading_ + " *)\n";
        heading_.clear();
        text_so_far_ += line + "\n";
    }
    void assign(const std::string& name, const std::string& value) {
        add(fmt::format("{} := {};", name, value));
    }
    void execute_deferred(Trigger trigger);
    void time_condition(std::size_t i);
    void assign_outputs();

    const Plan& plan_;
    const Grafcet& grafcet_;
    const Names& names_;
    StructuredText text_;
    Language language_;
    std::string text_so_far_;
    std::string heading_;
};

/// The stored actions of a trigger, where `observe` executes them.
void Observer::execute_deferred(Trigger trigger) {
    for (std::size_t a = 0; a < grafcet_.actions.size(); ++a) {
        const Action& action = grafcet_.actions[a];
        if (!plan_.deferred[a] || action.trigger != trigger) continue;
        const Reading reading = plan_.reading_of(a);
        const std::string now = names_.steps[index_of(action.step)] + ".X";
        std::string condition = now;
        if (trigger == Trigger::event) {
            condition += " AND " + text_.expression(action.expression, reading, true);
        } else {
            const Variable step{VariableKind::step, static_cast<std::uint32_t>(action.step)};
            const std::string& then = names_.copies.at(step);
            condition = trigger == Trigger::activation ? fmt::format("{} AND NOT {}", now, then)
                                                       : fmt::format("NOT {} AND {}", now, then);
        }
        add(fmt::format("IF {} THEN {} END_IF;", condition,
                        text_.statement(action.write, reading)));
    }
}

void Observer::time_condition(std::size_t i) {
    const Expressions& pool = grafcet_.expressions;
    const TimeCondition& condition = pool.time_condition_of(pool.time_conditions()[i]);
    const std::string& bit = names_.times[i];
    const auto start_timer = [&](const std::string& timer, const std::string& input, Time delay) {
        add(fmt::format("{}(IN := {}, PT := {});", timer, input, iec::time_literal(delay)));
    };
    const std::string& timer = names_.timers[i];
    if (condition.off_delay == 0) {
        start_timer(timer, text_.expression(condition.operand), condition.on_delay);
        assign(bit, timer + ".Q");
        return;
    }
    const std::string operand = text_.expression(condition.operand, {}, true);
    const std::string& off_timer = names_.off_timers[i];
    start_timer(timer, fmt::format("{} AND NOT {}", operand, bit), condition.on_delay);
    add(fmt::format("IF {}.Q THEN {} := TRUE; END_IF;", timer, bit));
    start_timer(off_timer, fmt::format("NOT {} AND {}", operand, bit), condition.off_delay);
    add(fmt::format("IF {}.Q THEN {} := FALSE; END_IF;", off_timer, bit));
}

void Observer::assign_outputs() {
    std::map<OutputId, std::string> outputs;
    std::map<VarId, std::string> vars;
    for (const Action& action : grafcet_.actions) {
        const bool is_held = action.kind == ActionKind::held;
        if (!is_held && action.kind != ActionKind::continuous) continue;
        if (!is_held && plan_.observed_outputs.count(action.output) == 0) continue;
        std::string& value = is_held ? vars[action.var] : outputs[action.output];
        if (!value.empty()) value += " OR ";
        const std::string active = names_.steps[index_of(action.step)] + ".X";
        value +=
            action.expression == no_expr
                ? active
                : fmt::format("({} AND {})", active, text_.expression(action.expression, {}, true));
    }
    for (const auto& [output, value] : outputs) assign(names_.outputs[index_of(output)], value);
    for (const auto& [var, value] : vars) assign(names_.vars[index_of(var)], value);
}

}  // namespace

std::vector<ActionBlockEntry> actions_of(const Plan& plan, const Names& names, StepId step) {
    if (index_of(step) >= plan.grafcet->steps.size()) return {};
    return ActionsOfStep(plan, names, step).make();
}

std::string notes_of(const Plan& plan, const Names& names, StepId step, Language language) {
    const Grafcet& grafcet = *plan.grafcet;
    if (index_of(step) >= grafcet.steps.size()) return {};
    const StructuredText text(plan, names);
    std::string notes;
    for (const Action& action : grafcet.actions_of(grafcet.steps[step])) {
        const std::size_t index = plan.index_of_action(action);
        if (plan.forms[index] != Form::observed && !plan.deferred[index]) continue;
        const std::string target =
            action.kind == ActionKind::held         ? names.vars[index_of(action.var)]
            : action.kind == ActionKind::continuous ? names.outputs[index_of(action.output)]
                                                    : text.variable(action.write.target);
        const bool is_conditional =
            action.kind != ActionKind::stored && action.expression != no_expr;
        if (!notes.empty()) notes += '\n';
        notes += is_conditional
                     ? say::assigned_elsewhere_if.in(
                           language, target, text.expression(action.expression), names.observer)
                     : say::assigned_elsewhere.in(language, target, names.observer);
    }
    return notes;
}

std::string observer_text(const Plan& plan, const Names& names, Language language) {
    return Observer(plan, names, language).make();
}

}  // namespace grafwire::sfc
