#include <fmt/format.h>

#include "grafcet/names.h"
#include "text/utf8.h"

namespace grafwire {

std::string Checking::shown(const Word& word) const {
    return in_quotes(syntax.text(word));
}

std::string Checking::shown_block(std::uint32_t block) const {
    const BlockSyntax& item = syntax.blocks[block];
    return fmt::format("{} {}", item.is_expansion ? "expansion" : "graph", shown(item.name));
}

std::string Checking::shown_node(std::uint32_t node) const {
    const NodeSyntax& item = syntax.nodes[node];
    return fmt::format("{} {}", item.kind == NodeKind::macro ? "macro-step" : "step",
                       shown(item.name));
}

std::string Suggestions::did_you_mean(std::string_view name, Meant meant) {
    constexpr std::size_t most_work = 400'000'000;
    constexpr std::size_t longest_name = 100;
    if (name.size() > longest_name) return {};
    List& list = lists_[static_cast<std::size_t>(meant)];
    if (!list.is_made) make(list, meant);
    work_done_ += list.names.size() * (1 + name.size() * name.size() / 8);
    if (work_done_ > most_work) return {};
    const std::string_view nearest = nearest_name(name, list.names);
    if (nearest.empty() || nearest == name) return {};
    return fmt::format("; did you mean {}?", in_quotes(nearest));
}

void Suggestions::make(List& list, Meant meant) {
    list.is_made = true;
    if (meant == Meant::step)
        for (const NodeSyntax& node : syntax_.nodes) list.names.push_back(syntax_.text(node.name));
    if (meant == Meant::graph || meant == Meant::expansion)
        for (const BlockSyntax& block : syntax_.blocks)
            if (block.is_expansion == (meant == Meant::expansion))
                list.names.push_back(syntax_.text(block.name));
    if (meant == Meant::variable || meant == Meant::written || meant == Meant::counter)
        for (const DeclarationSyntax& declaration : syntax_.declarations) {
            const bool is_counter = declaration.kind == VariableKind::counter;
            const bool fits = meant == Meant::variable  ? !is_counter
                              : meant == Meant::counter ? is_counter
                                                        : declaration.kind != VariableKind::input;
            if (fits) list.names.push_back(syntax_.text(declaration.name));
        }
    if (meant != Meant::variable) return;
    list.names.insert(list.names.end(), more_.begin(), more_.end());
    step_variables_.reserve(syntax_.nodes.size() + syntax_.blocks.size());
    for (const NodeSyntax& node : syntax_.nodes)
        step_variables_.push_back(fmt::format("X{}", syntax_.text(node.name)));
    for (const BlockSyntax& block : syntax_.blocks)
        if (!block.is_expansion)
            step_variables_.push_back(fmt::format("X{}", syntax_.text(block.name)));
    list.names.insert(list.names.end(), step_variables_.begin(), step_variables_.end());
}

}  // namespace grafwire
