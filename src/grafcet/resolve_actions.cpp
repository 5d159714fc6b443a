// The names in actions, forcing orders and enclosures, and how outputs are driven. An output is
// driven by continuous actions or by stored ones: the first action of each kind is remembered while
// names are looked up, and afterwards an output with both is refused, and so is the reading of an
// output that has no memory (IEC 60848 gives a continuous output no value of its own).

#include <optional>
#include <string>

#include "grafcet/checking.h"
#include "grafcet/messages.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// How an output is driven: the first action of each kind.
struct Drive {
    std::optional<Location> continuous;
    std::optional<Location> stored;
};

/// Looks up what actions are about, step by step, then what clearing actions write.
class ActionResolver {
  public:
    explicit ActionResolver(const Checking& checking)
        : checking_(checking), draft_(checking.draft) {
        std::size_t outputs = 0;
        for (const DraftDeclaration& declaration : draft_.declarations) {
            outputs += declaration.kind == VariableKind::output ? 1U : 0U;
        }
        drives_.resize(outputs);
    }

    void resolve() {
        for (std::uint32_t i = 0; i < draft_.nodes.size(); ++i) {
            const DraftNode& node = draft_.nodes[i];
            if (!node.is_macro && node.extra != none) {
                resolve_enclosure(draft_.enclosures[node.extra]);
            }
            for (const std::uint32_t action : draft_.actions_of_node.of(i)) {
                resolve_action(draft_.actions[action]);
            }
        }
        for (const DraftTransition& transition : draft_.transitions) {
            for (const std::uint32_t i : transition.writes) resolve_write(draft_.writes[i]);
        }
        check_drives();
        check_output_reads();
    }

  private:
    void resolve_action(DraftAction& action) {
        switch (action.kind) {
            case ActionKind::continuous:
            case ActionKind::held:
                resolve_continuous(action);
                break;
            case ActionKind::order:
                resolve_order(action);
                break;
            case ActionKind::stored:
                resolve_write(draft_.writes[action.write]);
                if (action.trigger == Trigger::event) {
                    resolve_expression(checking_, action.expression, ExpressionUse::event);
                }
                break;
        }
    }

    /// The target is an output, or a var, which is held then. A counter has a memory, which a
    /// continuous action has not.
    void resolve_continuous(DraftAction& action) {
        const auto* found = checking_.names.variables.find(draft_.text(action.name));
        if (found != nullptr && found->definition != none &&
            draft_.definitions[found->definition].is_held) {
            action.held = found->definition;
            action.resolved = found->variable.index;
        } else if (found != nullptr && (found->definition != none || found->duration != none)) {
            report_fixed_target(action.name);
        } else if (found != nullptr && found->variable.kind == VariableKind::output) {
            action.resolved = found->variable.index;
            std::optional<Location>& first = drives_[action.resolved].continuous;
            if (!first) first = action.where;
        } else if (found != nullptr && found->variable.kind == VariableKind::counter) {
            checking_.error(
                code::continuous_on_internal, action.where,
                say::continuous_on_counter(checking_.shown(action.name), draft_.text(action.name)));
        } else {
            report_bad_target(action.name);
        }
        if (!action.expression.empty()) {
            resolve_expression(checking_, action.expression, ExpressionUse::condition);
        }
    }

    /// The name of a condition or of a duration.
    void report_fixed_target(const Word& word) {
        checking_.error(code::assignment_to_input, word.where,
                        say::definition_written(checking_.shown(word)));
    }

    /// A stored action on a var that continuous actions hold.
    void report_held_target(const DraftWrite& write, const DraftDefinition& held) {
        checking_
            .error(code::held_and_stored, write.target.where,
                   say::var_held_and_stored(checking_.shown(write.target)))
            .notes.push_back(
                {draft_.actions[held.actions.front()].where, say::continuous_drives_here()});
    }

    /// A name that no action of any kind can be about.
    void report_bad_target(const Word& word) {
        const std::string_view name = draft_.text(word);
        const auto* found = checking_.names.variables.find(name);
        const bool is_step_variable = found == nullptr && name.size() > 1 && name[0] == 'X' &&
                                      (checking_.names.nodes.find(name.substr(1)) != nullptr ||
                                       checking_.names.graphs.find(name.substr(1)) != nullptr);
        if (found != nullptr) {
            const bool is_input = found->variable.kind == VariableKind::input;
            const auto& message = is_input ? say::input_written : say::control_input_written;
            checking_.error(code::assignment_to_input, word.where, message(checking_.shown(word)));
        } else if (is_step_variable) {
            checking_.error(code::assignment_to_input, word.where,
                            say::step_variable_written(checking_.shown(word)));
        } else {
            const Localized shown = checking_.shown(word);
            checking_.error(code::unknown_name, word.where,
                            checking_.names.graphs.find(name) != nullptr
                                ? say::unknown_output_is_graph(shown, name)
                                : checking_.suggestions.with_nearest(say::unknown_output(shown),
                                                                     name, Meant::written));
        }
    }

    /// The target is an output, a var or a counter; what is assigned fits its kind.
    void resolve_write(DraftWrite& write) {
        const auto* found = checking_.names.variables.find(draft_.text(write.target));
        const bool is_writable = found != nullptr && found->variable.kind != VariableKind::input &&
                                 found->variable.kind != VariableKind::control &&
                                 found->definition == none && found->duration == none;
        if (found != nullptr && found->definition != none &&
            draft_.definitions[found->definition].is_held) {
            report_held_target(write, draft_.definitions[found->definition]);
        } else if (found != nullptr && (found->definition != none || found->duration != none)) {
            report_fixed_target(write.target);
        } else if (!is_writable) {
            report_bad_target(write.target);
        } else {
            write.resolved = found->variable;
            const bool is_counter = write.resolved.kind == VariableKind::counter;
            if (write.resolved.kind == VariableKind::output) {
                std::optional<Location>& first = drives_[write.resolved.index].stored;
                if (!first) first = write.where;
            }
            if (is_counter && write.operation != WriteOperation::assign) {
                checking_.error(
                    code::not_a_boolean, write.target.where,
                    say::counter_set(checking_.shown(write.target), draft_.text(write.target)));
            }
        }
        if (write.operation != WriteOperation::assign) return;
        if (is_writable) check_kind_of_value(write);
        resolve_sum(checking_, write.sum);
        resolve_expression(checking_, write.value, ExpressionUse::value);
    }

