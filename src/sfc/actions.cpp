// Actions of a GRAFCET as action blocks of SFC (IEC 61131-3, section 2.6.4). Continuous ones are N,
// D or L; stored ones S or R, or statements on the pulse P1 of activation or P0 of deactivation, or
// on an event under N. The statements are right whether or not an action is executed once more
// after its step (the standard's final scan), and whether or not the P1 of an initial step is
// executed in the first scan, which a GRAFCET does not do.

#include "sfc/actions.h"

#include <fmt/format.h>

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
    ActionsOfStep(const Plan& plan, const Names& names, StepId step, Language language)
        : plan_(plan),
          grafcet_(*plan.grafcet),
          names_(names),
          text_(plan, names),
          step_(step),
          language_(language) {}

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
    Language language_;
    std::vector<ActionBlockEntry> actions_;
    // Statements, each with its line end.
    std::string deactivation_;
    std::string activation_;
    std::string event_;
};

void ActionsOfStep::add_continuous(const Action& action, Form form) {
    const std::string& output = names_.outputs[index_of(action.output)];
    if (form == Form::observed) {
        const std::string comment =
            action.expression == no_expr
                ? say::assigned_elsewhere.in(language_, output, names_.observer)
                : say::assigned_elsewhere_if.in(
                      language_, output, text_.expression(action.expression), names_.observer);
        actions_.push_back({"N", "", "", fmt::format("(* {} *)", comment)});
        return;
    }
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
    if (form == Form::beyond) return;
    if (action.kind == ActionKind::continuous) return add_continuous(action, form);
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

}  // namespace

std::vector<ActionBlockEntry> actions_of(const Plan& plan, const Names& names, StepId step,
                                         Language language) {
    if (index_of(step) >= plan.grafcet->steps.size()) return {};
    return ActionsOfStep(plan, names, step, language).make();
}

}  // namespace grafwire::sfc
