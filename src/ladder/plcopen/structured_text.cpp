#include "ladder/plcopen/structured_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "ladder/identifiers.h"
#include "ladder/ladder.h"

namespace grafwire::ladder {

namespace {

std::string any_of(const SfcNames& names, std::uint32_t first, std::uint32_t count) {
    std::string text;
    for (std::uint32_t i = 0; i < count; ++i) {
        text += fmt::format("{}{}.X", i == 0 ? "" : " OR ", names.steps[first + i]);
    }
    return text.empty() ? "FALSE" : "(" + text + ")";
}

std::string variable_text(const Grafcet& grafcet, const SfcNames& names,
                          grafwire::Variable variable) {
    switch (variable.kind) {
        case VariableKind::input:
            return names.inputs[variable.index];
        case VariableKind::control:
            return names.inputs[grafcet.inputs.size() + variable.index];
        case VariableKind::output:
            return names.outputs[variable.index];
        case VariableKind::var:
            return names.vars[variable.index];
        case VariableKind::counter:
            return names.counters[variable.index];
        case VariableKind::step:
            return names.steps[variable.index] + ".X";
        case VariableKind::macro: {
            const Macro& macro = grafcet.macros[MacroId{variable.index}];
            return any_of(names, macro.first_step, macro.step_count);
        }
        case VariableKind::graph: {
            const Graph& graph = grafcet.graphs[GraphId{variable.index}];
            return any_of(names, graph.first_step, graph.step_count);
        }
    }
    return {};
}

}  // namespace

SfcNames sfc_names(const Grafcet& grafcet) {
    SfcNames names;
    std::vector<std::string> all;
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        all.emplace_back(input_name(grafcet, i));
    }
    for (const Output& output : grafcet.outputs) all.push_back(output.name);
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        all.push_back(variable_name(grafcet, {VariableKind::step, s}));
    }
    for (const Var& var : grafcet.vars) all.push_back(var.name);
    for (const Counter& counter : grafcet.counters) all.push_back(counter.name);
    Identifiers identifiers;
    const std::vector<std::string> made = identifiers.add(all);
    auto next = made.begin();
    const auto take = [&](std::vector<std::string>& list, std::size_t count) {
        list.assign(next, next + static_cast<std::ptrdiff_t>(count));
        next += static_cast<std::ptrdiff_t>(count);
    };
    take(names.inputs, grafcet.all_input_count());
    take(names.outputs, grafcet.outputs.size());
    take(names.steps, grafcet.steps.size());
    take(names.vars, grafcet.vars.size());
    take(names.counters, grafcet.counters.size());
    for (std::size_t i = 0; i < grafcet.expressions.edges().size(); ++i) {
        names.edges.push_back(fmt::format("edge{}_seen", i));
    }
    for (std::size_t i = 0; i < grafcet.expressions.time_conditions().size(); ++i) {
        names.times.push_back(fmt::format("time{}_over", i));
    }
    names.edges = identifiers.add(names.edges);
    names.times = identifiers.add(names.times);
    return names;
}

bool is_step_time(const Grafcet& grafcet, const TimeCondition& condition) {
    const Expressions& pool = grafcet.expressions;
    return condition.off_delay == 0 && pool.kind(condition.operand) == ExprKind::variable &&
           pool.variable_of(condition.operand).kind == VariableKind::step;
}

std::string structured_text(const SfcNames& names, const Sum& sum) {
    std::string text;
    for (const SumTerm& term : sum) {
        if (!text.empty()) {
            text += term.negative ? " - " : " + ";
        } else if (term.negative) {
            text += "-";
        }
        text += term.counter == SumTerm::no_counter ? fmt::format("{}", term.value)
                                                    : names.counters[term.counter];
    }
    return text;
}

