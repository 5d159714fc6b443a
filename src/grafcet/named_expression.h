#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "grafcet/expression.h"
#include "text/location.h"

namespace grafwire {

// What a reader of charts says of an expression: the variables are names, which GrafcetBuilder
// looks up once the whole chart is known.

/// A name and where it stands. The text is copied by the call of GrafcetBuilder that takes it.
struct Name {
    std::string_view text;
    Location where;
};

/// A term of a sum: a counter, or a whole number.
struct NamedTerm {
    bool negative = false;
    std::optional<Name> counter;
    std::int64_t number = 0;  ///< without a counter
    Location where = {};      ///< of a number
};
using NamedSum = std::vector<NamedTerm>;

/// A Boolean expression in postfix order, the order in which a parser finishes its parts: operands
/// stand before their operator. `a . /b` is made by
///
///     expression.variable({"a"}).variable({"b"}).join(ExprKind::negation, 1)
///               .join(ExprKind::conjunction, 2);
class NamedExpression {
  public:
    NamedExpression& constant(bool value, Location where = {}) {
        return add({ExprKind::constant, value ? 1U : 0U, {{}, where}}, 0);
    }
    NamedExpression& variable(Name name) { return add({ExprKind::variable, 0, name}, 0); }
    NamedExpression& comparison(NamedSum left, Relation relation, NamedSum right,
                                Location where = {}) {
        comparisons_.push_back({std::move(left), relation, std::move(right)});
        const auto place = static_cast<std::uint32_t>(comparisons_.size() - 1);
        return add({ExprKind::comparison, place, {{}, where}}, 0);
    }
    /// Makes one expression of the last ones: a negation or an edge of one, a conjunction,
    /// disjunction or exclusive or of two or more.
    NamedExpression& join(ExprKind kind, std::uint32_t operands, Location where = {}) {
        assert(kind == ExprKind::negation || kind == ExprKind::rise || kind == ExprKind::fall
                   ? operands == 1
                   : operands >= 2);
        return add({kind, operands, {{}, where}}, operands);
    }
    /// `on_delay/operand/off_delay` of the last expression.
    NamedExpression& time_condition(Time on_delay, Time off_delay, Location where = {}) {
        times_.push_back({on_delay, no_expr, off_delay});
        const auto place = static_cast<std::uint32_t>(times_.size() - 1);
        return add({ExprKind::time_condition, place, {{}, where}}, 1);
    }

    /// Without anything: there is no expression.
    bool is_empty() const { return nodes_.empty(); }
    /// Whether everything has been joined into one expression.
    bool is_whole() const { return open_ == 1; }
    void clear() {
        nodes_.clear();
        times_.clear();
        comparisons_.clear();
        open_ = 0;
    }

    struct Node {
        ExprKind kind = ExprKind::constant;
        /// Of a constant its value; of a time condition or a comparison its place in times() or
        /// comparisons(); of the other operators the number of operands.
        std::uint32_t value = 0;
        Name name;  ///< of a variable; else only the place
    };
    struct NamedComparison {
        NamedSum left;
        Relation relation = Relation::equal;
        NamedSum right;
    };
    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<TimeCondition>& times() const { return times_; }  ///< without operands
    const std::vector<NamedComparison>& comparisons() const { return comparisons_; }

  private:
    NamedExpression& add(Node node, std::size_t operands) {
        assert(open_ >= operands);
        open_ -= operands;
        ++open_;
        nodes_.push_back(node);
        return *this;
    }

    std::vector<Node> nodes_;
    std::vector<TimeCondition> times_;
    std::vector<NamedComparison> comparisons_;
    std::size_t open_ = 0;  ///< expressions that nothing has joined yet
};

}  // namespace grafwire
