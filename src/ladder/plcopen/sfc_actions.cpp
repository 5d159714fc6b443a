// Actions of a GRAFCET as action blocks of SFC (IEC 61131-3, section 2.6.4): continuous ones are N,
// with a delay or limit of their own step D or L; stored ones S or R where they set or reset a bit
// on activation, else statements on the pulse P1 of activation or P0 of deactivation.

#include "ladder/plcopen/sfc_actions.h"

#include <fmt/format.h>

#include <optional>

#include "grafcet/write_grafcet.h"
#include "ladder/ladder.h"

namespace grafwire::ladder {

namespace {

/// `5s/X13` of the action's own step, or its negation: a delayed or a time-limited action.
std::optional<SfcAction> timed(const Grafcet& grafcet, const Action& action) {
    const Expressions& pool = grafcet.expressions;
    ExprId id = action.expression;
    const bool negated = pool.kind(id) == ExprKind::negation;
    if (negated) id = pool.operands(id).front();
    if (pool.kind(id) != ExprKind::time_condition) return std::nullopt;
    const TimeCondition& condition = pool.time_condition_of(id);
    if (!is_step_time(grafcet, condition)) return std::nullopt;
    if (StepId{pool.variable_of(condition.operand).index} != action.step) return std::nullopt;
    return SfcAction{negated ? "L" : "D", time_literal(condition.on_delay), "", ""};
}

std::optional<SfcAction> action_of(const Grafcet& grafcet, const SfcNames& names,
                                   const Action& action) {
    if (action.kind == ActionKind::order) return std::nullopt;
    if (action.kind == ActionKind::continuous) {
        std::optional<SfcAction> made = SfcAction{"N", "", "", ""};
        if (action.expression != no_expr) made = timed(grafcet, action);
        if (made) made->reference = names.outputs[static_cast<std::size_t>(action.output)];
        return made;
    }
    if (action.trigger == Trigger::event) return std::nullopt;
    const Write& write = action.write;
    const bool is_latch = write.operation != WriteOperation::assign;
    if (action.trigger == Trigger::activation && is_latch) {
        const auto& list = write.target.kind == VariableKind::output ? names.outputs : names.vars;
        return SfcAction{write.operation == WriteOperation::set ? "S" : "R", "",
                         list[write.target.index], ""};
    }
    return SfcAction{action.trigger == Trigger::activation ? "P1" : "P0", "", "",
                     structured_text(grafcet, names, write)};
}

std::string write_text(const Grafcet& grafcet, const Write& write) {
    const std::string target = quoted_where_needed(variable_name(grafcet, write.target));
    if (write.operation == WriteOperation::set) return "set " + target;
    if (write.operation == WriteOperation::reset) return "reset " + target;
    if (write.target.kind != VariableKind::counter) {
        return target + " := " + write_expression(grafcet, grafcet.expressions, write.value);
    }
    std::string text = target + " :=";
    bool is_first = true;
    for (const SumTerm& term : grafcet.sums[write.sum]) {
        text += term.negative ? " - " : is_first ? " " : " + ";
        is_first = false;
        text += term.counter == SumTerm::no_counter
                    ? fmt::format("{}", term.value)
                    : quoted_where_needed(grafcet.counters[CounterId{term.counter}].name);
    }
    return text;
}

std::string order_text(const Grafcet& grafcet, const Order& order) {
    std::string steps;
    for (const StepId step : order.steps) {
        steps += (steps.empty() ? "" : ", ") + quoted_where_needed(grafcet.steps[step].name);
    }
    if (order.kind == OrderKind::freeze) steps = "*";
    if (order.kind == OrderKind::initial) steps = "INIT";
    return quoted_where_needed(grafcet.graphs[order.graph].name) + "{" + steps + "}";
}

std::string action_text(const Grafcet& grafcet, const Action& action) {
    switch (action.kind) {
        case ActionKind::order:
            return "gives the order " + order_text(grafcet, grafcet.orders[action.order]);
        case ActionKind::continuous:
            return quoted_where_needed(grafcet.outputs[action.output].name) + " if " +
                   write_expression(grafcet, grafcet.expressions, action.expression);
        case ActionKind::stored:
            break;
    }
    return write_text(grafcet, action.write) + " on " +
           write_expression(grafcet, grafcet.expressions, action.expression);
}

}  // namespace

bool has_sfc_actions(const Grafcet& grafcet, const SfcNames& names, StepId step) {
    for (const Action& action : grafcet.actions_of(grafcet.steps[step])) {
        if (action_of(grafcet, names, action)) return true;
    }
    return false;
}

void write_sfc_actions(const Grafcet& grafcet, const SfcNames& names, StepId step,
                       const Outlet& source, PlcopenBody& body) {
    std::vector<SfcAction> actions;
    for (const Action& action : grafcet.actions_of(grafcet.steps[step])) {
        if (auto made = action_of(grafcet, names, action)) actions.push_back(std::move(*made));
    }
    write_sfc_action_block(actions, source, body);
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

std::vector<std::string> sfc_remarks(const Grafcet& grafcet, const SfcNames& names) {
    std::vector<std::string> remarks;
    const auto step_text = [&](StepId step) {
        return "step " + quoted_where_needed(grafcet.steps[step].name);
    };
    for (const Action& action : grafcet.actions) {
        if (action_of(grafcet, names, action)) continue;
        remarks.push_back(step_text(action.step) + ": " + action_text(grafcet, action));
    }
    for (const Enclosure& enclosure : grafcet.enclosures) {
        remarks.push_back(step_text(enclosure.step) + " encloses " +
                          quoted_where_needed(grafcet.graphs[enclosure.graph].name));
    }
    for (const ClearingAction& action : grafcet.clearing_actions) {
        remarks.push_back(
            fmt::format("transition ({}): {} on clearing",
                        quoted_where_needed(grafcet.transitions[action.transition].name),
                        write_text(grafcet, action.write)));
    }
    for (const Transition& transition : grafcet.transitions) {
        if (transition.preceding_count != 0 && transition.following_count != 0) continue;
        remarks.push_back(fmt::format("transition ({}) has no step {}",
                                      quoted_where_needed(transition.name),
                                      transition.preceding_count == 0 ? "before it" : "after it"));
    }
    std::string head =
        "This chart is for reading: the ladder diagram is what was proved equal to the GRAFCET. It "
        "does without Init, AUdur and AUdoux";
    head += remarks.empty() ? "." : ", and SFC cannot say the following:";
    remarks.insert(remarks.begin(), std::move(head));
    return remarks;
}

}  // namespace grafwire::ladder
