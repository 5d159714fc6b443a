#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "text/time.h"

namespace grafwire {

enum class ExprId : std::uint32_t {};
inline constexpr ExprId no_expr{0xffffffffU};

enum class ExprKind : std::uint8_t {
    constant,
    variable,
    negation,
    conjunction,
    disjunction,
    exclusive_or,
    rise,            ///< `↑e`
    fall,            ///< `↓e`
    time_condition,  ///< `t1/e/t2`
    comparison,      ///< `[sum relation sum]`
};

enum class VariableKind : std::uint8_t {
    input,    ///< index into Grafcet::inputs
    control,  ///< index is a ControlInput
    output,   ///< index into Grafcet::outputs; in expressions only stored outputs occur
    var,      ///< index into Grafcet::vars
    counter,  ///< index into Grafcet::counters; target of a write, never a Boolean operand
    step,     ///< the X variable of a step
    macro,    ///< the X variable of a macro-step
    graph,    ///< the X variable of a graph
};
inline constexpr std::size_t variable_kind_count = 8;

/// The inputs that every GRAFCET has without declaring them; the numbers are their order in ports
/// and traces.
enum class ControlInput : std::uint8_t { init, au_dur, au_doux };
inline constexpr std::size_t control_input_count = 3;

struct Variable {
    VariableKind kind = VariableKind::input;
    std::uint32_t index = 0;
    auto operator<=>(const Variable&) const = default;
};

enum class Relation : std::uint8_t { equal, not_equal, less, less_equal, greater, greater_equal };

inline constexpr std::array<Relation, 6> all_relations = {
    Relation::equal,      Relation::not_equal, Relation::less,
    Relation::less_equal, Relation::greater,   Relation::greater_equal};

/// A relation as the language of charts, IEC 61131-3 and Pascal write it.
constexpr std::string_view text_of(Relation relation) {
    constexpr std::string_view texts[] = {"=", "<>", "<", "<=", ">", ">="};
    return texts[static_cast<std::size_t>(relation)];
}

/// Whether `left relation right` is true. The sides are numbers, or anything in an order.
template <typename Number>
constexpr bool holds(const Number& left, Relation relation, const Number& right) {
    switch (relation) {
        case Relation::equal:
            return left == right;
        case Relation::not_equal:
            return left != right;
        case Relation::less:
            return left < right;
        case Relation::less_equal:
            return left <= right;
        case Relation::greater:
            return left > right;
        case Relation::greater_equal:
            return left >= right;
    }
    return false;
}

/// The relation that holds exactly where the given one does not.
constexpr Relation complement(Relation relation) {
    switch (relation) {
        case Relation::equal:
            return Relation::not_equal;
        case Relation::not_equal:
            return Relation::equal;
        case Relation::less:
            return Relation::greater_equal;
        case Relation::less_equal:
            return Relation::greater;
        case Relation::greater:
            return Relation::less_equal;
        case Relation::greater_equal:
            return Relation::less;
    }
    return relation;
}

/// The relation with its sides exchanged: `a < b` is `b > a`.
constexpr Relation mirrored(Relation relation) {
    switch (relation) {
        case Relation::less:
            return Relation::greater;
        case Relation::less_equal:
            return Relation::greater_equal;
        case Relation::greater:
            return Relation::less;
        case Relation::greater_equal:
            return Relation::less_equal;
        case Relation::equal:
        case Relation::not_equal:
            break;
    }
    return relation;
}

/// One signed term of a sum: a counter, or a whole number where `counter` is no_counter.
struct SumTerm {
    static constexpr std::uint32_t no_counter = 0xffffffffU;
    bool negative = false;
    std::uint32_t counter = no_counter;
    std::int64_t value = 0;  ///< not negative
    auto operator<=>(const SumTerm&) const = default;
};

/// The terms in the order written; never empty.
using Sum = std::vector<SumTerm>;

struct Comparison {
    Sum left;
    Relation relation = Relation::equal;
    Sum right;
    bool operator==(const Comparison&) const = default;
};

/// `on_delay/operand/off_delay`: 1 once the operand has been 1 for on_delay, 0 once it has been 0
/// for off_delay (at once where off_delay is 0).
struct TimeCondition {
    Time on_delay = 0;
    ExprId operand = no_expr;
    Time off_delay = 0;
    auto operator<=>(const TimeCondition&) const = default;
};

/// Boolean expressions over the variables of a GRAFCET, kept as a pool of shared nodes: building
/// the same expression twice gives the same id, so that one edge or one time condition written in
/// two places is one object with one memory. Nodes are stored as they were written; nothing is
/// simplified. Operands are always built before what uses them, hence have smaller ids.
class Expressions {
  public:
    ExprId constant(bool value);
    ExprId variable(Variable variable);
    ExprId negation(ExprId operand);
    /// The n-ary operators keep their operands in the order given and do not merge nested nodes.
    /// They expect at least two operands.
    ExprId conjunction(std::span<const ExprId> operands);
    ExprId disjunction(std::span<const ExprId> operands);
    ExprId exclusive_or(std::span<const ExprId> operands);
    ExprId rise(ExprId operand);
    ExprId fall(ExprId operand);
    ExprId time_condition(const TimeCondition& condition);
    ExprId comparison(const Comparison& comparison);

