// A chart is told part by part and kept as it is told (Draft); nothing is looked up before
// finish(), since a name may be used before it is declared. finish() runs in three passes: the
// checks resolve every name and report all that the rules of the language refuse; only of a chart
// without errors is the model built, and that is where warnings come from.

#include "grafcet/grafcet_builder.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "grafcet/checking.h"
#include "grafcet/messages.h"
#include "grafcet/plant_conditions.h"
#include "grafcet/warnings.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// The order matters: names before what uses them, expansions before the steps that are told by
/// their graphs.
void check(const Checking& checking) {
    collect_names(checking);
    resolve_expansions(checking);
    resolve_definitions(checking);
    for (const DraftAssumption& assumption : checking.draft.assumptions) {
        resolve_expression(checking, assumption.expression, ExpressionUse::assumption);
    }
    resolve_transitions(checking);
    resolve_actions(checking);
    check_enclosures(checking);
    check_circles(checking);
}

/// Refuses assumptions that leave no input: nothing could be said about a GRAFCET under them. The
/// place is that of the last, as it was the one too many; those before `first_here` stand in
/// another file.
void refuse_contradictions(const Grafcet& grafcet, std::size_t first_here,
                           Diagnostics& diagnostics) {
    std::vector<std::size_t> contradicting = contradicting_assumptions(grafcet);
    if (contradicting.empty()) return;
    const Assumption& last = grafcet.assumptions[contradicting.back()];
    contradicting.pop_back();
    if (contradicting.empty()) {
        diagnostics.error(code::contradicting_assumptions, last.where, say::assumption_never_1());
        return;
    }
    Diagnostic& error = diagnostics.error(code::contradicting_assumptions, last.where,
                                          say::contradicting_assumptions(contradicting.size()));
    for (const std::size_t i : contradicting) {
        const Assumption& other = grafcet.assumptions[i];
        const std::string text = write_expression(grafcet, grafcet.expressions, other.expression);
        error.notes.push_back(
            {i < first_here ? Location{} : other.where, say::other_assumption(text)});
    }
}

/// At the first graph, or at the beginning of the file.
void refuse_no_steps(const Grafcet& grafcet, Diagnostics& diagnostics) {
    if (!grafcet.steps.empty()) return;
    const Location where =
        grafcet.blocks.empty() ? Location{1, 1} : grafcet.blocks.items().front().where;
    diagnostics.error(code::no_steps, where, say::no_steps());
}

/// Every variable of a model by its name.
std::vector<std::pair<std::string, Variable>> variables_of(const Grafcet& grafcet) {
    const std::pair<VariableKind, std::size_t> kinds[] = {
        {VariableKind::input, grafcet.inputs.size()},
        {VariableKind::control, control_input_count},
        {VariableKind::output, grafcet.outputs.size()},
        {VariableKind::var, grafcet.vars.size()},
        {VariableKind::counter, grafcet.counters.size()},
        {VariableKind::step, grafcet.steps.size()},
        {VariableKind::macro, grafcet.macros.size()},
        {VariableKind::graph, grafcet.graphs.size()}};
    std::vector<std::pair<std::string, Variable>> variables;
    for (const auto& [kind, count] : kinds) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const Variable variable{kind, i};
            variables.emplace_back(variable_name(grafcet, variable), variable);
        }
    }
    return variables;
}

}  // namespace

GrafcetBuilder::GrafcetBuilder(Diagnostics& diagnostics)
    : diagnostics_(diagnostics),
      errors_before_(diagnostics.error_count()),
      draft_(std::make_unique<Draft>()) {}

GrafcetBuilder::~GrafcetBuilder() = default;

void GrafcetBuilder::reserve(std::size_t transitions) {
    draft_->nodes.reserve(transitions);
    draft_->transitions.reserve(transitions);
    draft_->words.reserve(2 * transitions);
    draft_->expression_nodes.reserve(2 * transitions);
}

void GrafcetBuilder::set_name(std::string_view name, std::string_view title) {
    draft_->has_name = true;
    draft_->name = draft_->add({name, {}});
    draft_->title = draft_->add({title, {}});
}

void GrafcetBuilder::add_input(Name name) {
    draft_->declarations.push_back({VariableKind::input, draft_->add(name)});
}