std::string structured_text(const Grafcet& grafcet, const SfcNames& names, ExprId id) {
    static constexpr const char* relations[] = {"=", "<>", "<", "<=", ">", ">="};
    const Expressions& pool = grafcet.expressions;
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool.constant_value(id) ? "TRUE" : "FALSE";
        case ExprKind::variable:
            return variable_text(grafcet, names, pool.variable_of(id));
        case ExprKind::negation:
            return "NOT " + structured_text(grafcet, names, pool.operands(id).front());
        case ExprKind::rise:
        case ExprKind::fall:
            return names.edges[pool.ordinal(id)];
        case ExprKind::time_condition: {
            const TimeCondition& condition = pool.time_condition_of(id);
            if (!is_step_time(grafcet, condition)) return names.times[pool.ordinal(id)];
            const std::string& step = names.steps[pool.variable_of(condition.operand).index];
            return fmt::format("({0}.X AND {0}.T >= {1})", step, time_literal(condition.on_delay));
        }
        case ExprKind::comparison: {
            const Comparison& comparison = pool.comparison_of(id);
            return fmt::format("({} {} {})", structured_text(names, comparison.left),
                               relations[static_cast<std::size_t>(comparison.relation)],
                               structured_text(names, comparison.right));
        }
        default:
            break;
    }
    const char* sign = pool.kind(id) == ExprKind::conjunction   ? " AND "
                       : pool.kind(id) == ExprKind::disjunction ? " OR "
                                                                : " XOR ";
    std::string text;
    for (const ExprId operand : pool.operands(id)) {
        if (!text.empty()) text += sign;
        text += structured_text(grafcet, names, operand);
    }
    return "(" + text + ")";
}

std::string structured_text(const Grafcet& grafcet, const SfcNames& names, const Write& write) {
    const std::string target = variable_text(grafcet, names, write.target);
    if (write.operation != WriteOperation::assign) {
        return fmt::format("{} := {};", target,
                           write.operation == WriteOperation::set ? "TRUE" : "FALSE");
    }
    if (write.target.kind != VariableKind::counter) {
        return fmt::format("{} := {};", target, structured_text(grafcet, names, write.value));
    }
    const Counter& counter = grafcet.counters[CounterId{write.target.index}];
    return fmt::format("{} := LIMIT({}, {}, {});", target, counter.low,
                       structured_text(names, grafcet.sums[write.sum]), counter.high);
}

std::string observing_text(const Grafcet& grafcet, const SfcNames& names) {
    const Expressions& pool = grafcet.expressions;
    std::string text;
    for (std::size_t i = 0; i < pool.edges().size(); ++i) {
        const std::string operand =
            structured_text(grafcet, names, pool.operands(pool.edges()[i]).front());
        text +=
            fmt::format("edge{0}(CLK := {1});\n{2} := edge{0}.Q;\n", i, operand, names.edges[i]);
    }
    for (std::size_t i = 0; i < pool.time_conditions().size(); ++i) {
        const TimeCondition& condition = pool.time_condition_of(pool.time_conditions()[i]);
        if (is_step_time(grafcet, condition)) continue;
        const std::string operand = structured_text(grafcet, names, condition.operand);
        const std::string& value = names.times[i];
        if (condition.off_delay == 0) {
            text += fmt::format("timer{0}(IN := {1}, PT := {2});\n{3} := timer{0}.Q;\n", i, operand,
                                time_literal(condition.on_delay), value);
            continue;
        }
        text += fmt::format(
            "timer{0}(IN := {1} AND NOT {3}, PT := {2});\nIF timer{0}.Q THEN {3} := TRUE; "
            "END_IF;\n",
            i, operand, time_literal(condition.on_delay), value);
        text += fmt::format(
            "timer{0}_off(IN := NOT {1} AND {3}, PT := {2});\nIF timer{0}_off.Q THEN {3} := FALSE; "
            "END_IF;\n",
            i, operand, time_literal(condition.off_delay), value);
    }
    return text;
}

}  // namespace grafwire::ladder
