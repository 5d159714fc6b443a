// The names in expressions, in lists of steps and in transitions. An expression is a flat list, so
// each of its nodes is looked at on its own, without recursion; what may stand in it depends on
// where it is used: a transition condition reads everything, the condition of a continuous action
// no edge (it would last one scan only), an assumption the inputs alone.

#include <algorithm>
#include <utility>

#include "grafcet/checking.h"
#include "grafcet/messages.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// The variable of a step, macro-step or graph: `X` and its name.
bool resolve_step_variable(const Checking& checking, std::string_view name, ExpressionNode& node) {
    if (name.size() < 2 || name[0] != 'X') return false;
    if (const auto* found = checking.names.nodes.find(name.substr(1))) {
        const bool is_macro = checking.draft.nodes[*found].is_macro;
        node.variable = is_macro ? VariableKind::macro : VariableKind::step;
        node.value = *found;
        return true;
    }
    if (const auto* found = checking.names.graphs.find(name.substr(1))) {
        node.variable = VariableKind::graph;
        node.value = *found;
        return true;
    }
    return false;
}

/// `5` where `X5` is meant is a mistake of its own; else the nearest name is suggested.
void report_unknown(const Checking& checking, const Word& word) {
    const std::string_view name = checking.draft.text(word);
    const Localized shown = checking.shown(word);
    Localized message;
    if (const auto* node = checking.names.nodes.find(name)) {
        message = say::unknown_variable_of(shown, checking.shown_node(*node), name);
    } else if (const auto* graph = checking.names.graphs.find(name)) {
        message = say::unknown_variable_of(shown, checking.shown_block(*graph), name);
    } else {
        message =
            checking.suggestions.with_nearest(say::unknown_variable(shown), name, Meant::variable);
    }
    checking.error(code::unknown_name, word.where, std::move(message));
}

/// A name that stands for a condition, which must suit the place of the name.
void resolve_definition(const Checking& checking, ExpressionNode& node, std::uint32_t definition,
                        ExpressionUse use) {
    DraftDefinition& read = checking.draft.definitions[definition];
    node.definition = definition;
    read.is_read = true;
    if (use == ExpressionUse::assumption && !read.is_of_plant) {
        checking
            .error(code::not_a_plant_condition, node.word.where,
                   say::no_plant_condition_behind_name(checking.shown(node.word)))
            .notes.push_back({read.name.where, say::stands_for_this()});
    } else if (use == ExpressionUse::condition && read.has_edge && !node.inside_time) {
        checking
            .error(code::edge_in_condition, node.word.where,
                   say::edge_behind_name(checking.shown(node.word)))
            .notes.push_back({read.name.where, say::stands_for_this()});
    }
}

/// The duration that a name in a time condition stands for.
std::uint32_t resolve_duration(const Checking& checking, const Word& name, Time& time) {
    if (name.length == 0) return none;
    const auto* found = checking.names.variables.find(checking.draft.text(name));
    if (found == nullptr) {
        checking.error(code::unknown_name, name.where, say::unknown_duration(checking.shown(name)));
    } else if (found->duration == none) {
        checking.error(code::not_a_duration, name.where, say::not_a_duration(checking.shown(name)));
    } else {
        DraftDuration& duration = checking.draft.durations[found->duration];
        duration.is_read = true;
        time = duration.time;
        return found->duration;
    }
    return none;
}

void resolve_times(const Checking& checking, DraftTime& time) {
    time.on_duration = resolve_duration(checking, time.on_name, time.on_delay);
    time.off_duration = resolve_duration(checking, time.off_name, time.off_delay);
}

/// Declared variables come before those of steps, with which they cannot clash.
void resolve_variable(const Checking& checking, ExpressionNode& node, ExpressionUse use) {
    const std::string_view name = checking.draft.text(node.word);
    if (const auto* found = checking.names.variables.find(name)) {
        if (found->definition != none) {
            return resolve_definition(checking, node, found->definition, use);
        }
        if (found->duration != none) {
            checking.error(code::not_a_boolean, node.word.where,
                           say::duration_read(checking.shown(node.word), name));
            return;
        }
        node.variable = found->variable.kind;
        node.value = found->variable.index;
    } else if (!resolve_step_variable(checking, name, node)) {
        report_unknown(checking, node.word);
        return;
    }
    const bool is_of_plant =
        node.variable == VariableKind::input || node.variable == VariableKind::control;
    if (use == ExpressionUse::assumption && !is_of_plant) {
        checking.error(code::not_a_plant_condition, node.word.where,
                       say::no_input_in_assumption(checking.shown(node.word)));
    } else if (node.variable == VariableKind::counter) {
        checking.error(code::not_a_boolean, node.word.where,
                       say::counter_as_condition(checking.shown(node.word), name));
    }
}

