#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/grafcet.h"
#include "grafcet/grafcet_builder.h"
#include "text/source.h"

namespace grafwire {

// A chart as it has been told to GrafcetBuilder: names are pieces of one text, lists are ranges of
// a few large vectors. Fields marked `resolved` are filled by the checks of finish().

/// A name: a piece of Draft::names.
struct Word {
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    Location where;
};

/// One node of an expression. Expressions stand in postfix order: operands before their operator.
struct ExpressionNode {
    ExprKind kind = ExprKind::constant;
    VariableKind variable = VariableKind::input;  ///< resolved
    std::uint32_t definition = none;              ///< resolved: of Draft::definitions, if it is one
    bool inside_time = false;                     ///< within the operand of a time condition
    /// n-ary: number of operands; constant: its value; time condition, comparison: place in
    /// Draft::times, Draft::comparisons; variable, resolved: its index (a step or macro-step: of
    /// Draft::nodes; a graph: of Draft::blocks)
    std::uint32_t value = 0;
    Word word;  ///< variable: its name; else only the place
};

std::uint32_t operand_count(const ExpressionNode& node);

/// A range of Draft::expression_nodes; empty: not there.
using DraftExpression = Range<>;

/// A term of a sum: a counter by its name, or a number.
struct DraftTerm {
    bool negative = false;
    bool is_name = false;
    std::uint32_t counter = SumTerm::no_counter;  ///< resolved
    std::int64_t value = 0;
    Word word;
};

/// `[left relation right]`; the sides are ranges of Draft::terms.
struct DraftComparison {
    Range<> left;
    Range<> right;
    Relation relation = Relation::equal;
};

/// The durations of a time condition, or the names of such.
struct DraftTime {
    Time on_delay = 0;                  ///< resolved where it has a name
    Time off_delay = 0;                 ///< likewise
    Word on_name;                       ///< without a text: none
    Word off_name;                      ///< likewise
    std::uint32_t on_duration = none;   ///< resolved: of Draft::durations
    std::uint32_t off_duration = none;  ///< likewise
};

/// A name that stands for a condition: one that is defined, or a var that steps hold by continuous
/// actions.
struct DraftDefinition {
    Word name;
    DraftExpression expression;  ///< of a defined name
    bool is_held = false;
    std::vector<std::uint32_t> actions;  ///< those that hold it, of Draft::actions
    // Resolved, with what the names in it stand for:
    bool has_edge = false;     ///< outside of time conditions
    bool is_of_plant = true;   ///< reads inputs and control inputs alone, as they are
    std::uint32_t size = 0;    ///< how many parts it has when written out
    std::uint32_t levels = 0;  ///< how deep it is nested
    bool is_read = false;
};

struct DraftDuration {
    Word name;
    Time time = 0;
    bool is_read = false;
};

struct DraftAssumption {
    DraftExpression expression;
    Location where;
};

/// What an action writes.
struct DraftWrite {
    WriteOperation operation = WriteOperation::set;
    Word target;
    DraftExpression value;  ///< of an assignment, or:
    Range<> sum;            ///< of Draft::terms
    Location where;
    Variable resolved;
};

/// An action of a step; which fields count depends on its kind.
struct DraftAction {
    ActionKind kind = ActionKind::continuous;
    Trigger trigger = Trigger::activation;
    OrderKind order = OrderKind::empty;
    std::uint32_t node = 0;
    std::uint32_t write = 0;     ///< stored: place in Draft::writes
    Word name;                   ///< continuous: the output; order: the graph
    DraftExpression expression;  ///< after `if` or `on`
    Range<> steps;               ///< order: of Draft::words
    Location where;
    std::uint32_t resolved = none;  ///< output, var that it holds, or block of the graph
    std::uint32_t held = none;      ///< on a var: what that stands for, of Draft::definitions
};

/// What a step encloses.
struct DraftEnclosure {
    Word graph;
    Range<> links;                  ///< of Draft::words
    std::uint32_t resolved = none;  ///< block of the graph
};

/// A step or a macro-step.
struct DraftNode {
    bool is_macro = false;
    StepRole role = StepRole::ordinary;
    bool initial = false;
    std::uint32_t block = 0;
    std::uint32_t extra = none;  ///< step: place in Draft::enclosures; macro: in Draft::words
    Word name;
    std::uint32_t resolved = none;  ///< macro: its expansion, a block
};

/// A transition; its sides name steps and macro-steps of its block.
struct DraftTransition {
    bool labelled = false;
    std::uint32_t block = 0;
    Word label;
    Range<> preceding;  ///< of Draft::words
    Range<> following;  ///< of Draft::words
    DraftExpression condition;
    Range<> writes;
    Location where;
};

/// A graph or an expansion.
struct DraftBlock {
    bool is_expansion = false;
    Word name;
    // Resolved:
    std::uint32_t root = none;   ///< the block of the graph that it is, or belongs to
    std::uint32_t macro = none;  ///< expansion: the first macro-step that names it
    std::uint32_t entry = none;
    std::uint32_t exit = none;
};

/// A declared variable; low and high are those of a counter.
struct DraftDeclaration {
    VariableKind kind = VariableKind::input;  ///< input, output, var or counter
    Word name;
    std::int64_t low = 0;
    std::int64_t high = 0;
    std::uint32_t held = none;  ///< resolved, var that steps hold: of Draft::definitions
};

std::uint32_t size_of(const auto& items) {
    return static_cast<std::uint32_t>(items.size());
}

/// The items of each owner, in the order added.
class Members {
  public:
    /// `owner` is the field of an item that holds the number of its owner.
    template <typename Item>
    void collect(const std::vector<Item>& items, std::uint32_t Item::*owner, std::size_t owners) {
        begin_.assign(owners + 1, 0);
        for (const Item& item : items) ++begin_[item.*owner + 1];
        for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        members_.resize(items.size());
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        for (std::uint32_t i = 0; i < items.size(); ++i) members_[next[items[i].*owner]++] = i;
    }

