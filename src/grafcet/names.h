#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grafcet/name_table.h"
#include "grafcet/syntax.h"
#include "text/diagnostics.h"

namespace grafwire {

/// What a file declares, by name. Of a name used twice the first use counts.
struct Names {
    struct Declared {
        Variable variable;
        std::uint32_t declaration = none;  ///< place in Syntax::declarations; none: a control input
    };
    NameTable<Declared> variables;
    NameTable<std::uint32_t> nodes;       ///< of Syntax::nodes
    NameTable<std::uint32_t> graphs;      ///< of Syntax::blocks
    NameTable<std::uint32_t> expansions;  ///< of Syntax::blocks
};

/// What an unknown name may have been meant to be.
enum class Meant : std::uint8_t { variable, written, counter, step, graph, expansion };

/// Finds the nearest declared name for messages. Its lists are made when first asked for; after a
/// fixed amount of work it suggests nothing more, so that a file full of mistakes is still read in
/// time proportional to its size.
class Suggestions {
  public:
    /// `more` are variables that the file does not declare.
    explicit Suggestions(const Syntax& syntax,
                         std::vector<std::string_view> more = {"Init", "AUdur", "AUdoux"})
        : syntax_(syntax), more_(std::move(more)) {}
    /// `; did you mean 'x'?`, or nothing.
    std::string did_you_mean(std::string_view name, Meant meant);

  private:
    struct List {
        bool is_made = false;
        std::vector<std::string_view> names;
    };
    void make(List& list, Meant meant);

    const Syntax& syntax_;
    std::vector<std::string_view> more_;
    List lists_[6];
    std::vector<std::string> step_variables_;
    std::size_t work_done_ = 0;
};

/// What the checks share.
struct Checking {
    Syntax& syntax;
    Names& names;
    Suggestions& suggestions;
    Diagnostics& diagnostics;

    std::string shown(const Word& word) const;
    Diagnostic& error(Code code, Location where, std::string message) const {
        return diagnostics.error(code, where, std::move(message));
    }
    /// "graph 'G1'", "expansion 'cycle'"
    std::string shown_block(std::uint32_t block) const;
    /// "step '5'", "macro-step 'M2'"
    std::string shown_node(std::uint32_t node) const;
};

// Each fills in what it resolves and reports what it finds wrong.

/// Fills the tables of names; looks for names used twice and variables of one name.
void collect_names(const Checking& checking);
/// Joins macro-steps and expansions; finds the graph of every block.
void resolve_expansions(const Checking& checking);
void resolve_transitions(const Checking& checking);
/// Actions, orders, enclosures and the expressions in them.
void resolve_actions(const Checking& checking);
void check_enclosures(const Checking& checking);
void check_circles(const Checking& checking);

enum class ExpressionUse : std::uint8_t { receptivity, condition, event, value, assumption };
void resolve_expression(const Checking& checking, const ExpressionSyntax& expression,
                        ExpressionUse use);
void resolve_sum(const Checking& checking, Range<> sum);

/// Names each of a list of steps; those that are none are reported, as are those named twice.
/// `accept` may report a step that does not belong in the list.
template <typename Accept>
void resolve_steps(const Checking& checking, Range<> list, const Accept& accept);
void report_repeated_steps(const Checking& checking, Range<> list);

/// The model of a file without errors.
Grafcet build_model(const Syntax& syntax);
/// The expression in a model whose steps and so on have the numbers given by `node_ids`.
ExprId build_expression(const Syntax& syntax, const ExpressionSyntax& expression,
                        const std::vector<std::uint32_t>& node_ids,
                        const std::vector<std::uint32_t>& graph_ids, Expressions& expressions);

template <typename Accept>
void resolve_steps(const Checking& checking, Range<> list, const Accept& accept) {
    Syntax& syntax = checking.syntax;
    for (std::uint32_t i = list.first; i < list.first + list.count; ++i) {
        const std::string_view name = syntax.text(syntax.words[i]);
        const std::uint32_t* node = checking.names.nodes.find(name);
        if (node == nullptr) {
            checking.error(Code::unknown_name, syntax.words[i].where,
                           "unknown step " + checking.shown(syntax.words[i]) +
                               checking.suggestions.did_you_mean(name, Meant::step));
        } else if (accept(*node, syntax.words[i])) {
            syntax.word_nodes[i] = *node;
        }
    }
    report_repeated_steps(checking, list);
}

}  // namespace grafwire