/// Within a time condition an edge is allowed everywhere: the time holds what it starts.
void check_edge(const Checking& checking, const ExpressionNode& node, ExpressionUse use) {
    if (use == ExpressionUse::assumption) {
        checking.error(code::not_a_plant_condition, node.word.where, say::edge_in_assumption());
    } else if (use == ExpressionUse::condition && !node.inside_time) {
        checking.error(code::edge_in_condition, node.word.where, say::edge_in_condition());
    }
}

/// What a node reads, and whether it may stand there.
void resolve_node(const Checking& checking, ExpressionNode& node, ExpressionUse use) {
    switch (node.kind) {
        case ExprKind::variable:
            resolve_variable(checking, node, use);
            break;
        case ExprKind::rise:
        case ExprKind::fall:
            check_edge(checking, node, use);
            break;
        case ExprKind::time_condition:
            resolve_times(checking, checking.draft.times[node.value]);
            if (use == ExpressionUse::assumption) {
                checking.error(code::not_a_plant_condition, node.word.where,
                               say::time_in_assumption());
            }
            break;
        case ExprKind::comparison: {
            const DraftComparison& comparison = checking.draft.comparisons[node.value];
            if (use == ExpressionUse::assumption) {
                checking.error(code::not_a_plant_condition, node.word.where,
                               say::comparison_in_assumption());
                break;
            }
            resolve_sum(checking, comparison.left);
            resolve_sum(checking, comparison.right);
            break;
        }
        default:
            break;
    }
}

/// The steps before or after a transition are those of its own block.
void resolve_side(const Checking& checking, std::uint32_t block, Range<> list) {
    resolve_steps(checking, list, [&](std::uint32_t node, const Word& word) {
        const DraftNode& step = checking.draft.nodes[node];
        if (step.block == block) return true;
        const auto& later = checking.names.later_nodes;
        if (!later.empty() && later.count({block, checking.draft.text(word)}) != 0) return true;
        const bool is_expansion = checking.draft.blocks[block].is_expansion;
        const auto& message =
            is_expansion ? say::step_of_another_expansion : say::step_of_another_graph;
        checking
            .error(code::step_of_another_graph, word.where,
                   message(checking.shown_node(node), checking.shown_block(step.block),
                           checking.shown_block(block)))
            .notes.push_back({step.name.where, say::declared_here(checking.shown_node(node))});
        return false;
    });
}

}  // namespace

void resolve_expression(const Checking& checking, const DraftExpression& expression,
                        ExpressionUse use) {
    for (const std::uint32_t i : expression) {
        resolve_node(checking, checking.draft.expression_nodes[i], use);
    }
}

void resolve_sum(const Checking& checking, Range<> sum) {
    Draft& draft = checking.draft;
    for (const std::uint32_t i : sum) {
        DraftTerm& term = draft.terms[i];
        if (!term.is_name) continue;
        const std::string_view name = draft.text(term.word);
        ExpressionNode other;
        const auto* found = checking.names.variables.find(name);
        if (found != nullptr && found->variable.kind == VariableKind::counter) {
            term.counter = found->variable.index;
        } else if (found != nullptr || resolve_step_variable(checking, name, other)) {
            checking.error(code::not_a_counter, term.word.where,
                           say::not_a_counter(checking.shown(term.word)));
        } else {
            checking.error(
                code::unknown_name, term.word.where,
                checking.suggestions.with_nearest(say::unknown_counter(checking.shown(term.word)),
                                                  name, Meant::counter));
        }
    }
}

void report_repeated_steps(const Checking& checking, Range<> list) {
    if (list.count < 2) return;
    const Draft& draft = checking.draft;
    std::vector<std::uint32_t> places;
    for (const std::uint32_t i : list) {
        if (draft.word_nodes[i] != none) places.push_back(i);
    }
    std::sort(places.begin(), places.end(), [&draft](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t node_a = draft.word_nodes[a];
        const std::uint32_t node_b = draft.word_nodes[b];
        return node_a != node_b ? node_a < node_b : a < b;
    });
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (draft.word_nodes[places[i - 1]] != draft.word_nodes[places[i]]) continue;
        checking
            .error(code::duplicate_name, draft.words[places[i]].where,
                   say::named_twice(checking.shown_node(draft.word_nodes[places[i]])))
            .notes.push_back({draft.words[places[i - 1]].where, say::named_here_too()});
    }
}

void resolve_transitions(const Checking& checking) {
    const Draft& draft = checking.draft;
    for (std::uint32_t block = 0; block < draft.blocks.size(); ++block) {
        for (const std::uint32_t i : draft.transitions_of_block.of(block)) {
            const DraftTransition& transition = draft.transitions[i];
            resolve_side(checking, block, transition.preceding);
            resolve_side(checking, block, transition.following);
            if (transition.preceding.count == 0 && transition.following.count == 0) {
                checking.error(code::transition_without_step, transition.where,
                               say::transition_without_step());
            }
            resolve_expression(checking, transition.condition, ExpressionUse::transition);
        }
    }
}

}  // namespace grafwire
