// From a GRAFCET to the program of one scan.
//
// The table method is chosen for every language, and not the CAX/CDX equations with set and reset,
// because it obeys the five rules whatever the chart: all transitions are tested on the situation
// that the scan began with, and `Ts = Tp . /Td + Ta` gives activation its priority (Cordier,
// "Méthode d'implémentation du GRAFCET" (1998), section 3.3). Every part of the chart becomes a
// statement of its own, so that a change of one transition is a change in one place.

#include "program/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "grafcet/write_grafcet.h"
#include "program/messages.h"
#include "program/program_parts.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// A comment may hold the whole transition between thousands of steps, each of whose statements has
/// one: beyond this nobody reads it, and programs would grow with the square of the chart.
constexpr std::size_t most_of_comment = 1000;

Localized shortened_comment(Localized comment) {
    if (std::max(comment.english.size(), comment.french.size()) <= most_of_comment) return comment;
    return {shortened(comment.english, most_of_comment),
            shortened(comment.french, most_of_comment)};
}

}  // namespace

Statement& SectionWriter::add(Statement::Kind kind, Localized comment, Location origin) {
    Statement statement;
    statement.kind = kind;
    statement.comment = shortened_comment(std::move(comment));
    statement.origin = origin;
    statements_.push_back(std::move(statement));
    return statements_.back();
}

void SectionWriter::assign(Bit target, Condition condition, Localized comment, Location origin) {
    Statement& statement = add(Statement::Kind::assign, std::move(comment), origin);
    statement.targets = {target};
    statement.condition = std::move(condition);
}

void SectionWriter::set_or_reset(Statement::Kind kind, std::vector<Bit> targets,
                                 Condition condition, Localized comment, Location origin) {
    if (targets.empty() || condition.is_constant(false)) return;
    Statement& statement = add(kind, std::move(comment), origin);
    statement.targets = std::move(targets);
    statement.condition = std::move(condition);
}

void SectionWriter::set(std::vector<Bit> targets, Condition condition, Localized comment,
                        Location origin) {
    set_or_reset(Statement::Kind::set, std::move(targets), std::move(condition), std::move(comment),
                 origin);
}

void SectionWriter::reset(std::vector<Bit> targets, Condition condition, Localized comment,
                          Location origin) {
    set_or_reset(Statement::Kind::reset, std::move(targets), std::move(condition),
                 std::move(comment), origin);
}

void SectionWriter::table(TableOperation operation, Localized comment) {
    add(Statement::Kind::table, std::move(comment)).operation = operation;
}

Bit step_bit(BitKind table, StepId step) {
    return {table, static_cast<std::uint32_t>(index_of(step))};
}

Bit new_scratch(ScanProgram& program) {
    return {BitKind::scratch, program.scratch_bits++};
}

std::string transition_text(const Grafcet& grafcet, TransitionId id) {
    const Transition& transition = grafcet.transitions[id];
    const auto names = [&](std::span<const StepId> steps) {
        std::string text;
        for (const StepId step : steps) {
            if (!text.empty()) text += ", ";
            text += quoted_where_needed(grafcet.steps[step].name);
        }
        return text;
    };
    std::string text = fmt::format("({})", quoted_where_needed(transition.name));
    const std::string before = names(grafcet.preceding(transition));
    const std::string after = names(grafcet.following(transition));
    if (!before.empty()) text += " " + before;
    text += " ->";
    if (!after.empty()) text += " " + after;
    return text;
}

namespace {

namespace say = messages::program;

/// Fills one section after the other; each reads what those before it have written.
class ProgramBuild {
  public:
    ProgramBuild(const Grafcet& grafcet, const ProgramOptions& options)
        : grafcet_(grafcet), conditions_(grafcet, options.modes) {
        program_.has_modes = options.modes;
    }

    ScanProgram make() {
        make_start();
        make_begin();
        make_edges();
        make_conditions();
        make_evolution();
        add_orders(grafcet_, conditions_, program_);
        add_stored_actions(grafcet_, conditions_, program_);
        make_times();
        make_outputs();
        return std::move(program_);
    }

  private:
    void make_start();
    void make_begin();
    void make_edges();
    void make_conditions();
    void make_evolution();
    void make_times();
    void make_outputs();

