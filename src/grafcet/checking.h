#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafcet/draft.h"
#include "grafcet/messages.h"
#include "grafcet/name_table.h"
#include "text/diagnostics.h"

namespace grafwire {

/// What a chart declares, by name. Of a name used twice the first use counts.
struct Names {
    struct Declared {
        Variable variable;
        std::uint32_t declaration = none;  ///< place in Draft::declarations; none: a control input
        std::uint32_t definition = none;   ///< of Draft::definitions: what it stands for
        std::uint32_t duration = none;     ///< of Draft::durations
    };
    NameTable<Declared> variables;
    NameTable<std::uint32_t> nodes;  ///< of Draft::nodes
    /// Steps of a name that is used before: by block and name, so that the transitions of that
    /// block are not said to leave it.
    std::map<std::pair<std::uint32_t, std::string_view>, std::uint32_t> later_nodes;
    NameTable<std::uint32_t> graphs;      ///< of Draft::blocks
    NameTable<std::uint32_t> expansions;  ///< of Draft::blocks
};

/// What an unknown name may have been meant to be.
enum class Meant : std::uint8_t { variable, written, counter, step, graph, expansion };

/// Finds the nearest declared name for messages. Its lists are made when first asked for; after a
/// fixed amount of work it suggests nothing more, so that a chart full of mistakes is still read in
/// time proportional to its size.
class Suggestions {
  public:
    /// `more` are variables that the chart does not declare.
    explicit Suggestions(const Draft& draft,
                         std::vector<std::string_view> more = {"Init", "AUdur", "AUdoux"})
        : draft_(draft), more_(std::move(more)) {}
    /// The message about an unknown name, with the nearest declared one behind it where there is
    /// one: `unknown step '22'; did you mean '2'?`
    Localized with_nearest(Localized message, std::string_view name, Meant meant);

  private:
    struct List {
        bool is_made = false;
        std::vector<std::string_view> names;
    };
    void make(List& list, Meant meant);

    const Draft& draft_;
    std::vector<std::string_view> more_;
    List lists_[6];
    std::vector<std::string> step_variables_;
    std::size_t work_done_ = 0;
};

inline bool is_before(Location a, Location b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
}

/// What the checks share.
struct Checking {
    Draft& draft;
    Names& names;
    Suggestions& suggestions;
    Diagnostics& diagnostics;

    /// A name in quotation marks.
    Localized shown(const Word& word) const;
    Diagnostic& error(Code code, Location where, Localized message) const {
        return diagnostics.error(code, where, std::move(message));
    }
    /// "graph 'G1'", "expansion 'cycle'"; in French with the article
    Localized shown_block(std::uint32_t block) const;
    /// "step '5'", "macro-step 'M2'"
    Localized shown_node(std::uint32_t node) const;
};

// Each fills in what it resolves and reports what it finds wrong.

/// Fills the tables of names; looks for names used twice and variables of one name.
void collect_names(const Checking& checking);
/// Joins macro-steps and expansions; finds the graph of every block.
void resolve_expansions(const Checking& checking);
/// The names that stand for conditions: what they read, and that none stands for itself.
void resolve_definitions(const Checking& checking);
void resolve_transitions(const Checking& checking);
/// Actions, orders, enclosures and the expressions in them.
void resolve_actions(const Checking& checking);
void check_enclosures(const Checking& checking);
void check_circles(const Checking& checking);

enum class ExpressionUse : std::uint8_t { transition, condition, event, value, assumption };
void resolve_expression(const Checking& checking, const DraftExpression& expression,
                        ExpressionUse use);
void resolve_sum(const Checking& checking, Range<> sum);

/// Names each of a list of steps; those that are none are reported, as are those named twice.
/// `accept` may report a step that does not belong in the list.
template <typename Accept>
void resolve_steps(const Checking& checking, Range<> list, const Accept& accept);
void report_repeated_steps(const Checking& checking, Range<> list);

/// What other readers than that of the text language might let through; of a draft without errors.
void check_parts(const Checking& checking);

// Bounds, and what is said by a reader or by the builder, whichever finds them broken first.

inline constexpr int deepest_nesting = 500;  ///< of expressions, in levels
inline constexpr std::int64_t largest_number = 1'000'000'000'000;
inline constexpr std::uint32_t longest_sum = 1'000'000;
Localized nested_too_deep_message();
Localized number_too_large_message(std::int64_t number);
Localized sum_too_long_message();
Localized encloses_twice_message(std::string_view step);
Localized outside_of_expansion_message(bool is_entry);

/// Warns of defined names and durations that nothing reads; of a draft without errors.
void warn_unread(const Checking& checking);

/// The model of a draft without errors.
Grafcet build_model(const Draft& draft);
/// The expression in a model whose steps and so on have the numbers given by `node_ids`;
/// `definition`: what a name of Draft::definitions stands for.
ExprId build_expression(const Draft& draft, const DraftExpression& expression,
                        const std::vector<std::uint32_t>& node_ids,
                        const std::vector<std::uint32_t>& graph_ids,
                        const std::function<ExprId(std::uint32_t)>& definition,
                        Expressions& expressions);

template <typename Accept>
void resolve_steps(const Checking& checking, Range<> list, const Accept& accept) {
    Draft& draft = checking.draft;
    for (const std::uint32_t i : list) {
        const std::string_view name = draft.text(draft.words[i]);
        const std::uint32_t* node = checking.names.nodes.find(name);
        if (node == nullptr) {
            checking.error(code::unknown_name, draft.words[i].where,
                           checking.suggestions.with_nearest(
                               messages::grafcet::unknown_step(checking.shown(draft.words[i])),
                               name, Meant::step));
        } else if (accept(*node, draft.words[i])) {
            draft.word_nodes[i] = *node;
        }
    }
    report_repeated_steps(checking, list);
}

}  // namespace grafwire
