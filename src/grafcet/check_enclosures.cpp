#include <fmt/format.h>

#include "grafcet/names.h"

namespace grafwire {

namespace {

// For each block of a graph the step that encloses it first, or none.
std::vector<std::uint32_t> enclosing_steps(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    std::vector<std::uint32_t> result(syntax.blocks.size(), none);
    for (std::uint32_t i = 0; i < syntax.nodes.size(); ++i) {
        const NodeSyntax& node = syntax.nodes[i];
        if (node.kind == NodeKind::macro || node.extra == none) continue;
        const EnclosureSyntax& enclosure = syntax.enclosures[node.extra];
        if (enclosure.resolved == none) continue;
        std::uint32_t& first = result[enclosure.resolved];
        if (first == none) {
            first = i;
            continue;
        }
        checking
            .error(
                Code::enclosed_twice, enclosure.graph.where,
                fmt::format("{} is enclosed by {} already; a graph is enclosed by one step at "
                            "most",
                            checking.shown_block(enclosure.resolved), checking.shown_node(first)))
            .notes.push_back({syntax.nodes[first].name.where, "it is first enclosed here"});
    }
    return result;
}

void report_initial_mismatch(const Checking& checking, std::uint32_t node, std::uint32_t graph,
                             std::uint32_t enclosing) {
    const Syntax& syntax = checking.syntax;
    checking
        .error(Code::enclosure_initial_mismatch, syntax.nodes[node].name.where,
               fmt::format("{} is initial, but {}, which encloses its graph {}, is not; make both "
                           "initial or neither",
                           checking.shown_node(node), checking.shown_node(enclosing),
                           checking.shown(syntax.blocks[graph].name)))
        .notes.push_back({syntax.nodes[enclosing].name.where, "the enclosing step is here"});
}

}  // namespace

void check_enclosures(const Checking& checking) {
    const Syntax& syntax = checking.syntax;
    const std::vector<std::uint32_t> enclosing = enclosing_steps(checking);
    std::vector<bool> has_initial(syntax.blocks.size(), false);
    for (std::uint32_t i = 0; i < syntax.nodes.size(); ++i) {
        const std::uint32_t graph = syntax.blocks[syntax.nodes[i].block].root;
        if (!syntax.nodes[i].initial || graph == none) continue;
        has_initial[graph] = true;
        const std::uint32_t step = enclosing[graph];
        if (step != none && !syntax.nodes[step].initial)
            report_initial_mismatch(checking, i, graph, step);
    }
    for (std::uint32_t graph = 0; graph < syntax.blocks.size(); ++graph) {
        const std::uint32_t step = enclosing[graph];
        if (step == none || !syntax.nodes[step].initial || has_initial[graph]) continue;
        checking
            .error(
                Code::enclosure_initial_mismatch, syntax.nodes[step].name.where,
                fmt::format("{} is initial, but {}, which it encloses, has no initial step; make "
                            "both initial or neither",
                            checking.shown_node(step), checking.shown_block(graph)))
            .notes.push_back({syntax.blocks[graph].name.where, "the enclosed graph is here"});
    }
}

}  // namespace grafwire