void GrafcetBuilder::add_output(Name name) {
    draft_->declarations.push_back({VariableKind::output, draft_->add(name)});
}

void GrafcetBuilder::add_var(Name name) {
    draft_->declarations.push_back({VariableKind::var, draft_->add(name)});
}

void GrafcetBuilder::add_counter(Name name, std::int64_t low, std::int64_t high) {
    draft_->declarations.push_back({VariableKind::counter, draft_->add(name), low, high});
}

void GrafcetBuilder::add_assumption(const NamedExpression& expression, Location where) {
    draft_->assumptions.push_back({draft_->add(expression), where});
}

void GrafcetBuilder::add_definition(Name name, const NamedExpression& condition) {
    DraftDefinition definition;
    definition.name = draft_->add(name);
    definition.expression = draft_->add(condition);
    draft_->definitions.push_back(std::move(definition));
}

void GrafcetBuilder::add_time(Name name, Time duration) {
    draft_->durations.push_back({draft_->add(name), duration});
}

BlockId GrafcetBuilder::add_graph(Name name) {
    draft_->blocks.push_back({false, draft_->add(name)});
    return BlockId{size_of(draft_->blocks) - 1};
}

BlockId GrafcetBuilder::add_expansion(Name name) {
    draft_->blocks.push_back({true, draft_->add(name)});
    return BlockId{size_of(draft_->blocks) - 1};
}

GrafcetBuilder::StepKey GrafcetBuilder::add_node(BlockId block, Name name, StepRole role,
                                                 bool initial) {
    assert(index_of(block) < draft_->blocks.size());
    if (role != StepRole::ordinary && !draft_->blocks[index_of(block)].is_expansion) {
        diagnostics_.error(code::expansion_entry_exit, name.where,
                           outside_of_expansion_message(role == StepRole::entry));
    }
    DraftNode node;
    node.role = role;
    node.initial = initial;
    node.block = static_cast<std::uint32_t>(block);
    node.name = draft_->add(name);
    draft_->nodes.push_back(node);
    return StepKey{size_of(draft_->nodes) - 1};
}

GrafcetBuilder::StepKey GrafcetBuilder::add_step(BlockId block, Name name, bool initial) {
    return add_node(block, name, StepRole::ordinary, initial);
}

GrafcetBuilder::StepKey GrafcetBuilder::add_entry(BlockId expansion, Name name) {
    return add_node(expansion, name, StepRole::entry, false);
}

GrafcetBuilder::StepKey GrafcetBuilder::add_exit(BlockId expansion, Name name) {
    return add_node(expansion, name, StepRole::exit, false);
}

void GrafcetBuilder::add_macro(BlockId block, Name name, std::optional<Name> expansion) {
    const StepKey key = add_node(block, name, StepRole::ordinary, false);
    DraftNode& node = draft_->nodes[index_of(key)];
    node.is_macro = true;
    if (expansion) node.extra = draft_->add({&*expansion, 1}).first;
}

void GrafcetBuilder::add_continuous(StepKey step, Name output, const NamedExpression& condition,
                                    Location where) {
    DraftAction action;
    action.kind = ActionKind::continuous;
    action.node = static_cast<std::uint32_t>(step);
    action.name = draft_->add(output);
    action.expression = draft_->add(condition);
    action.where = where;
    draft_->actions.push_back(action);
}

void GrafcetBuilder::add_stored(StepKey step, const NamedWrite& write, Trigger trigger,
                                const NamedExpression& event) {
    DraftAction action;
    action.kind = ActionKind::stored;
    action.trigger = trigger;
    action.node = static_cast<std::uint32_t>(step);
    action.write = size_of(draft_->writes);
    action.where = write.where;
    draft_->writes.push_back(draft_->add(write));
    if (trigger == Trigger::event) action.expression = draft_->add(event);
    draft_->actions.push_back(action);
}

