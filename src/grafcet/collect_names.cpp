// The names of a chart, and what is said about them. Of a name used twice the first use counts, so
// that everything else can still be looked up and all errors are reported at once.
//
// An unknown name is answered with the nearest declared one. Finding it costs a comparison with
// every name, so the work is counted: after a fixed amount nothing more is suggested, and a chart
// full of mistakes is still read in time proportional to its size.

#include <fmt/format.h>

#include <map>
#include <utility>

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

/// The continuous actions by the names that they are on.
class ContinuousActions {
  public:
    explicit ContinuousActions(const Draft& draft) {
        for (std::uint32_t i = 0; i < draft.actions.size(); ++i) {
            const DraftAction& action = draft.actions[i];
            if (action.kind != ActionKind::continuous) continue;
            const auto [place, is_new] = places_.add(draft.text(action.name), size_of(of_name_));
            if (is_new) of_name_.emplace_back();
            of_name_[place].push_back(i);
        }
    }
    /// Null where there is none.
    const std::vector<std::uint32_t>* on(std::string_view name) const {
        const std::uint32_t* place = places_.find(name);
        return place == nullptr ? nullptr : &of_name_[*place];
    }

  private:
    NameTable<std::uint32_t> places_;
    std::vector<std::vector<std::uint32_t>> of_name_;
};

/// A name that a variable has already.
void report_variable_twice(const Checking& checking, const Word& word,
                           const Names::Declared& first) {
    const Draft& draft = checking.draft;
    if (first.declaration != none) {
        report_twice(checking, say::variable_twice, word,
                     draft.declarations[first.declaration].name.where);
    } else if (first.definition != none) {
        report_twice(checking, say::variable_twice, word,
                     draft.definitions[first.definition].name.where);
    } else if (first.duration != none) {
        report_twice(checking, say::variable_twice, word,
                     draft.durations[first.duration].name.where);
    } else {
        checking.error(code::duplicate_name, word.where,
                       say::control_input_declared(checking.shown(word)));
    }
}

/// A var that steps hold: it stands for the OR of the actions on it.
void add_held(const Checking& checking, std::uint32_t declaration, std::uint32_t var,
              const std::vector<std::uint32_t>& actions) {
    Draft& draft = checking.draft;
    const Word& name = draft.declarations[declaration].name;
    const std::uint32_t index = size_of(draft.definitions);
    const auto [first, is_new] = checking.names.variables.add(
        draft.text(name), Names::Declared{{VariableKind::var, var}, declaration, index});
    if (!is_new) return report_variable_twice(checking, name, first);
    DraftDefinition definition;
    definition.name = name;
    definition.is_held = true;
    definition.actions = actions;
    draft.declarations[declaration].held = index;
    draft.definitions.push_back(std::move(definition));
}

/// Defined conditions and durations share one space of names with the variables.
void collect_definitions(const Checking& checking) {
    const Draft& draft = checking.draft;
    const auto add = [&checking, &draft](const Word& name, const Names::Declared& declared) {
        const auto [first, is_new] = checking.names.variables.add(draft.text(name), declared);
        if (!is_new) report_variable_twice(checking, name, first);
    };
    for (std::uint32_t i = 0; i < draft.definitions.size(); ++i) {
        if (!draft.definitions[i].is_held) add(draft.definitions[i].name, {{}, none, i});
    }
    for (std::uint32_t i = 0; i < draft.durations.size(); ++i) {
        add(draft.durations[i].name, {{}, none, none, i});
    }
}