    std::span<const std::uint32_t> of(std::uint32_t owner) const {
        return {members_.data() + begin_[owner], begin_[owner + 1] - begin_[owner]};
    }

  private:
    std::vector<std::uint32_t> begin_{0};
    std::vector<std::uint32_t> members_;
};

/// The whole chart.
struct Draft {
    std::string names;
    bool has_name = false;
    Word name;
    Word title;
    std::vector<DraftDeclaration> declarations;
    std::vector<DraftAssumption> assumptions;
    std::vector<DraftDefinition> definitions;  ///< those of the text, then the vars that are held
    std::vector<std::uint32_t> definitions_inwards;  ///< resolved: each behind those that it reads
    std::vector<DraftDuration> durations;
    std::vector<DraftBlock> blocks;
    std::vector<DraftNode> nodes;              ///< steps and macro-steps
    std::vector<DraftTransition> transitions;  ///< the place is the rank
    std::vector<DraftAction> actions;
    std::vector<DraftWrite> writes;
    std::vector<DraftEnclosure> enclosures;
    std::vector<Word> words;
    std::vector<ExpressionNode> expression_nodes;
    std::vector<DraftTime> times;
    std::vector<DraftComparison> comparisons;
    std::vector<DraftTerm> terms;

    // Made by arrange(), once everything has been added.
    Members nodes_of_block;
    Members transitions_of_block;
    Members actions_of_node;
    std::vector<std::uint32_t> word_nodes;  ///< resolved: the step each of `words` names, or none
    void arrange();

    std::string_view text(const Word& word) const {
        return std::string_view(names).substr(word.offset, word.length);
    }

    Word add(Name added);
    Range<> add(std::span<const Name> list);
    Range<> add(const NamedSum& sum);
    DraftExpression add(const NamedExpression& expression);
    DraftWrite add(const NamedWrite& write);
};

}  // namespace grafwire
