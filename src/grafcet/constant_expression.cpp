// Which expressions are 0 whatever happens. Constants are folded through every expression first,
// each node once, operands before what uses them; a comparison is constant where the ranges of its
// counters decide it, an edge of a constant never comes. What is left is tried out where it is
// small: an expression over at most six different variables, edges, times and comparisons has a
// truth table of 64 rows, one bit of a word each. `↑e` can be 1 only where `e` is 1, `↓e` only
// where `e` is 0. Larger expressions are taken to be possible.

#include <algorithm>
#include <array>

#include "grafcet/warnings.h"

namespace grafwire {

namespace {

/// The values of six variables over the 64 rows, counted in binary.
constexpr std::array<std::uint64_t, 6> leaf_columns = {0xaaaaaaaaaaaaaaaaU, 0xccccccccccccccccU,
                                                       0xf0f0f0f0f0f0f0f0U, 0xff00ff00ff00ff00U,
                                                       0xffff0000ffff0000U, 0xffffffff00000000U};

/// The truth table of one expression over its leaves, as long as both are few.
class TruthTable {
  public:
    explicit TruthTable(const Expressions& expressions) : expressions_(expressions) {}

    bool is_complete() const { return is_complete_; }

    std::uint64_t column(ExprId id) {
        constexpr int most_nodes = 300;  // bounds the recursion, too
        if (++nodes_ > most_nodes) is_complete_ = false;
        if (!is_complete_) return 0;
        switch (expressions_.kind(id)) {
            case ExprKind::constant:
                return expressions_.constant_value(id) ? ~std::uint64_t{0} : 0;
            case ExprKind::negation:
                return ~column(expressions_.operands(id)[0]);
            case ExprKind::rise:
                return leaf(id) & column(expressions_.operands(id)[0]);
            case ExprKind::fall:
                return leaf(id) & ~column(expressions_.operands(id)[0]);
            case ExprKind::conjunction:
            case ExprKind::disjunction:
            case ExprKind::exclusive_or:
                return chain(id);
            default:
                return leaf(id);
        }
    }

  private:
    std::uint64_t chain(ExprId id) {
        const ExprKind kind = expressions_.kind(id);
        std::uint64_t result = kind == ExprKind::conjunction ? ~std::uint64_t{0} : 0;
        for (const ExprId operand : expressions_.operands(id)) {
            const std::uint64_t value = column(operand);
            if (!is_complete_) break;
            if (kind == ExprKind::conjunction) {
                result &= value;
            } else if (kind == ExprKind::disjunction) {
                result |= value;
            } else {
                result ^= value;
            }
        }
        return result;
    }

    /// The column of what is not looked into; a seventh different one ends the search.
    std::uint64_t leaf(ExprId id) {
        const auto end = leaves_.begin() + leaf_count_;
        const auto place = std::find(leaves_.begin(), end, id);
        if (place == leaves_.end()) {
            is_complete_ = false;
            return 0;
        }
        if (place == end) {
            *place = id;
            ++leaf_count_;
        }
        return leaf_columns[static_cast<std::size_t>(place - leaves_.begin())];
    }

    const Expressions& expressions_;
    std::array<ExprId, leaf_columns.size()> leaves_{};
    int leaf_count_ = 0;
    int nodes_ = 0;
    bool is_complete_ = true;
};

}  // namespace

ConstantExpressions::ConstantExpressions(const Grafcet& grafcet) : grafcet_(grafcet) {
    values_.reserve(grafcet.expressions.size());
    for (std::size_t i = 0; i < grafcet.expressions.size(); ++i) {
        values_.push_back(value_of(static_cast<ExprId>(i)));
    }
}

bool ConstantExpressions::is_never_true(ExprId id) const {
    if (values_[index_of(id)] != Logic::unknown) return values_[index_of(id)] == Logic::zero;
    TruthTable table(grafcet_.expressions);
    return table.column(id) == 0 && table.is_complete();
}

Logic ConstantExpressions::value_of(ExprId id) const {
    const Expressions& expressions = grafcet_.expressions;
    const auto value = [this](ExprId operand) { return values_[index_of(operand)]; };
    switch (expressions.kind(id)) {
        case ExprKind::constant:
            return logic_of(expressions.constant_value(id));
        case ExprKind::variable:
            return Logic::unknown;
        case ExprKind::negation:
            return ~value(expressions.operands(id)[0]);
        case ExprKind::rise:
        case ExprKind::fall:
            return value(expressions.operands(id)[0]) == Logic::unknown ? Logic::unknown
                                                                        : Logic::zero;
        case ExprKind::time_condition:
            return value(expressions.time_condition_of(id).operand) == Logic::zero ? Logic::zero
                                                                                   : Logic::unknown;
        case ExprKind::comparison:
            return value_of_comparison(expressions.comparison_of(id));
        default:
            return value_of_chain(id);
    }
}

Logic ConstantExpressions::value_of_comparison(const Comparison& comparison) const {
    // Of left - right, which the relation compares with 0.
    const IntegerRange left = value_range(grafcet_, comparison.left);
    const IntegerRange right = value_range(grafcet_, comparison.right);
    const std::int64_t low = left.low - right.high;
    const std::int64_t high = left.high - right.low;
    const auto decide = [](bool always, bool is_never) {
        return always ? Logic::one : is_never ? Logic::zero : Logic::unknown;
    };
    switch (comparison.relation) {
        case Relation::equal:
            return decide(low == 0 && high == 0, low > 0 || high < 0);
        case Relation::not_equal:
            return decide(low > 0 || high < 0, low == 0 && high == 0);
        case Relation::less:
            return decide(high < 0, low >= 0);
        case Relation::less_equal:
            return decide(high <= 0, low > 0);
        case Relation::greater:
            return decide(low > 0, high <= 0);
        case Relation::greater_equal:
            return decide(low >= 0, high < 0);
    }
    return Logic::unknown;
}

Logic ConstantExpressions::value_of_chain(ExprId id) const {
    const ExprKind kind = grafcet_.expressions.kind(id);
    Logic result = logic_of(kind == ExprKind::conjunction);
    for (const ExprId operand : grafcet_.expressions.operands(id)) {
        const Logic value = values_[index_of(operand)];
        if (kind == ExprKind::conjunction) {
            result = result & value;
        } else if (kind == ExprKind::disjunction) {
            result = result | value;
        } else {
            result = result ^ value;
        }
    }
    return result;
}

}  // namespace grafwire