/// Declared variables share one table with the control inputs, which nobody may declare.
void collect_variables(const Checking& checking) {
    Draft& draft = checking.draft;
    auto& variables = checking.names.variables;
    constexpr std::string_view controls[control_input_count] = {"Init", "AUdur", "AUdoux"};
    for (std::uint32_t i = 0; i < control_input_count; ++i) {
        variables.add(controls[i], Names::Declared{{VariableKind::control, i}, none});
    }
    std::uint32_t counts[5] = {};
    const auto count_of = [&counts](VariableKind kind) -> std::uint32_t& {
        return counts[static_cast<std::size_t>(kind)];
    };
    const ContinuousActions actions(draft);
    for (std::uint32_t i = 0; i < draft.declarations.size(); ++i) {
        DraftDeclaration& declaration = draft.declarations[i];
        if (declaration.kind == VariableKind::counter) check_counter(checking, declaration);
        const auto* held_by = declaration.kind == VariableKind::var
                                  ? actions.on(draft.text(declaration.name))
                                  : nullptr;
        if (held_by != nullptr) {
            add_held(checking, i, count_of(VariableKind::var)++, *held_by);
            continue;
        }
        std::uint32_t& count = count_of(declaration.kind);
        const auto [first, is_new] = variables.add(draft.text(declaration.name),
                                                   Names::Declared{{declaration.kind, count}, i});
        ++count;
        if (!is_new) report_variable_twice(checking, declaration.name, first);
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
/// Two blocks that number their steps alike make one message, however many steps they share.
class StepsTwice {
  public:
    explicit StepsTwice(const Checking& checking) : checking_(checking) {}

    void add(std::uint32_t node, std::uint32_t first) {
        const Draft& draft = checking_.draft;
        const std::uint32_t block = draft.nodes[node].block;
        const std::uint32_t other = draft.nodes[first].block;
        if (block == other) {
            report_twice(checking_, say::step_twice, draft.nodes[node].name,
                         draft.nodes[first].name.where);
            return;
        }
        of_blocks_[{block, other}].push_back({node, first});
    }

    void report() const {
        const Draft& draft = checking_.draft;
        for (const auto& [blocks, steps] : of_blocks_) {
            const auto& [node, first] = steps.front();
            if (steps.size() == 1) {
                report_twice(checking_, say::step_twice, draft.nodes[node].name,
                             draft.nodes[first].name.where);
                continue;
            }
            checking_
                .error(
                    code::duplicate_name, draft.nodes[node].name.where,
                    say::steps_of_two_graphs(checking_.shown_block(blocks.first),
                                             checking_.shown_block(blocks.second), names_of(steps)))
                .notes.push_back({draft.nodes[first].name.where, say::first_declared_here()});
        }
    }

  private:
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

    std::string names_of(const Pairs& steps) const {
        constexpr std::size_t most_shown = 5;
        std::string names;
        for (std::size_t i = 0; i < steps.size() && i < most_shown; ++i) {
            if (i != 0) names += ", ";
            names += checking_.draft.text(checking_.draft.nodes[steps[i].first].name);
        }
        return steps.size() > most_shown ? names + ", …" : names;
    }

    const Checking& checking_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Pairs> of_blocks_;
};

/// `X1` as a step: its variable is XX1, where X1 was most likely meant.
void warn_doubled_x(const Checking& checking, const Word& name) {
    const std::string_view text = checking.draft.text(name);
    if (text.size() < 2 || text[0] != 'X' || !is_integer(text.substr(1))) return;
    checking.diagnostics.warning(code::step_named_like_variable, name.where,
                                 say::step_named_like_variable(checking.shown(name), text));
}

void collect_nodes(const Checking& checking) {
    Draft& draft = checking.draft;
    auto& nodes = checking.names.nodes;
    nodes.reserve(draft.nodes.size());
    StepsTwice twice(checking);
    for (std::uint32_t i = 0; i < draft.nodes.size(); ++i) {
        const Word& name = draft.nodes[i].name;
        const auto [first, is_new] = nodes.add(draft.text(name), i);
        if (!is_new) {
            twice.add(i, first);
            checking.names.later_nodes[{draft.nodes[i].block, draft.text(name)}] = i;
        }
        warn_doubled_x(checking, name);
    }
    twice.report();
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
    collect_definitions(checking);
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
    constexpr std::size_t most_work = 20'000'000;
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
    for (const DraftDefinition& definition : draft_.definitions) {
        if (!definition.is_held) list.names.push_back(draft_.text(definition.name));
    }
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
