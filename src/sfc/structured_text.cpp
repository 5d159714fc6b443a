// Expressions of a chart in Structured Text. An edge is written as what it is, the operand now and
// not before, for R_TRIG would need an instance that is called in every scan; in the first scan
// there is none. Where a statement must read what held when the scan began, it reads a copy.

#include "sfc/structured_text.h"

#include <fmt/format.h>

#include "grafcet/grafcet.h"

namespace grafwire::sfc {

using iec::Precedence;

std::string StructuredText::any_step(Range<StepId> steps) const {
    if (steps.empty()) return "FALSE";
    std::string text;
    for (const StepId step : steps) {
        text += fmt::format("{}{}.X", text.empty() ? "" : " OR ", names_.steps[index_of(step)]);
    }
    return steps.count == 1 ? text : "(" + text + ")";
}

std::string StructuredText::variable(Variable variable, const Reading& reading) const {
    if (reading.is_copy(variable)) return names_.copies.at(variable);
    switch (variable.kind) {
        case VariableKind::input:
            return names_.inputs[variable.index];
        case VariableKind::control:
            if (!has_modes_) return "FALSE";
            return names_.inputs[grafcet_.inputs.size() + variable.index];
        case VariableKind::output:
            return names_.outputs[variable.index];
        case VariableKind::var:
            return names_.vars[variable.index];
        case VariableKind::counter:
            return names_.counters[variable.index];
        case VariableKind::step:
            return names_.steps[variable.index] + ".X";
        case VariableKind::macro: {
            const Macro& macro = grafcet_.macros[MacroId{variable.index}];
            return any_step(macro.steps);
        }
        case VariableKind::graph: {
            const Graph& graph = grafcet_.graphs[GraphId{variable.index}];
            return any_step(graph.steps);
        }
    }
    return {};
}

std::string StructuredText::sum(const Sum& sum, const Reading& reading) const {
    std::string text;
    for (const SumTerm& term : sum) {
        if (!text.empty()) {
            text += term.negative ? " - " : " + ";
        } else if (term.negative) {
            text += "-";
        }
        text += term.counter == SumTerm::no_counter
                    ? fmt::format("{}", term.value)
                    : variable({VariableKind::counter, term.counter}, reading);
    }
    return text;
}

std::string StructuredText::comparison(const Comparison& comparison, const Reading& reading) const {
    return fmt::format("({} {} {})", sum(comparison.left, reading),
                       iec::relation_signs[static_cast<std::size_t>(comparison.relation)],
                       sum(comparison.right, reading));
}

std::string StructuredText::edge(ExprId id) const {
    const Expressions& pool = grafcet_.expressions;
    const ExprId operand = pool.operands(id).front();
    const bool rises = pool.kind(id) == ExprKind::rise;
    return fmt::format("{} AND {}{} AND {}{}", names_.started, rises ? "" : "NOT ",
                       beside(operand, reading_at_start, Precedence::operand), rises ? "NOT " : "",
                       names_.before.at(operand));
}

namespace {

/// Of the operator of an expression; of anything that has none, an operand's.
Precedence precedence_of(ExprKind kind) {
    switch (kind) {
        case ExprKind::disjunction:
            return Precedence::disjunction;
        case ExprKind::exclusive_or:
            return Precedence::exclusive_or;
        case ExprKind::conjunction:
            return Precedence::conjunction;
        case ExprKind::negation:
            return Precedence::negation;
        default:
            return Precedence::operand;
    }
}

}  // namespace

/// The operands with their operator between them.
std::string StructuredText::chain(ExprId id, const Reading& reading) const {
    const Expressions& pool = grafcet_.expressions;
    const Precedence precedence = precedence_of(pool.kind(id));
    std::string text;
    for (const ExprId operand : pool.operands(id)) {
        if (!text.empty()) text += iec::word_of(precedence);
        text += beside(operand, reading, precedence);
    }
    return text;
}

/// An expression beside an operator: in parentheses unless its own binds more strongly than that.
std::string StructuredText::beside(ExprId id, const Reading& reading, Precedence above) const {
    const Expressions& pool = grafcet_.expressions;
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool.constant_value(id) ? "TRUE" : "FALSE";
        case ExprKind::variable:
            return variable(pool.variable_of(id), reading);
        case ExprKind::rise:
        case ExprKind::fall:
            return "(" + edge(id) + ")";
        case ExprKind::comparison:
            return comparison(pool.comparison_of(id), reading);
        case ExprKind::time_condition: {
            const std::size_t ordinal = pool.ordinal(id);
            return reading.at_start ? names_.time_copies.at(ordinal) : names_.times[ordinal];
        }
        default:
            break;
    }
    const Precedence own = precedence_of(pool.kind(id));
    const std::string text =
        own == Precedence::negation
            ? fmt::format("{}{}", iec::word_of(own),
                          beside(pool.operands(id).front(), reading, Precedence::operand))
            : chain(id, reading);
    return own > above ? text : "(" + text + ")";
}

std::string StructuredText::expression(ExprId id, const Reading& reading, bool as_operand) const {
    if (as_operand) return beside(id, reading, Precedence::operand);
    switch (grafcet_.expressions.kind(id)) {
        case ExprKind::conjunction:
        case ExprKind::disjunction:
        case ExprKind::exclusive_or:
            return chain(id, reading);
        case ExprKind::rise:
        case ExprKind::fall:
            return edge(id);
        default:
            return beside(id, reading, Precedence::disjunction);
    }
}

std::string StructuredText::statement(const Write& write, const Reading& reading) const {
    const std::string target = variable(write.target);
    if (write.operation != WriteOperation::assign) {
        return fmt::format("{} := {};", target,
                           write.operation == WriteOperation::set ? "TRUE" : "FALSE");
    }
    if (write.target.kind != VariableKind::counter) {
        return fmt::format("{} := {};", target, expression(write.value, reading));
    }
    const Counter& counter = grafcet_.counters[CounterId{write.target.index}];
    const std::string value = sum(grafcet_.sums[write.sum], reading);
    const auto range = range_of(grafcet_, grafcet_.sums[write.sum]);
    const bool stays = range && range->low >= counter.low && range->high <= counter.high;
    return stays
               ? fmt::format("{} := {};", target, value)
               : fmt::format("{} := LIMIT({}, {}, {});", target, counter.low, value, counter.high);
}

}  // namespace grafwire::sfc
