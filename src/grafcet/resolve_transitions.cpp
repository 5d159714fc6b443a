#include <fmt/format.h>

#include <algorithm>

#include "grafcet/names.h"

namespace grafwire {

namespace {

void resolve_side(const Checking& checking, std::uint32_t block, Range<> list) {
    resolve_steps(checking, list, [&](std::uint32_t node, const Word& word) {
        const NodeSyntax& step = checking.syntax.nodes[node];
        if (step.block == block) return true;
        checking
            .error(
                Code::step_of_another_graph, word.where,
                fmt::format("{} belongs to {}; a transition of {} names steps and macro-steps of "
                            "that {} only",
                            checking.shown_node(node), checking.shown_block(step.block),
                            checking.shown_block(block),
                            checking.syntax.blocks[block].is_expansion ? "expansion" : "graph"))
            .notes.push_back(
                {step.name.where, fmt::format("{} is declared here", checking.shown_node(node))});
        return false;
    });
}

}  // namespace

void report_repeated_steps(const Checking& checking, Range<> list) {
    if (list.count < 2) return;
    const Syntax& syntax = checking.syntax;
    std::vector<std::uint32_t> places;
    for (std::uint32_t i = list.first; i < list.first + list.count; ++i)
        if (syntax.word_nodes[i] != none) places.push_back(i);
    std::sort(places.begin(), places.end(), [&syntax](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t node_a = syntax.word_nodes[a];
        const std::uint32_t node_b = syntax.word_nodes[b];
        return node_a != node_b ? node_a < node_b : a < b;
    });
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (syntax.word_nodes[places[i - 1]] != syntax.word_nodes[places[i]]) continue;
        checking
            .error(Code::duplicate_name, syntax.words[places[i]].where,
                   fmt::format("{} is named twice in this list; name it once",
                               checking.shown_node(syntax.word_nodes[places[i]])))
            .notes.push_back({syntax.words[places[i - 1]].where, "it is named here too"});
    }
}

void resolve_transitions(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    for (std::uint32_t block = 0; block < syntax.blocks.size(); ++block) {
        const Range<> range = syntax.blocks[block].transitions;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const TransitionSyntax& transition = syntax.transitions[i];
            resolve_side(checking, block, transition.preceding);
            resolve_side(checking, block, transition.following);
            if (transition.preceding.count == 0 && transition.following.count == 0)
                checking.error(Code::transition_without_step, transition.where,
                               "this transition has no step before it and none after it; name at "
                               "least one, as in 1 -> 2");
            resolve_expression(checking, transition.condition, ExpressionUse::receptivity);
        }
    }
}

}  // namespace grafwire
