// Reading runs in three passes over a file: parse_syntax gives the file as written and goes on
// after an error at the next part of it; the checks resolve every name and report all that the
// rules of the language refuse; only of a file without errors is the model built, and that is where
// warnings come from.

#include "grafcet/parse_grafcet.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "grafcet/names.h"
#include "grafcet/plant_conditions.h"
#include "grafcet/syntax_parser.h"
#include "grafcet/warnings.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

bool is_readable(const SourceFile& source, Diagnostics& diagnostics) {
    if (source.text.size() >= std::numeric_limits<std::uint32_t>::max()) {
        diagnostics.error(Code::unreadable_file, {},
                          "the file is larger than 4 GiB; cut the GRAFCET into several");
        return false;
    }
    return check_utf8(source.text, diagnostics);
}

void check(const Checking& checking) {
    collect_names(checking);
    resolve_expansions(checking);
    for (const ExpressionSyntax& assumption : checking.syntax.assumptions)
        resolve_expression(checking, assumption, ExpressionUse::assumption);
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
        diagnostics.error(Code::contradicting_assumptions, last.where,
                          "this assumption is never 1, so that no input is left");
        return;
    }
    Diagnostic& error = diagnostics.error(
        Code::contradicting_assumptions, last.where,
        contradicting.size() == 1
            ? "this assumption contradicts another, so that no input is left"
            : fmt::format(
                  "this assumption contradicts {} others together, so that no input is left",
                  contradicting.size()));
    for (const std::size_t i : contradicting) {
        const Assumption& other = grafcet.assumptions[i];
        const std::string text = write_expression(grafcet, grafcet.expressions, other.expression);
        error.notes.push_back(
            {i < first_here ? Location{} : other.where, fmt::format("the other: assume {}", text)});
    }
}

void refuse_no_steps(const Grafcet& grafcet, Diagnostics& diagnostics) {
    if (!grafcet.steps.empty()) return;
    const Location where =
        grafcet.blocks.empty() ? Location{1, 1} : grafcet.blocks.items().front().where;
    diagnostics.error(Code::no_steps, where,
                      "there is no step, and a GRAFCET needs one at least: graph G { initial 0 }");
}

std::vector<std::string_view> input_names(const Grafcet& grafcet) {
    std::vector<std::string_view> result;
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i)
        result.push_back(input_name(grafcet, i));
    return result;
}

// Of the variables of a model: the inputs and control inputs, which an assumption may read, and the
// others, so that they are refused for what they are. `step_variables` keeps the text of names.
Names names_for_assumption(const Grafcet& grafcet, const Syntax& syntax,
                           std::vector<std::string>& step_variables) {
    Names names;
    const auto add = [&names](std::string_view name, VariableKind kind, std::size_t index) {
        names.variables.add(name, Names::Declared{{kind, static_cast<std::uint32_t>(index)}, none});
    };
    const auto add_all = [&add](const auto& items, VariableKind kind) {
        for (std::size_t i = 0; i < items.size(); ++i) add(items.items()[i].name, kind, i);
    };
    for (std::size_t i = 0; i < control_input_count; ++i)
        add(input_name(grafcet, grafcet.inputs.size() + i), VariableKind::control, i);
    add_all(grafcet.inputs, VariableKind::input);
    add_all(grafcet.outputs, VariableKind::output);
    add_all(grafcet.vars, VariableKind::var);
    add_all(grafcet.counters, VariableKind::counter);
    const bool reads_more =
        std::any_of(syntax.expression_nodes.begin(), syntax.expression_nodes.end(),
                    [&](const ExpressionNode& node) {
                        return node.kind == ExprKind::variable &&
                               names.variables.find(syntax.text(node.word)) == nullptr;
                    });
    if (!reads_more) return names;
    const auto add_steps = [&step_variables](const auto& items) {
        for (const auto& item : items) step_variables.push_back(fmt::format("X{}", item.name));
    };
    add_steps(grafcet.steps);
    add_steps(grafcet.macros);
    add_steps(grafcet.graphs);
    for (const std::string& name : step_variables) add(name, VariableKind::step, 0);
    return names;
}

}  // namespace

std::optional<Grafcet> parse_grafcet(const SourceFile& source, Diagnostics& diagnostics) {
    if (!is_readable(source, diagnostics)) return std::nullopt;
    const std::size_t errors_before = diagnostics.error_count();
    std::optional<Grafcet> grafcet;
    {
        Syntax syntax = SyntaxParser(source.text, diagnostics).parse_file();
        syntax.word_nodes.assign(syntax.words.size(), none);
        Names names;
        Suggestions suggestions(syntax);
        check({syntax, names, suggestions, diagnostics});
        if (diagnostics.error_count() == errors_before) grafcet = build_model(syntax);
    }
    if (grafcet) {
        refuse_no_steps(*grafcet, diagnostics);
        refuse_contradictions(*grafcet, 0, diagnostics);
        warn_about(*grafcet, diagnostics);
        if (diagnostics.error_count() != errors_before) grafcet.reset();
    }
    diagnostics.sort_by_place();
    return grafcet;
}

void parse_assumption(const SourceFile& source, Grafcet& grafcet, Diagnostics& diagnostics) {
    if (!is_readable(source, diagnostics)) return;
    const std::size_t errors_before = diagnostics.error_count();
    Syntax syntax = SyntaxParser(source.text, diagnostics).parse_lone_expression();
    std::vector<std::string> step_variables;
    Names names = names_for_assumption(grafcet, syntax, step_variables);
    Suggestions suggestions(syntax, input_names(grafcet));
    const Checking checking{syntax, names, suggestions, diagnostics};
    for (const ExpressionSyntax& assumption : syntax.assumptions)
        resolve_expression(checking, assumption, ExpressionUse::assumption);
    if (diagnostics.error_count() == errors_before) {
        const std::size_t first_here = grafcet.assumptions.size();
        for (const ExpressionSyntax& assumption : syntax.assumptions)
            grafcet.assumptions.push_back(
                {build_expression(syntax, assumption, {}, {}, grafcet.expressions),
                 assumption.where});
        refuse_contradictions(grafcet, first_here, diagnostics);
    }
    diagnostics.sort_by_place();
}

}  // namespace grafwire
