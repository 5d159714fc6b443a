#include <fmt/format.h>

#include "grafcet/lexer.h"
#include "grafcet/names.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

bool is_before(Location a, Location b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
}

void report_twice(const Checking& checking, std::string_view what, const Word& word, Location first,
                  std::string_view advice) {
    checking
        .error(Code::duplicate_name, word.where,
               fmt::format("{} {} exists already; {}", what, checking.shown(word), advice))
        .notes.push_back({first, "it is first declared here"});
}

void check_counter(const Checking& checking, const DeclarationSyntax& counter) {
    constexpr std::int64_t most_values = 65'536;
    const std::int64_t values = counter.high - counter.low + 1;
    if (values < 1)
        checking.error(Code::counter_range, counter.name.where,
                       fmt::format("the range {}..{} of counter {} is empty; write the lowest "
                                   "value first",
                                   counter.low, counter.high, checking.shown(counter.name)));
    else if (values > most_values)
        checking.error(Code::counter_range, counter.name.where,
                       fmt::format("the range {}..{} of counter {} spans {} values; a counter has "
                                   "{} at most",
                                   counter.low, counter.high, checking.shown(counter.name), values,
                                   most_values));
}

void collect_variables(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    auto& variables = checking.names.variables;
    constexpr std::string_view controls[control_input_count] = {"Init", "AUdur", "AUdoux"};
    for (std::uint32_t i = 0; i < control_input_count; ++i)
        variables.add(controls[i], Names::Declared{{VariableKind::control, i}, none});
    std::uint32_t counts[5] = {};
    for (std::uint32_t i = 0; i < syntax.declarations.size(); ++i) {
        const DeclarationSyntax& declaration = syntax.declarations[i];
        if (declaration.kind == VariableKind::counter) check_counter(checking, declaration);
        std::uint32_t& count = counts[static_cast<std::size_t>(declaration.kind)];
        const auto [first, is_new] = variables.add(syntax.text(declaration.name),
                                                   Names::Declared{{declaration.kind, count}, i});
        ++count;
        if (is_new) continue;
        if (first.declaration == none)
            checking.error(Code::duplicate_name, declaration.name.where,
                           fmt::format("{} is a control input, which every GRAFCET has without "
                                       "declaring it; remove this declaration or choose another "
                                       "name",
                                       checking.shown(declaration.name)));
        else
            report_twice(checking, "the variable", declaration.name,
                         syntax.declarations[first.declaration].name.where,
                         "rename one of the two");
    }
}

void collect_blocks(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    for (std::uint32_t i = 0; i < syntax.blocks.size(); ++i) {
        const BlockSyntax& block = syntax.blocks[i];
        if (block.name.length == 0) continue;
        auto& names = block.is_expansion ? checking.names.expansions : checking.names.graphs;
        const auto [first, is_new] = names.add(syntax.text(block.name), i);
        if (!is_new)
            report_twice(checking, block.is_expansion ? "the expansion" : "the graph", block.name,
                         syntax.blocks[first].name.where, "rename one of the two");
    }
}

void collect_nodes(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    auto& nodes = checking.names.nodes;
    nodes.reserve(syntax.nodes.size());
    for (std::uint32_t i = 0; i < syntax.nodes.size(); ++i) {
        const Word& name = syntax.nodes[i].name;
        const auto [first, is_new] = nodes.add(syntax.text(name), i);
        if (!is_new)
            report_twice(checking, "the step", name, syntax.nodes[first].name.where,
                         "step names are unique in the whole file, so rename one of the two");
    }
}

// The rank that a label spells, or none: `01` is a name of its own.
std::uint32_t rank_of(std::string_view label, std::size_t transition_count) {
    constexpr std::size_t most_digits = 9;
    if (!is_integer(label) || label.size() > most_digits) return none;
    if (label.size() > 1 && label[0] == '0') return none;
    std::uint32_t rank = 0;
    for (const char digit : label) rank = rank * 10 + static_cast<std::uint32_t>(digit - '0');
    return rank < transition_count ? rank : none;
}

void collect_labels(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    NameTable<std::uint32_t> labels;
    for (std::uint32_t i = 0; i < syntax.transitions.size(); ++i) {
        const TransitionSyntax& transition = syntax.transitions[i];
        if (!transition.labelled) continue;
        const std::string_view text = syntax.text(transition.label);
        const auto [first, is_new] = labels.add(text, i);
        if (!is_new) {
            report_twice(checking, "the transition", transition.label,
                         syntax.transitions[first].label.where,
                         "transition names are unique in the whole file, so rename one of the two");
            continue;
        }
        const std::uint32_t rank = rank_of(text, syntax.transitions.size());
        if (rank == none || syntax.transitions[rank].labelled) continue;
        checking
            .error(Code::duplicate_name, transition.label.where,
                   fmt::format("the label {} is also the rank of a transition without a label; "
                               "label that one too, or choose another label",
                               checking.shown(transition.label)))
            .notes.push_back(
                {syntax.transitions[rank].where,
                 fmt::format("this transition has rank {}: it is named '{}'", rank, rank)});
    }
}

std::string_view kind_name(VariableKind kind) {
    switch (kind) {
        case VariableKind::input:
            return "input";
        case VariableKind::output:
            return "output";
        case VariableKind::var:
            return "var";
        case VariableKind::counter:
            return "counter";
        default:
            return "control input";
    }
}

// Reports at the later of the two places, with a note at the other.
void report_clash(const Checking& checking, std::string_view variable, const std::string& a,
                  Location where_a, const std::string& b, Location where_b) {
    const bool a_is_later = is_before(where_b, where_a);
    checking
        .error(Code::variable_clash, a_is_later ? where_a : where_b,
               fmt::format("{} and {} both have the variable {}; rename one of them",
                           a_is_later ? b : a, a_is_later ? a : b, in_quotes(variable)))
        .notes.push_back({a_is_later ? where_b : where_a,
                          fmt::format("{} is declared here", a_is_later ? b : a)});
}

void check_clashes(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    for (const DeclarationSyntax& declaration : syntax.declarations) {
        const std::string_view name = syntax.text(declaration.name);
        if (name.size() < 2 || name[0] != 'X') continue;
        const std::string shown =
            fmt::format("{} {}", kind_name(declaration.kind), checking.shown(declaration.name));
        if (const auto* node = checking.names.nodes.find(name.substr(1)))
            report_clash(checking, name, shown, declaration.name.where, checking.shown_node(*node),
                         syntax.nodes[*node].name.where);
        if (const auto* graph = checking.names.graphs.find(name.substr(1)))
            report_clash(checking, name, shown, declaration.name.where,
                         checking.shown_block(*graph), syntax.blocks[*graph].name.where);
    }
    for (std::uint32_t i = 0; i < syntax.blocks.size(); ++i) {
        const BlockSyntax& block = syntax.blocks[i];
        if (block.is_expansion || block.name.length == 0) continue;
        const std::string_view name = syntax.text(block.name);
        if (const auto* node = checking.names.nodes.find(name))
            report_clash(checking, fmt::format("X{}", name), checking.shown_block(i),
                         block.name.where, checking.shown_node(*node),
                         syntax.nodes[*node].name.where);
    }
}

}  // namespace

void collect_names(const Checking& checking) {
    collect_variables(checking);
    collect_blocks(checking);
    collect_nodes(checking);
    collect_labels(checking);
    check_clashes(checking);
}

}  // namespace grafwire