    const Grafcet& grafcet_;
    ChartConditions conditions_;
    ScanProgram program_;
};

/// SBR 0. Edges are 0 while their memories are filled, last of all, so nothing has an edge in the
/// first scan.
void ProgramBuild::make_start() {
    SectionWriter section(program_, SectionKind::start);
    std::vector<Bit> graphs;
    for (std::uint32_t g = 0; g < grafcet_.graphs.size(); ++g) {
        graphs.push_back({BitKind::may_evolve, g});
    }
    section.set(std::move(graphs), constant_condition(true), say::no_graph_frozen());
    for (std::size_t s = 0; s < grafcet_.steps.size(); ++s) {
        const Step& step = grafcet_.steps[grafcet_.steps.id_at(s)];
        if (!step.initial) continue;
        const StepId id = grafcet_.steps.id_at(s);
        section.set({step_bit(BitKind::previous, id), step_bit(BitKind::step, id)},
                    constant_condition(true), say::initial_step(quoted_where_needed(step.name)),
                    step.where);
    }
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        const Counter& counter = grafcet_.counters[CounterId{c}];
        Statement& statement =
            section.add(Statement::Kind::move,
                        Localized::same_in_both(quoted_where_needed(counter.name)), counter.where);
        statement.condition = constant_condition(true);
        statement.integer = {false, c};
        const bool negative = counter.low < 0;
        statement.sum = {{negative, SumTerm::no_counter, negative ? -counter.low : counter.low}};
        statement.low = counter.low;
        statement.high = counter.high;
    }
    const Expressions& pool = grafcet_.expressions;
    for (std::uint32_t i = 0; i < pool.edges().size(); ++i) {
        const ExprId edge = pool.edges()[i];
        section.assign({BitKind::edge_memory, i}, conditions_.of(pool.operands(edge).front()),
                       say::memory_of_edge(write_expression(grafcet_, pool, edge)));
    }
}

void ProgramBuild::make_begin() {
    SectionWriter section(program_, SectionKind::begin);
    section.table(TableOperation::remember, Localized::same_in_both("Tp = Ts"));
    section.table(TableOperation::clear, Localized::same_in_both("Ta = Td = Tf1 = Tf0 = 0"));
}

/// SBR 2, inner edges first: `LDN memory U e = edge, LD e = memory` in the words of the method.
void ProgramBuild::make_edges() {
    SectionWriter section(program_, SectionKind::edges);
    const Expressions& pool = grafcet_.expressions;
    for (std::uint32_t i = 0; i < pool.edges().size(); ++i) {
        const ExprId edge = pool.edges()[i];
        const std::string text = write_expression(grafcet_, pool, edge);
        const Condition operand = conditions_.of(pool.operands(edge).front());
        const Condition memory = bit_condition({BitKind::edge_memory, i});
        const bool rising = pool.kind(edge) == ExprKind::rise;
        std::vector<Condition> both;
        both.push_back(rising ? operand : not_condition(operand));
        both.push_back(rising ? not_condition(memory) : memory);
        section.assign({BitKind::edge, i}, and_condition(std::move(both)),
                       Localized::same_in_both(text));
        section.assign({BitKind::edge_memory, i}, operand, say::memory_of_edge(text));
    }
}

void ProgramBuild::make_conditions() {
    SectionWriter section(program_, SectionKind::conditions);
    for (std::uint32_t t = 0; t < grafcet_.transitions.size(); ++t) {
        const TransitionId id{t};
        const Transition& transition = grafcet_.transitions[id];
        std::vector<Condition> parts;
        parts.push_back(conditions_.of(transition.condition));
        parts.push_back(bit_condition(
            {BitKind::may_evolve, static_cast<std::uint32_t>(index_of(transition.graph))}));
        section.assign({BitKind::transition, t}, and_condition(std::move(parts)),
                       Localized::same_in_both(
                           transition_text(grafcet_, id) + " : " +
                           write_expression(grafcet_, grafcet_.expressions, transition.condition)),
                       transition.where);
    }
}