    /// The text language reads a value as the kind its target asks for; other readers may not.
    void check_kind_of_value(const DraftWrite& write) {
        const bool is_counter = write.resolved.kind == VariableKind::counter;
        if (is_counter && !write.value.empty()) {
            checking_.error(code::not_a_counter, write.target.where,
                            say::value_of_counter(checking_.shown(write.target)));
        } else if (!is_counter && !write.sum.empty()) {
            checking_.error(code::not_a_boolean, write.target.where,
                            say::value_of_boolean(checking_.shown(write.target)));
        }
    }

    /// An unknown graph does not keep the steps listed from being looked up: they may be wrong as
    /// well.
    void resolve_order(DraftAction& action) {
        if (const auto* graph = find_graph(action.name, code::forcing_unknown_graph)) {
            action.resolved = *graph;
            resolve_listed(*graph, action.steps, say::macro_step_in_order);
        } else {
            resolve_listed(none, action.steps, say::macro_step_in_order);
        }
    }

    void resolve_enclosure(DraftEnclosure& enclosure) {
        if (const auto* graph = find_graph(enclosure.graph, code::unknown_name)) {
            enclosure.resolved = *graph;
        }
        resolve_listed(enclosure.resolved, enclosure.links, say::macro_step_in_link);
    }

    const std::uint32_t* find_graph(const Word& word, Code code) {
        const std::string_view name = draft_.text(word);
        const auto* graph = checking_.names.graphs.find(name);
        if (graph != nullptr) return graph;
        const bool is_expansion = checking_.names.expansions.find(name) != nullptr;
        checking_.error(code, word.where,
                        is_expansion
                            ? say::expansion_as_graph(checking_.shown(word))
                            : checking_.suggestions.with_nearest(
                                  say::unknown_graph(checking_.shown(word)), name, Meant::graph));
        return nullptr;
    }

    /// Steps of one graph, those of its expansions included; `graph` is none if it is not known.
    void resolve_listed(std::uint32_t graph, Range<> list, const Message<Localized>& on_macro) {
        resolve_steps(checking_, list, [&](std::uint32_t node, const Word& word) {
            const DraftNode& step = draft_.nodes[node];
            const std::uint32_t root = draft_.blocks[step.block].root;
            if (step.is_macro) {
                checking_.error(code::macro_not_allowed_here, word.where,
                                on_macro(checking_.shown(word)));
                return false;
            }
            if (graph == none || root == none || root == graph) return true;
            checking_
                .error(code::forcing_foreign_step, word.where,
                       say::foreign_step(checking_.shown_node(node), checking_.shown_block(root),
                                         checking_.shown_block(graph),
                                         checking_.shown(draft_.blocks[graph].name)))
                .notes.push_back({step.name.where, say::declared_here(checking_.shown_node(node))});
            return false;
        });
    }

    /// The later of the two ways in which an output is driven is the one too many.
    void check_drives() {
        for (const DraftDeclaration& declaration : draft_.declarations) {
            const Drive* drive = drive_of(declaration);
            if (drive == nullptr || !drive->continuous || !drive->stored) continue;
            const bool stored_is_later = is_before(*drive->continuous, *drive->stored);
            checking_
                .error(code::output_driven_twice,
                       stored_is_later ? *drive->stored : *drive->continuous,
                       say::output_driven_twice(checking_.shown(declaration.name)))
                .notes.push_back(
                    {stored_is_later ? *drive->continuous : *drive->stored,
                     stored_is_later ? say::continuous_drives_here() : say::stored_drives_here()});
        }
    }

    /// The name as a declaration spells it.
    std::string written_name(const Word& word) const {
        std::string text;
        append_variable_name(text, draft_.text(word));
        return text;
    }

    /// Null for what is no output, and for a second declaration of the same name.
    const Drive* drive_of(const DraftDeclaration& declaration) const {
        if (declaration.kind != VariableKind::output) return nullptr;
        const auto* found = checking_.names.variables.find(draft_.text(declaration.name));
        if (found->declaration == none ||
            &draft_.declarations[found->declaration] != &declaration) {
            return nullptr;
        }
        return &drives_[found->variable.index];
    }

    /// An expression may read stored outputs only.
    void check_output_reads() {
        for (const ExpressionNode& node : draft_.expression_nodes) {
            if (node.kind != ExprKind::variable || node.variable != VariableKind::output) continue;
            const Drive& drive = drives_[node.value];
            if (drive.stored) continue;
            if (!drive.continuous) {
                checking_.error(code::reads_continuous_output, node.word.where,
                                say::undriven_output_read(checking_.shown(node.word)));
                continue;
            }
            checking_
                .error(code::reads_continuous_output, node.word.where,
                       say::continuous_output_read(checking_.shown(node.word),
                                                   written_name(node.word)))
                .notes.push_back({*drive.continuous, say::this_continuous_action()});
        }
    }

    const Checking& checking_;
    Draft& draft_;
    std::vector<Drive> drives_;
};

}  // namespace

void resolve_actions(const Checking& checking) {
    ActionResolver(checking).resolve();
}

}  // namespace grafwire
