// Actions of a GRAFCET as action blocks of SFC (IEC 61131-3, section 2.6.4). Continuous ones are N,
// D or L; stored ones S or R, or statements on the pulse P1 of activation or P0 of deactivation, or
// on an event under N. The statements are right whether or not an action is executed once more
// after its step (the standard's final scan), and whether or not the P1 of an initial step is
// executed in the first scan, which a GRAFCET does not do.

#include "ladder/plcopen/sfc_actions.h"

#include <fmt/format.h>

#include "ladder/ladder.h"

namespace grafwire::ladder {

namespace {

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
    ActionsOfStep(const SfcPlan& plan, const SfcNames& names, StepId step)
        : plan_(plan), grafcet_(*plan.grafcet), names_(names), text_(plan, names), step_(step) {}

    std::vector<SfcAction> make() {
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
    void add_continuous(const Action& action, SfcForm form);
    void add_statements(const char* qualifier, const std::string& statements) {
        if (!statements.empty()) actions_.push_back({qualifier, "", "", statements});
    }

    const SfcPlan& plan_;
    const Grafcet& grafcet_;
    const SfcNames& names_;
    StructuredText text_;
    StepId step_;
    std::vector<SfcAction> actions_;
    // Statements, each with its line end.
    std::string deactivation_;
    std::string activation_;
    std::string event_;
};

void ActionsOfStep::add_continuous(const Action& action, SfcForm form) {
    const std::string& output = names_.outputs[index_of(action.output)];
    if (form == SfcForm::observed) {
        const std::string condition =
            action.expression == no_expr ? "" : " if " + text_.expression(action.expression);
        actions_.push_back(
            {"N", "", "",
             fmt::format("(* {}{}: assigned by {} *)", output, condition, names_.observer)});
        return;
    }
    if (form == SfcForm::non_stored) {
        actions_.push_back({"N", "", output, ""});
        return;
    }
    const Expressions& pool = grafcet_.expressions;
    const bool is_limited = form == SfcForm::limited;
    const ExprId id = is_limited ? pool.operands(action.expression).front() : action.expression;
    actions_.push_back(
        {is_limited ? "L" : "D", time_literal(pool.time_condition_of(id).on_delay), output, ""});
}

void ActionsOfStep::add(const Action& action) {
    const std::size_t index = plan_.index_of_action(action);
    const SfcForm form = plan_.forms[index];
    if (form == SfcForm::beyond) return;
    if (action.kind == ActionKind::continuous) return add_continuous(action, form);
    if (form == SfcForm::set || form == SfcForm::reset) {
        const char* qualifier = form == SfcForm::set ? "S" : "R";
        actions_.push_back({qualifier, "", text_.variable(action.write.target), ""});
        return;
    }
    const Reading reading = plan_.reading_of(index);
    const std::string statement = text_.statement(action.write, reading);
    if (form == SfcForm::deactivation) deactivation_ += statement + "\n";
    if (form == SfcForm::activation) activation_ += statement + "\n";
    if (form != SfcForm::event) return;
    event_ += fmt::format("IF {} THEN {} END_IF;\n", text_.expression(action.expression, reading),
                          statement);
}

}  // namespace

std::vector<SfcAction> sfc_actions(const SfcPlan& plan, const SfcNames& names, StepId step) {
    if (index_of(step) >= plan.grafcet->steps.size()) return {};
    return ActionsOfStep(plan, names, step).make();
}

void write_sfc_action_block(const std::vector<SfcAction>& actions, const Outlet& source,
                            PlcopenBody& body) {
    constexpr int row = 30;
    const Point corner{source.at.x + 30, source.at.y - row / 2};
    const int height = row * static_cast<int>(actions.size());
    pugi::xml_node block = body.element("actionBlock", corner, 130, height);
    PlcopenBody::inlet(block, corner, {corner.x, source.at.y}, {source});
    int y = 0;
    for (const SfcAction& action : actions) {
        pugi::xml_node node = block.append_child("action");
        node.append_attribute("localId") = body.new_id();
        node.append_attribute("qualifier") = action.qualifier.c_str();
        if (!action.duration.empty()) {
            node.append_attribute("duration") = action.duration.c_str();
        }
        pugi::xml_node place = node.append_child("relPosition");
        place.append_attribute("x") = 0;
        place.append_attribute("y") = y;
        y += row;
        if (!action.reference.empty()) {
            node.append_child("reference").append_attribute("name") = action.reference.c_str();
        } else {
            add_text(node.append_child("inline").append_child("ST"), action.statements);
        }
    }
}

}  // namespace grafwire::ladder
