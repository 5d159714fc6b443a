// What the grammar of the text language does not let through, and other readers might: names that
// cannot be written, numbers and durations out of bounds, parts that are missing. It is looked at
// only where nothing else has been reported, because a reader leaves out what it has refused.
//
// The depth of expressions is bounded since everything that walks one recurses. It is measured in
// the levels in which the text language writes an expression: a negation, an edge and a time
// condition are one each, and so is a pair of parentheses.

#include <algorithm>

#include "grafcet/checking.h"
#include "grafcet/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

bool is_chain(ExprKind kind) {
    return kind == ExprKind::disjunction || kind == ExprKind::exclusive_or ||
           kind == ExprKind::conjunction;
}

/// From the weakest to the strongest.
int strength_of(ExprKind chain) {
    return chain == ExprKind::disjunction ? 0 : chain == ExprKind::exclusive_or ? 1 : 2;
}

/// The levels that an operand takes below its operator.
std::uint32_t levels_below(ExprKind kind, ExprKind operand, std::uint32_t levels) {
    if (is_chain(kind)) {
        const bool has_parentheses = is_chain(operand) && strength_of(operand) <= strength_of(kind);
        return levels + (has_parentheses ? 1 : 0);
    }
    const bool is_edge = kind == ExprKind::rise || kind == ExprKind::fall;  // rise(a + b)
    return levels + 1 + (is_chain(operand) && !is_edge ? 1 : 0);
}

class PartsCheck {
  public:
    explicit PartsCheck(const Checking& checking) : checking_(checking), draft_(checking.draft) {}

    void check() {
        check_names();
        check_steps();
        check_actions();
        for (const DraftAssumption& assumption : draft_.assumptions) {
            check_expression(assumption.expression, assumption.where,
                             say::assumption_without_condition);
        }
        for (const DraftTransition& transition : draft_.transitions) {
            check_expression(transition.condition, transition.where,
                             say::transition_without_condition);
            for (const std::uint32_t i : transition.writes) check_write(draft_.writes[i]);
        }
        check_numbers();
    }

  private:
    void missing(Location where, Localized message) {
        checking_.error(code::unexpected_token, where, std::move(message));
    }

    void check_name(const Word& word, const Message<>& without_name) {
        const std::string_view name = draft_.text(word);
        if (name.empty()) missing(word.where, without_name());
        if (find_control(name) != name.npos) {
            checking_.error(code::unexpected_character, word.where, control_in_name_message(name));
        }
        if (name.find('"') != name.npos) {
            checking_.error(code::unexpected_character, word.where,
                            say::quotation_mark_in_name(quoted(name)));
        }
    }

    /// Every part has a name that the text language can write between quotation marks.
    void check_names() {
        if (draft_.has_name) check_name(draft_.name, say::grafcet_without_name);
        if (draft_.title.length != 0) check_name(draft_.title, say::title_without_name);
        for (const DraftDeclaration& declaration : draft_.declarations) {
            check_name(declaration.name, say::variable_without_name);
        }
        for (const DraftBlock& block : draft_.blocks) {
            check_name(block.name,
                       block.is_expansion ? say::expansion_without_name : say::graph_without_name);
        }
        for (const DraftNode& node : draft_.nodes) {
            check_name(node.name,
                       node.is_macro ? say::macro_step_without_name : say::step_without_name);
        }
        for (const DraftTransition& transition : draft_.transitions) {
            if (transition.labelled) check_name(transition.label, say::transition_without_name);
        }
    }

    void check_steps() {
        for (std::uint32_t i = 0; i < draft_.nodes.size(); ++i) {
            const DraftNode& node = draft_.nodes[i];
            if (node.is_macro && node.extra == none) {
                missing(node.name.where, say::no_expansion(checking_.shown_node(i)));
            }
            if (node.is_macro || node.extra == none) continue;
            const DraftEnclosure& enclosure = draft_.enclosures[node.extra];
            if (enclosure.links.empty()) {
                missing(enclosure.graph.where,
                        say::encloses_without_links(checking_.shown_node(i),
                                                    checking_.shown(enclosure.graph)));
            }
            if (node.role != StepRole::ordinary) {
                checking_.error(code::expansion_entry_exit, enclosure.graph.where,
                                say::enclosing_end(checking_.shown_node(i)));
            }
        }
    }

