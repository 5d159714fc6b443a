// The names of a chart, and what is said about them. Of a name used twice the first use counts, so
// that everything else can still be looked up and all errors are reported at once.
//
// An unknown name is answered with the nearest declared one. Finding it costs a comparison with
// every name, so the work is counted: after a fixed amount nothing more is suggested, and a chart
// full of mistakes is still read in time proportional to its size.

#include <fmt/format.h>

#include "grafcet/checking.h"
#include "grafcet/lexer.h"
#include "grafcet/messages.h"
#include "text/messages.h"
#include "text/nearest_name.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// At the second use, with a note at the first.
void report_twice(const Checking& checking, const Message<Localized>& message, const Word& word,
                  Location first) {
    checking.error(code::duplicate_name, word.where, message(checking.shown(word)))
        .notes.push_back({first, say::first_declared_here()});
}

/// The values of a counter become registers and states, so their number is bounded.
void check_counter(const Checking& checking, const DraftDeclaration& counter) {
    constexpr std::int64_t most_values = 65'536;
    for (const std::int64_t bound : {counter.low, counter.high}) {
        if (bound >= -largest_number && bound <= largest_number) continue;
        checking.error(code::number_too_large, counter.name.where, number_too_large_message(bound));
        return;
    }
    const std::int64_t values = counter.high - counter.low + 1;
    if (values < 1) {
        checking.error(code::counter_range, counter.name.where,
                       say::empty_range(counter.low, counter.high, checking.shown(counter.name)));
    } else if (values > most_values) {
        checking.error(code::counter_range, counter.name.where,
                       say::range_too_wide(counter.low, counter.high, checking.shown(counter.name),
                                           values, most_values));
    }
}

/// Declared variables share one table with the control inputs, which nobody may declare.
void collect_variables(const Checking& checking) {
    const Draft& draft = checking.draft;
    auto& variables = checking.names.variables;
    constexpr std::string_view controls[control_input_count] = {"Init", "AUdur", "AUdoux"};
    for (std::uint32_t i = 0; i < control_input_count; ++i) {
        variables.add(controls[i], Names::Declared{{VariableKind::control, i}, none});
    }
    std::uint32_t counts[5] = {};
    for (std::uint32_t i = 0; i < draft.declarations.size(); ++i) {
        const DraftDeclaration& declaration = draft.declarations[i];
        if (declaration.kind == VariableKind::counter) check_counter(checking, declaration);
        std::uint32_t& count = counts[static_cast<std::size_t>(declaration.kind)];
        const auto [first, is_new] = variables.add(draft.text(declaration.name),
                                                   Names::Declared{{declaration.kind, count}, i});
        ++count;
        if (is_new) continue;
        if (first.declaration == none) {
            checking.error(code::duplicate_name, declaration.name.where,
                           say::control_input_declared(checking.shown(declaration.name)));
        } else {
            report_twice(checking, say::variable_twice, declaration.name,
                         draft.declarations[first.declaration].name.where);
        }
    }
}

/// A graph and an expansion may have the same name: the language never takes one for the other.
void collect_blocks(const Checking& checking) {
    const Draft& draft = checking.draft;
    for (std::uint32_t i = 0; i < draft.blocks.size(); ++i) {
        const DraftBlock& block = draft.blocks[i];
        if (block.name.length == 0) continue;
        auto& names = block.is_expansion ? checking.names.expansions : checking.names.graphs;
        const auto [first, is_new] = names.add(draft.text(block.name), i);
        if (!is_new) {
            report_twice(checking, block.is_expansion ? say::expansion_twice : say::graph_twice,
                         block.name, draft.blocks[first].name.where);
        }
    }
}

/// Steps and macro-steps share their names over all graphs.
void collect_nodes(const Checking& checking) {
    const Draft& draft = checking.draft;
    auto& nodes = checking.names.nodes;
    nodes.reserve(draft.nodes.size());
    for (std::uint32_t i = 0; i < draft.nodes.size(); ++i) {
        const Word& name = draft.nodes[i].name;
        const auto [first, is_new] = nodes.add(draft.text(name), i);
        if (!is_new) {
            report_twice(checking, say::step_twice, name, draft.nodes[first].name.where);
        }
    }
}

/// The rank that a label spells, or none: `01` is a name of its own.
std::uint32_t rank_of(std::string_view label, std::size_t transition_count) {
    constexpr std::size_t most_digits = 9;
    if (!is_integer(label) || label.size() > most_digits) return none;
    if (label.size() > 1 && label[0] == '0') return none;
    std::uint32_t rank = 0;
    for (const char digit : label) rank = rank * 10 + static_cast<std::uint32_t>(digit - '0');
    return rank < transition_count ? rank : none;
}

/// A label must not be what a transition without a label is called: its rank.
void collect_labels(const Checking& checking) {
    const Draft& draft = checking.draft;
    NameTable<std::uint32_t> labels;
    for (std::uint32_t i = 0; i < draft.transitions.size(); ++i) {
        const DraftTransition& transition = draft.transitions[i];
        if (!transition.labelled) continue;
        const std::string_view text = draft.text(transition.label);
        const auto [first, is_new] = labels.add(text, i);
        if (!is_new) {
            report_twice(checking, say::transition_twice, transition.label,
                         draft.transitions[first].label.where);
            continue;
        }
        const std::uint32_t rank = rank_of(text, draft.transitions.size());
        if (rank == none || draft.transitions[rank].labelled) continue;
        checking
            .error(code::duplicate_name, transition.label.where,
                   say::label_is_rank(checking.shown(transition.label)))
            .notes.push_back({draft.transitions[rank].where, say::transition_of_rank(rank)});
    }
}

