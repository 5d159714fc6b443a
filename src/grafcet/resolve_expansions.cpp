// Macro-steps and expansions. Every expansion is named by one macro-step, so from each block one
// path of macro-steps leads outwards to the graph that it belongs to. The paths are walked without
// recursion and every block is settled once; a path that meets itself is an expansion that would
// contain itself.

#include "grafcet/checking.h"
#include "grafcet/messages.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// Finds the expansion that a macro-step names; a second macro-step that names it is an error.
void join_macro(const Checking& checking, std::uint32_t index) {
    Draft& draft = checking.draft;
    DraftNode& macro = draft.nodes[index];
    if (macro.extra == none) return;
    const Word& word = draft.words[macro.extra];
    const std::string_view name = draft.text(word);
    const std::uint32_t* expansion = checking.names.expansions.find(name);
    if (expansion == nullptr) {
        const bool is_graph = checking.names.graphs.find(name) != nullptr;
        checking.error(
            code::unknown_name, word.where,
            is_graph ? say::expanded_by_graph(checking.shown(word), name)
                     : checking.suggestions.with_nearest(
                           say::unknown_expansion(checking.shown(word)), name, Meant::expansion));
        return;
    }
    macro.resolved = *expansion;
    DraftBlock& block = draft.blocks[*expansion];
    if (block.macro == none) {
        block.macro = index;
        return;
    }
    checking
        .error(code::expansion_use, word.where,
               say::expansion_used_twice(checking.shown(word),
                                         checking.shown(draft.nodes[block.macro].name)))
        .notes.push_back({draft.nodes[block.macro].name.where, say::first_used_here()});
}

/// An expansion has one entry step and one exit step.
void check_ends(const Checking& checking, std::uint32_t index) {
    Draft& draft = checking.draft;
    DraftBlock& block = draft.blocks[index];
    for (const std::uint32_t i : draft.nodes_of_block.of(index)) {
        const DraftNode& node = draft.nodes[i];
        if (node.role == StepRole::ordinary) continue;
        const bool is_entry = node.role == StepRole::entry;
        std::uint32_t& end = is_entry ? block.entry : block.exit;
        if (end == none) {
            end = i;
            continue;
        }
        checking
            .error(code::expansion_entry_exit, node.name.where,
                   (is_entry ? say::second_entry : say::second_exit)(checking.shown(block.name)))
            .notes.push_back({draft.nodes[end].name.where, say::first_one_here()});
    }
    for (const bool is_entry : {true, false}) {
        if ((is_entry ? block.entry : block.exit) == none) {
            checking.error(code::expansion_entry_exit, block.name.where,
                           (is_entry ? say::no_entry : say::no_exit)(checking.shown(block.name)));
        }
    }
}

/// `path` ends with the block at which it met itself.
void report_circle(const Checking& checking, const std::vector<std::uint32_t>& path) {
    std::size_t first = path.size() - 1;
    while (path[first - 1] != path.back()) --first;
    --first;
    std::vector<Localized> names;
    // The path leads outwards; the message tells which expansion contains which.
    for (std::size_t i = path.size(); i-- > first;) {
        names.push_back(checking.shown(checking.draft.blocks[path[i]].name));
    }
    checking.error(
        code::expansion_use, checking.draft.blocks[path.back()].name.where,
        say::expansion_contains_itself(checking.shown(checking.draft.blocks[path.back()].name),
                                       joined(names, " → ")));
}

void find_roots(const Checking& checking) {
    Draft& draft = checking.draft;
    enum class State : std::uint8_t { untouched, on_path, settled };
    std::vector<State> states(draft.blocks.size(), State::untouched);
    std::vector<std::uint32_t> path;
    for (std::uint32_t start = 0; start < draft.blocks.size(); ++start) {
        path.clear();
        std::uint32_t block = start;
        std::uint32_t root = none;
        while (true) {
            path.push_back(block);
            if (states[block] == State::settled) {
                root = draft.blocks[block].root;
                break;
            }
            if (states[block] == State::on_path) {
                report_circle(checking, path);
                break;
            }
            states[block] = State::on_path;
            if (!draft.blocks[block].is_expansion) root = block;
            if (root != none || draft.blocks[block].macro == none) break;
            block = draft.nodes[draft.blocks[block].macro].block;
        }
        for (const std::uint32_t item : path) {
            states[item] = State::settled;
            draft.blocks[item].root = root;
        }
    }
}

}  // namespace

void resolve_expansions(const Checking& checking) {
    Draft& draft = checking.draft;
    for (std::uint32_t i = 0; i < draft.nodes.size(); ++i) {
        if (draft.nodes[i].is_macro) join_macro(checking, i);
    }
    for (std::uint32_t i = 0; i < draft.blocks.size(); ++i) {
        const DraftBlock& block = draft.blocks[i];
        if (!block.is_expansion || block.name.length == 0) continue;
        check_ends(checking, i);
        const std::uint32_t* named = checking.names.expansions.find(draft.text(block.name));
        if (block.macro == none && *named == i) {
            checking.error(
                code::expansion_use, block.name.where,
                say::unused_expansion(checking.shown(block.name), draft.text(block.name)));
        }
    }
    find_roots(checking);
}

}  // namespace grafwire