void ProgramBuild::make_evolution() {
    SectionWriter section(program_, SectionKind::evolution);
    for (std::uint32_t t = 0; t < grafcet_.transitions.size(); ++t) {
        const TransitionId id{t};
        const Transition& transition = grafcet_.transitions[id];
        std::vector<Condition> parts;
        std::vector<Bit> targets;
        for (const StepId step : grafcet_.preceding(transition)) {
            parts.push_back(bit_condition(step_bit(BitKind::step, step)));
        }
        parts.push_back(bit_condition({BitKind::transition, t}));
        for (const StepId step : grafcet_.following(transition)) {
            targets.push_back(step_bit(BitKind::activate, step));
        }
        for (const StepId step : grafcet_.preceding(transition)) {
            targets.push_back(step_bit(BitKind::deactivate, step));
        }
        section.set(std::move(targets), and_condition(std::move(parts)),
                    Localized::same_in_both(transition_text(grafcet_, id)), transition.where);
    }
    section.table(TableOperation::evolve, Localized::same_in_both("Ts = Tp . /Td + Ta"));
    std::vector<Bit> initial;
    std::vector<Bit> others;
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        (grafcet_.steps[StepId{s}].initial ? initial : others).push_back({BitKind::step, s});
    }
    const Condition init = conditions_.control(ControlInput::init);
    section.set(std::move(initial), init, say::init_sets());
    section.reset(std::move(others), init, say::init_resets());
}

void ProgramBuild::make_times() {
    SectionWriter section(program_, SectionKind::times);
    const Expressions& pool = grafcet_.expressions;
    for (std::uint32_t i = 0; i < pool.time_conditions().size(); ++i) {
        const ExprId id = pool.time_conditions()[i];
        const TimeCondition& condition = pool.time_condition_of(id);
        Statement& statement = section.add(
            Statement::Kind::time, Localized::same_in_both(write_expression(grafcet_, pool, id)));
        statement.targets = {{BitKind::time_value, i}};
        statement.condition = conditions_.of(condition.operand);
        statement.on_delay = condition.on_delay;
        statement.off_delay = condition.off_delay;
    }
}

/// SBR 8. All contributions to an output meet in one assignment: written step by step, the last one
/// would overwrite the others.
void ProgramBuild::make_outputs() {
    SectionWriter section(program_, SectionKind::outputs);
    for (std::uint32_t o = 0; o < grafcet_.outputs.size(); ++o) {
        const Output& output = grafcet_.outputs[OutputId{o}];
        if (output.stored) continue;
        std::vector<Condition> causes;
        for (const Action& action : grafcet_.actions) {
            if (action.kind != ActionKind::continuous || action.output != OutputId{o}) continue;
            std::vector<Condition> parts;
            parts.push_back(bit_condition(step_bit(BitKind::step, action.step)));
            if (action.expression != no_expr) parts.push_back(conditions_.of(action.expression));
            causes.push_back(and_condition(std::move(parts)));
        }
        std::vector<Condition> gated;
        gated.push_back(or_condition(std::move(causes)));
        gated.push_back(conditions_.not_control(ControlInput::au_doux));
        section.assign({BitKind::output, o}, and_condition(std::move(gated)),
                       Localized::same_in_both(quoted_where_needed(output.name)), output.where);
    }
    // Vars that steps hold are bits like these, but AUdoux leaves them alone. Nothing in the
    // program reads them: whoever does has what they stand for in their place.
    for (std::uint32_t v = 0; v < grafcet_.vars.size(); ++v) {
        const Var& var = grafcet_.vars[VarId{v}];
        if (!var.is_held()) continue;
        section.assign({BitKind::var, v}, conditions_.of(var.held),
                       Localized::same_in_both(quoted_where_needed(var.name)), var.where);
    }
    for (std::uint32_t g = 0; g < grafcet_.graphs.size(); ++g) {
        std::vector<Condition> freezing;
        for (const Order& order : grafcet_.orders) {
            if (order.kind != OrderKind::freeze || order.graph != GraphId{g}) continue;
            freezing.push_back(bit_condition(step_bit(BitKind::step, order.step)));
        }
        if (freezing.empty()) continue;
        section.assign({BitKind::may_evolve, g}, not_condition(or_condition(std::move(freezing))),
                       say::may_evolve(quoted_where_needed(grafcet_.graphs[GraphId{g}].name)));
    }
}

bool reads(const Condition& condition, Bit bit) {
    if (condition.kind == Condition::Kind::bit) return condition.bit == bit;
    for (const Condition& operand : condition.operands) {
        if (reads(operand, bit)) return true;
    }
    return false;
}

}  // namespace

ScanProgram program_from(const Grafcet& grafcet, const ProgramOptions& options) {
    return ProgramBuild(grafcet, options).make();
}

bool reads_control(const ScanProgram& program, ControlInput control) {
    const Bit bit{BitKind::control, static_cast<std::uint32_t>(control)};
    for (const std::vector<Statement>& section : program.sections) {
        for (const Statement& statement : section) {
            if (reads(statement.condition, bit)) return true;
        }
    }
    return false;
}

}  // namespace grafwire