    void check_actions() {
        for (const DraftAction& action : draft_.actions) {
            if (action.kind == ActionKind::stored) {
                check_write(draft_.writes[action.write]);
                if (action.trigger == Trigger::event) {
                    check_expression(action.expression, action.where, say::event_without_condition);
                }
            } else if (!action.expression.empty()) {
                check_depth(action.expression);
            }
        }
    }

    /// An assignment without a sum has an expression.
    void check_write(const DraftWrite& write) {
        if (write.operation != WriteOperation::assign || !write.sum.empty()) return;
        check_expression(write.value, write.where, say::assignment_without_condition);
    }

    void check_expression(const DraftExpression& expression, Location where,
                          const Message<>& without_condition) {
        if (expression.empty()) {
            missing(where, without_condition());
        } else {
            check_depth(expression);
        }
    }

    /// From the operands up, as the nodes stand; a few nodes cannot be too deep.
    void check_depth(const DraftExpression& expression) {
        if (expression.count <= deepest_nesting && draft_.definitions.empty()) return;
        std::vector<std::pair<ExprKind, std::uint32_t>> stack;
        for (const std::uint32_t i : expression) {
            const ExpressionNode& node = draft_.expression_nodes[i];
            std::uint32_t levels =
                node.definition == none ? 1 : draft_.definitions[node.definition].levels + 1;
            for (std::uint32_t left = operand_count(node); left > 0; --left) {
                const auto [kind, below] = stack.back();
                stack.pop_back();
                levels = std::max(levels, levels_below(node.kind, kind, below));
            }
            stack.emplace_back(node.kind, levels);
        }
        if (stack.back().second <= deepest_nesting) return;
        checking_.error(code::nested_too_deep, draft_.expression_nodes[expression.first].word.where,
                        nested_too_deep_message());
    }

    /// Numbers, durations and the lengths of sums, wherever they stand.
    void check_numbers() {
        for (const DraftTerm& term : draft_.terms) {
            if (term.value <= largest_number) continue;
            checking_.error(code::number_too_large, term.word.where,
                            number_too_large_message(term.value));
        }
        for (const ExpressionNode& node : draft_.expression_nodes) {
            if (node.kind == ExprKind::time_condition) {
                const DraftTime& time = draft_.times[node.value];
                const auto is_duration = [](Time t) { return t >= 0 && t < never; };
                if (is_duration(time.on_delay) && is_duration(time.off_delay)) continue;
                checking_.error(code::duration_out_of_range, node.word.where, say::bad_delay());
            } else if (node.kind == ExprKind::comparison) {
                const DraftComparison& comparison = draft_.comparisons[node.value];
                for (const Range<>& sum : {comparison.left, comparison.right}) {
                    if (sum.empty()) missing(node.word.where, say::side_of_comparison_empty());
                    check_length(sum, node.word.where);
                }
            }
        }
        for (const DraftWrite& write : draft_.writes) check_length(write.sum, write.where);
    }

    void check_length(Range<> sum, Location where) {
        if (sum.count <= longest_sum) return;
        checking_.error(code::nested_too_deep, where, sum_too_long_message());
    }

    const Checking& checking_;
    const Draft& draft_;
};

}  // namespace

Localized nested_too_deep_message() {
    return say::nested_too_deep(deepest_nesting);
}

Localized number_too_large_message(std::int64_t number) {
    return say::number_too_large(number, largest_number);
}

Localized sum_too_long_message() {
    return say::sum_too_long(longest_sum);
}

void check_parts(const Checking& checking) {
    PartsCheck(checking).check();
}

}  // namespace grafwire