    /// Makes room for so many nodes, those among them that are no variables, and operands.
    void reserve(std::size_t nodes, std::size_t hashed, std::size_t operands);
    std::size_t size() const { return nodes_.size(); }
    /// Drops all nodes; costs no more than they did.
    void clear();
    ExprKind kind(ExprId id) const { return node(id).kind; }
    /// Expects a constant.
    bool constant_value(ExprId id) const { return node(id).detail != 0; }
    /// Expects a variable.
    Variable variable_of(ExprId id) const {
        return {static_cast<VariableKind>(node(id).detail), node(id).first};
    }
    /// The operands of a negation, n-ary operator or edge; empty for all other kinds (the operand
    /// of a time condition is reached through time_condition_of).
    std::span<const ExprId> operands(ExprId id) const {
        if (node(id).count == 0) return {};
        return {operands_.data() + node(id).first, node(id).count};
    }
    const TimeCondition& time_condition_of(ExprId id) const { return times_[node(id).first]; }
    const Comparison& comparison_of(ExprId id) const { return comparisons_[node(id).first]; }

    /// All edges (`rise` and `fall` nodes), inner ones before those that contain them.
    const std::vector<ExprId>& edges() const { return edges_; }
    /// All time conditions, inner ones before those that contain them. Their place in this list is
    /// the number under which the evolution, the netlist and the check speak of the same condition.
    const std::vector<ExprId>& time_conditions() const { return time_condition_ids_; }
    /// The place of an edge in edges(), or of a time condition in time_conditions().
    std::size_t ordinal(ExprId id) const;

  private:
    struct Node {
        ExprKind kind = ExprKind::constant;
        std::uint8_t detail = 0;  ///< the value of a constant, the VariableKind of a variable
        /// The index of a variable, the place of a time condition or comparison in its list, else
        /// that of the first operand in operands_.
        std::uint32_t first = 0;
        std::uint32_t count = 0;  ///< of operands in operands_
    };
    const Node& node(ExprId id) const { return nodes_[static_cast<std::size_t>(id)]; }
    /// The node that `same` recognises among those with this hash, or no_expr.
    template <typename Same>
    ExprId find(std::uint64_t hash, const Same& same) const;
    ExprId add(const Node& new_node, std::uint64_t hash);
    ExprId with_operands(ExprKind kind, std::span<const ExprId> operands);

    std::vector<Node> nodes_;
    std::vector<ExprId> operands_;
    std::vector<TimeCondition> times_;
    std::vector<Comparison> comparisons_;
    std::vector<ExprId> edges_;
    std::vector<ExprId> time_condition_ids_;
    /// Open addressing with linear probing; the size is a power of two, at most half of it used.
    struct Slot {
        std::uint32_t hash = 0;
        ExprId id = no_expr;  ///< no_expr: free
    };
    std::vector<Slot> slots_;
    std::size_t hashed_ = 0;  ///< slots in use
    void insert(const Slot& slot);
    void grow(std::size_t slots);
    /// Variables are not hashed: per kind, their ids by index (no_expr: none yet).
    std::array<std::vector<ExprId>, variable_kind_count> variables_;
};

}  // namespace grafwire
