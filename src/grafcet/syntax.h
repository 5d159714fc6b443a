#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "grafcet/grafcet.h"
#include "text/location.h"

namespace grafwire {

// A `.grafcet` file as written: names are places in the source text, lists are ranges of a few
// large vectors. Fields marked `resolved` are left empty by the parser and filled by
// resolve_names().

/// A name: a piece of the source text, without quotation marks.
struct Word {
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    Location where;
};

/// One node of an expression. Expressions stand in postfix order: operands before their operator.
struct ExpressionNode {
    ExprKind kind = ExprKind::constant;
    VariableKind variable = VariableKind::input;  ///< resolved
    bool inside_time = false;                     ///< within the operand of a time condition
    /// n-ary: number of operands; constant: its value; time condition, comparison: place in
    /// Syntax::times, Syntax::comparisons; variable, resolved: its index (a step or macro-step: of
    /// Syntax::nodes; a graph: of Syntax::blocks)
    std::uint32_t value = 0;
    Word word;  ///< variable: its name; else only the place
};

/// A range of Syntax::expression_nodes; count 0: not there.
struct ExpressionSyntax {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    Location where;
    bool is_present() const { return count != 0; }
};

struct TimeSyntax {
    Time on_delay = 0;
    Time off_delay = 0;
};

struct TermSyntax {
    bool negative = false;
    bool is_name = false;
    std::uint32_t counter = SumTerm::no_counter;  ///< resolved
    std::int64_t value = 0;
    Word word;
};

struct ComparisonSyntax {
    Range<> left;
    Range<> right;
    Relation relation = Relation::equal;
};

struct WriteSyntax {
    WriteOperation operation = WriteOperation::set;
    bool is_sum = false;
    Word target;
    ExpressionSyntax value;  ///< of `:=`, unless is_sum
    Range<> sum;             ///< of `:=`, if is_sum
    Location where;
    Variable resolved;
};

struct ActionSyntax {
    ActionKind kind = ActionKind::continuous;
    Trigger trigger = Trigger::activation;
    OrderKind order = OrderKind::empty;
    std::uint32_t write = 0;      ///< stored: place in Syntax::writes
    Word name;                    ///< continuous: the output; order: the graph
    ExpressionSyntax expression;  ///< after `if` or `on`
    Range<> steps;                ///< order: of Syntax::words
    Location where;
    std::uint32_t resolved = none;  ///< output, or block of the graph
};

struct EnclosureSyntax {
    Word graph;
    Range<> links;                  ///< of Syntax::words
    std::uint32_t resolved = none;  ///< block of the graph
};

enum class NodeKind : std::uint8_t { step, entry, exit, macro };

struct NodeSyntax {
    NodeKind kind = NodeKind::step;
    bool initial = false;
    std::uint32_t block = 0;
    std::uint32_t extra = none;  ///< step: place in Syntax::enclosures; macro: in Syntax::words
    Word name;
    Range<> actions;
    std::uint32_t resolved = none;  ///< macro: its expansion, a block
};

struct TransitionSyntax {
    bool labelled = false;
    Word label;
    Range<> preceding;  ///< of Syntax::words
    Range<> following;  ///< of Syntax::words
    ExpressionSyntax condition;
    Range<> writes;
    Location where;
};

struct BlockSyntax {
    bool is_expansion = false;
    Word name;
    Range<> nodes;
    Range<> transitions;
    // Resolved:
    std::uint32_t root = none;   ///< the block of the graph that it is, or belongs to
    std::uint32_t macro = none;  ///< expansion: the first macro-step that names it
    std::uint32_t entry = none;
    std::uint32_t exit = none;
};

struct DeclarationSyntax {
    VariableKind kind = VariableKind::input;  ///< input, output, var or counter
    Word name;
    std::int64_t low = 0;
    std::int64_t high = 0;
};

struct Syntax {
    std::string_view source;
    bool has_name = false;
    Word name;
    Word title;
    std::vector<DeclarationSyntax> declarations;
    std::vector<ExpressionSyntax> assumptions;
    std::vector<BlockSyntax> blocks;
    std::vector<NodeSyntax> nodes;
    std::vector<TransitionSyntax> transitions;  ///< in the order of the file: the place is the rank
    std::vector<ActionSyntax> actions;
    std::vector<WriteSyntax> writes;
    std::vector<EnclosureSyntax> enclosures;
    std::vector<Word> words;
    std::vector<std::uint32_t> word_nodes;  ///< resolved: the step each of `words` names, or none
    std::vector<ExpressionNode> expression_nodes;
    std::vector<TimeSyntax> times;
    std::vector<ComparisonSyntax> comparisons;
    std::vector<TermSyntax> terms;

    std::string_view text(const Word& word) const {
        return source.substr(word.offset, word.length);
    }
};

}  // namespace grafwire
