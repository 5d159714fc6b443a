// The comments of modules are written once a netlist has been made, so that what makes gates need
// not know how equations are shown. Modules are known by their names: those of steps stand in the
// order of the table.

#include "netlist/styles/annotate.h"

#include <fmt/format.h>

#include <string>
#include <unordered_map>

#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

/// A longer equation cannot be read, and the comment is left out: those of n parallel steps hold n
/// steps each.
constexpr std::size_t most_operands = 256;

using Comments = std::unordered_map<std::string, std::string>;

void add_outputs(const Grafcet& grafcet, const Equations& equations, Comments& comments) {
    for (const OutputEquation& equation : equations.outputs) {
        const std::string& name = grafcet.outputs[equation.output].name;
        comments.emplace(
            name, fmt::format("{} = {}", name,
                              write_expression(grafcet, equations.expressions, equation.value)));
    }
}

/// The latches of stored outputs and vars, and what holds their values while they are written.
void add_stored(const Grafcet& grafcet, const Equations& equations, Comments& comments) {
    for (const StoredEquation& stored : equations.stored) {
        if (stored.target.kind == VariableKind::counter) continue;
        const std::string name = variable_name(grafcet, stored.target);
        if (stored.writes.empty()) {
            comments.emplace(name, name + " = 0");
            continue;
        }
        const std::string comment =
            fmt::format("{}: set {} reset {}", name,
                        write_expression(grafcet, equations.expressions, stored.set),
                        write_expression(grafcet, equations.expressions, stored.reset));
        comments.emplace(name, comment);
        comments.emplace(name + "$hold", comment);
    }
}

bool is_of_step(const Module& module, const Step& step) {
    return module.name.starts_with('X') && std::string_view(module.name).substr(1) == step.name;
}

}  // namespace

void annotate(Netlist& netlist, const Grafcet& grafcet, const Equations& equations) {
    Comments comments;
    add_outputs(grafcet, equations, comments);
    if (!netlist.is_clocked()) add_stored(grafcet, equations, comments);
    StepTexts texts(grafcet, equations, most_operands);
    std::size_t step = 0;
    for (Module& module : netlist.modules) {
        if (step < grafcet.steps.size() &&
            is_of_step(module, grafcet.steps[grafcet.steps.id_at(step)])) {
            module.comment = texts.equation(grafcet.steps.id_at(step++));
        } else if (const auto comment = comments.find(module.name); comment != comments.end()) {
            module.comment = std::move(comment->second);
        }
    }
}

// The equation of a step is put together from its parts (CAX, CDX, forcing, …) as a new expression.
// Made in the pool of the equations it would stay there; made in a pool that is emptied after every
// step it costs no memory. Copying ends as soon as the text would be too long to be read.

/// Recursive: expressions are nested a few hundred levels deep at most.
ExprId StepTexts::copy(ExprId id) {
    if (id == no_expr || operands_ > most_operands_) return no_expr;
    const Expressions& pool = equations_.expressions;
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool_.constant(pool.constant_value(id));
        case ExprKind::variable:
            return pool_.variable(pool.variable_of(id));
        case ExprKind::comparison:
            return pool_.comparison(pool.comparison_of(id));
        case ExprKind::time_condition: {
            TimeCondition condition = pool.time_condition_of(id);
            condition.operand = copy(condition.operand);
            return pool_.time_condition(condition);
        }
        default:
            break;
    }
    operands_ += pool.operands(id).size();
    if (operands_ > most_operands_) return no_expr;
    std::vector<ExprId> operands;
    operands.reserve(pool.operands(id).size());
    for (const ExprId operand : pool.operands(id)) operands.push_back(copy(operand));
    switch (pool.kind(id)) {
        case ExprKind::negation:
            return pool_.negation(operands.front());
        case ExprKind::rise:
            return pool_.rise(operands.front());
        case ExprKind::fall:
            return pool_.fall(operands.front());
        case ExprKind::conjunction:
            return pool_.conjunction(operands);
        case ExprKind::disjunction:
            return pool_.disjunction(operands);
        default:
            return pool_.exclusive_or(operands);
    }
}

std::string StepTexts::equation(StepId step) {
    pool_.clear();
    operands_ = 0;
    StepEquation parts = equations_.steps[step];
    for (ExprId* part : {&parts.cax, &parts.cdx, &parts.forced_off, &parts.forced_on,
                         &parts.enclosing, &parts.link}) {
        *part = copy(*part);
    }
    if (operands_ > most_operands_) return {};
    const ExprId x = combined(pool_, parts, step, equations_.options.modes);
    return "X" + grafcet_.steps[step].name + " = " + write_expression(grafcet_, pool_, x);
}

}  // namespace grafwire