/// The row that names a declared variable with its kind.
const Message<Localized>& row_of(VariableKind kind) {
    switch (kind) {
        case VariableKind::input:
            return say::input_named;
        case VariableKind::output:
            return say::output_named;
        case VariableKind::var:
            return say::var_named;
        default:
            return say::counter_named;
    }
}

/// Reports at the later of the two places, with a note at the other.
void report_clash(const Checking& checking, std::string_view variable, const Localized& a,
                  Location where_a, const Localized& b, Location where_b) {
    const bool a_is_later = is_before(where_b, where_a);
    checking
        .error(code::variable_clash, a_is_later ? where_a : where_b,
               say::variable_clash(a_is_later ? b : a, a_is_later ? a : b, quoted(variable)))
        .notes.push_back({a_is_later ? where_b : where_a, say::declared_here(a_is_later ? b : a)});
}

/// `X5` is the variable of step 5, or of graph 5: no declared variable may be called so, and no
/// graph like a step.
void check_clashes(const Checking& checking) {
    const Draft& draft = checking.draft;
    for (const DraftDeclaration& declaration : draft.declarations) {
        const std::string_view name = draft.text(declaration.name);
        if (name.size() < 2 || name[0] != 'X') continue;
        const Localized shown = row_of(declaration.kind)(checking.shown(declaration.name));
        if (const auto* node = checking.names.nodes.find(name.substr(1))) {
            report_clash(checking, name, shown, declaration.name.where, checking.shown_node(*node),
                         draft.nodes[*node].name.where);
        }
        if (const auto* graph = checking.names.graphs.find(name.substr(1))) {
            report_clash(checking, name, shown, declaration.name.where,
                         checking.shown_block(*graph), draft.blocks[*graph].name.where);
        }
    }
    for (std::uint32_t i = 0; i < draft.blocks.size(); ++i) {
        const DraftBlock& block = draft.blocks[i];
        if (block.is_expansion || block.name.length == 0) continue;
        const std::string_view name = draft.text(block.name);
        if (const auto* node = checking.names.nodes.find(name)) {
            report_clash(checking, fmt::format("X{}", name), checking.shown_block(i),
                         block.name.where, checking.shown_node(*node),
                         draft.nodes[*node].name.where);
        }
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

Localized Checking::shown(const Word& word) const {
    return quoted(draft.text(word));
}

Localized Checking::shown_block(std::uint32_t block) const {
    const DraftBlock& item = draft.blocks[block];
    return (item.is_expansion ? say::expansion_named : say::graph_named)(shown(item.name));
}

Localized Checking::shown_node(std::uint32_t node) const {
    const DraftNode& item = draft.nodes[node];
    return (item.is_macro ? say::macro_step_named : say::step_named)(shown(item.name));
}

Localized Suggestions::with_nearest(Localized message, std::string_view name, Meant meant) {
    constexpr std::size_t most_work = 400'000'000;
    constexpr std::size_t longest_name = 100;
    if (name.size() > longest_name) return message;
    List& list = lists_[static_cast<std::size_t>(meant)];
    if (!list.is_made) make(list, meant);
    work_done_ += list.names.size() * (1 + name.size() * name.size() / 8);
    if (work_done_ > most_work) return message;
    const std::string_view nearest = nearest_name(name, list.names);
    if (nearest.empty() || nearest == name) return message;
    return messages::text::did_you_mean(message, quoted(nearest));
}

/// The names that may have been meant, as they would be written.
void Suggestions::make(List& list, Meant meant) {
    list.is_made = true;
    if (meant == Meant::step) {
        for (const DraftNode& node : draft_.nodes) list.names.push_back(draft_.text(node.name));
    }
    if (meant == Meant::graph || meant == Meant::expansion) {
        for (const DraftBlock& block : draft_.blocks) {
            if (block.is_expansion == (meant == Meant::expansion)) {
                list.names.push_back(draft_.text(block.name));
            }
        }
    }
    if (meant == Meant::variable || meant == Meant::written || meant == Meant::counter) {
        for (const DraftDeclaration& declaration : draft_.declarations) {
            const bool is_counter = declaration.kind == VariableKind::counter;
            const bool fits = meant == Meant::variable  ? !is_counter
                              : meant == Meant::counter ? is_counter
                                                        : declaration.kind != VariableKind::input;
            if (fits) list.names.push_back(draft_.text(declaration.name));
        }
    }
    if (meant != Meant::variable) return;
    list.names.insert(list.names.end(), more_.begin(), more_.end());
    step_variables_.reserve(draft_.nodes.size() + draft_.blocks.size());
    for (const DraftNode& node : draft_.nodes) {
        step_variables_.push_back(fmt::format("X{}", draft_.text(node.name)));
    }
    for (const DraftBlock& block : draft_.blocks) {
        if (!block.is_expansion) {
            step_variables_.push_back(fmt::format("X{}", draft_.text(block.name)));
        }
    }
    list.names.insert(list.names.end(), step_variables_.begin(), step_variables_.end());
}

}  // namespace grafwire