/// `G{}` and a list that turned out empty are the same order: to the empty situation.
void GrafcetBuilder::add_order(StepKey step, Name graph, OrderKind kind,
                               std::span<const Name> steps, Location where) {
    DraftAction action;
    action.kind = ActionKind::order;
    action.order = kind == OrderKind::listed && steps.empty() ? OrderKind::empty : kind;
    action.node = static_cast<std::uint32_t>(step);
    action.name = draft_->add(graph);
    if (kind == OrderKind::listed) action.steps = draft_->add(steps);
    action.where = where;
    draft_->actions.push_back(action);
}

/// Reported here, since a node has room for one.
void GrafcetBuilder::add_enclosure(StepKey step, Name graph, std::span<const Name> links) {
    DraftNode& node = draft_->nodes[index_of(step)];
    if (node.extra != none) {
        diagnostics_.error(code::encloses_twice, graph.where,
                           encloses_twice_message(draft_->text(node.name)));
        return;
    }
    node.extra = size_of(draft_->enclosures);
    DraftEnclosure enclosure;
    enclosure.graph = draft_->add(graph);
    enclosure.links = draft_->add(links);
    draft_->enclosures.push_back(enclosure);
}

void GrafcetBuilder::add_transition(BlockId block, const NamedTransition& transition) {
    DraftTransition added;
    added.block = static_cast<std::uint32_t>(block);
    added.labelled = transition.label.has_value();
    if (transition.label) added.label = draft_->add(*transition.label);
    added.preceding = draft_->add(transition.preceding);
    added.following = draft_->add(transition.following);
    added.condition = draft_->add(transition.condition);
    added.writes = {size_of(draft_->writes), size_of(transition.writes)};
    for (const NamedWrite& write : transition.writes) {
        draft_->writes.push_back(draft_->add(write));
    }
    added.where = transition.where;
    draft_->transitions.push_back(added);
}

/// The draft goes before the warnings are looked for: it is as large as the model.
std::optional<Grafcet> GrafcetBuilder::finish() {
    const auto is_refused = [this] { return diagnostics_.error_count() != errors_before_; };
    std::optional<Grafcet> grafcet;
    {
        Draft draft = std::exchange(*draft_, {});
        draft.arrange();
        Names names;
        Suggestions suggestions(draft);
        const Checking checking{draft, names, suggestions, diagnostics_};
        check(checking);
        if (!is_refused()) check_parts(checking);
        if (!is_refused()) {
            warn_unread(checking);
            grafcet = build_model(draft);
        }
    }
    if (grafcet) {
        assert(fault_of(*grafcet).empty());
        refuse_no_steps(*grafcet, diagnostics_);
        refuse_contradictions(*grafcet, 0, diagnostics_);
        warn_about(*grafcet, diagnostics_);
        if (is_refused()) grafcet.reset();
    }
    diagnostics_.sort_by_place();
    return grafcet;
}

Localized encloses_twice_message(std::string_view step) {
    return say::encloses_twice(quoted(step));
}

Localized outside_of_expansion_message(bool is_entry) {
    return is_entry ? say::entry_outside_of_expansion() : say::exit_outside_of_expansion();
}

/// A draft of nothing but the assumption, over a table of names that is made from the model.
void add_assumption(Grafcet& grafcet, const NamedExpression& expression, Location where,
                    Diagnostics& diagnostics) {
    Draft draft;
    draft.assumptions.push_back({draft.add(expression), where});
    draft.arrange();
    const std::vector<std::pair<std::string, Variable>> variables = variables_of(grafcet);
    Names names;
    std::vector<std::string_view> inputs;
    for (const auto& [name, variable] : variables) {
        names.variables.add(name, Names::Declared{variable, none});
        const bool is_input =
            variable.kind == VariableKind::input || variable.kind == VariableKind::control;
        if (is_input) inputs.push_back(name);
    }
    Suggestions suggestions(draft, inputs);
    const Checking checking{draft, names, suggestions, diagnostics};
    const DraftExpression added = draft.assumptions.front().expression;
    resolve_expression(checking, added, ExpressionUse::assumption);
    if (!diagnostics.has_errors()) check_parts(checking);
    if (diagnostics.has_errors()) return;
    const std::size_t first_here = grafcet.assumptions.size();
    grafcet.assumptions.push_back(
        {build_expression(draft, added, {}, {}, {}, grafcet.expressions), where});
    refuse_contradictions(grafcet, first_here, diagnostics);
}

}  // namespace grafwire
